return {
  id = "first", title = "First Light", palette = "art/palette.png", font = "art/font.png",
  sheets = { bullets = { file = "art/bullets.png", bank = 0 }, heron = { file = "art/heron.png", bank = 8 },
             enemies = { file = "art/enemies.png", bank = 10 } },
  sprites = {
    ship  = { sheet = "heron",   x = 0,  y = 0,  w = 28, h = 36, frames = 4, every = 3, origin = { 14, 17 } },
    jelly = { sheet = "enemies", x = 0,  y = 32, w = 36, h = 44, frames = 4, every = 9, origin = { 18, 17 } },
    orb   = { sheet = "bullets", x = 16, y = 0,  w = 12, h = 12 },
    dart  = { sheet = "bullets", x = 64, y = 0,  w = 14, h = 14, rotations = 32 } } }

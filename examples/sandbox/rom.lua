-- rom.lua - the sandbox: a bare game for trying the examples of docs/manual.md. Put one into try.lua.
return {
  title = "Sandbox", author = "The Curtain authors",
  board = { values = { bullet = 4, shot = 4, enemy = 4 }, hp = true, around = true, frozen = true, -- room for all that
    lasers = 64, curve_points = 4096 },                                                          -- the chapters show
  palette = "art/palette.png", font = "art/font.png",
  blends = { glow = "add", ghost = { mix = 50 } },
  sheets = {
    glow    = { file = "art/glow.png",    bank = 0 },
    bullets = { file = "art/bullets.png", bank = 0 },
    shots   = { file = "art/shots.png",   bank = 0 },
    sparks  = { file = "art/sparks.png",  bank = 0 },
    heron   = { file = "art/heron.png",   bank = 8 },
    enemies = { file = "art/enemies.png", bank = 10 },
    queen   = { file = "art/queen.png",   bank = 12 },
  },
  sprites = {
    orb   = { sheet = "bullets", x = 16,  y = 0,   w = 12, h = 12 },
    rice  = { sheet = "bullets", x = 48,  y = 0,   w = 12, h = 12, rotations = 32, sizes = { 50, 150, 200 } },
    star  = { sheet = "bullets", x = 0,   y = 16,  w = 16, h = 16, frames = 4, every = 4, sizes = { 50, 150, 300 } },
    big   = { sheet = "bullets", x = 0,   y = 32,  w = 24, h = 24 },
    dart  = { sheet = "shots",   x = 0,   y = 0,   w = 16, h = 16, rotations = 32 },
    glint = { sheet = "sparks",  x = 0,   y = 0,   w = 12, h = 12, frames = 4, every = 4 },
    halo  = { sheet = "sparks",  x = 0,   y = 16,  w = 48, h = 48, frames = 4, every = 5 },
    lamp  = { sheet = "glow",    x = 0,   y = 0,   w = 128, h = 128 },
    ray   = { sheet = "glow",    x = 128, y = 32,  w = 1,   h = 16 },
    shine = { sheet = "glow",    x = 132, y = 32,  w = 4,   h = 24 },
    scale = { sheet = "glow",    x = 136, y = 32,  w = 16,  h = 12 },
    ember = { sheet = "glow",    x = 128, y = 0,   w = 24, h = 24 },
    ship  = { sheet = "heron",   x = 0,   y = 0,   w = 28, h = 36, frames = 4, every = 3, origin = { 14, 17 } },
    wisp  = { sheet = "enemies", x = 0,   y = 0,   w = 20, h = 22, frames = 4, every = 5 },
    jelly = { sheet = "enemies", x = 0,   y = 32,  w = 36, h = 44, frames = 4, every = 9, origin = { 18, 17 } },
    queen = { sheet = "queen",   x = 0,   y = 0,   w = 96, h = 96, frames = 4, every = 10, origin = { 48, 44 } },
  },
  difficulties = { "easy", "normal", "hard" }, difficulty = "normal",
  dip = { coins = { "free", "one" }, pace = { min = 1, max = 5, default = 3 } },
  players = 2, extends = { 100000, 300000 },
}

return {
  id = "moth", title = "Lamplight", palette = "art/palette.png", font = "art/font.png",
  sheets = {
    bullets = { file = "art/bullets.png", bank = 0 },
    heron   = { file = "art/heron.png", bank = 8 },
    moth    = { file = "art/moth.ase", bank = 11, match = "index" }, -- shades are indices in its palette
  },
  sprites = {
    ship = { sheet = "heron",   x = 0,  y = 0, w = 28, h = 36, frames = 4, every = 3, origin = { 14, 17 } },
    orb  = { sheet = "bullets", x = 16, y = 0, w = 12, h = 12 },
    dart = { sheet = "bullets", x = 64, y = 0, w = 14, h = 14, rotations = 32 },
    moth      = { sheet = "moth", tag = "fly", sizes = { 200 } }, -- the rest comes from the file
    moth_hurt = { sheet = "moth", tag = "hurt" },
  },
}

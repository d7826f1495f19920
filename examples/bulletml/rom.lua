-- rom.lua - the manifest of the viewer: docs/reference/rom.md and docs/guide/32-bulletml.md.
return {
  id = "gallery", title = "Gallery", author = "You", version = 1,
  board = { bullets = 16384, bulletml = 8192, shots = 16, enemies = 16, sparks = 512, sprites = 16, tasks = 64,
            lua_kib = 2048 },
  dip = { document = { min = 1, max = 1024, default = 1 }, rank = { min = 0, max = 100, default = 50 },
          seed = { min = 1, max = 9999, default = 1 }, speed = { min = 10, max = 400, default = 100 } },
  palette = "art/palette.png", font = "art/font.png",
  sheets = {
    bullets = { file = "art/bullets.png", bank = 0 }, sparks = { file = "art/sparks.png", bank = 0 },
    kite    = { file = "art/kite.png",    bank = 8 },
  },
  sprites = {
    pellet = { sheet = "bullets", x = 0,   y = 0,  w = 8,  h = 8 },
    orb    = { sheet = "bullets", x = 16,  y = 0,  w = 12, h = 12 },
    ring   = { sheet = "bullets", x = 32,  y = 0,  w = 16, h = 16 },
    rice   = { sheet = "bullets", x = 48,  y = 0,  w = 12, h = 12, rotations = 32 },
    kunai  = { sheet = "bullets", x = 64,  y = 0,  w = 14, h = 14, rotations = 32 },
    drop   = { sheet = "bullets", x = 80,  y = 0,  w = 14, h = 14, rotations = 32 },
    shard  = { sheet = "bullets", x = 96,  y = 0,  w = 14, h = 14, rotations = 32 },
    petal  = { sheet = "bullets", x = 112, y = 0,  w = 14, h = 14, rotations = 32 },
    star   = { sheet = "bullets", x = 0,   y = 16, w = 16, h = 16, frames = 4, every = 4 },
    needle = { sheet = "bullets", x = 64,  y = 16, w = 16, h = 16, rotations = 32 },
    big    = { sheet = "bullets", x = 0,   y = 32, w = 24, h = 24 },
    pearl  = { sheet = "bullets", x = 64,  y = 32, w = 18, h = 18 },
    hoop   = { sheet = "sparks",  x = 80,  y = 0,  w = 12, h = 12, frames = 4, every = 3 },
    kite   = { sheet = "kite",    x = 0,   y = 0,  w = 28, h = 36, frames = 4, every = 5, origin = { 14, 19 } },
  },
}

-- rom.lua - documents: a game that never changes, of BulletML documents alone. See tests/demos/README.md.
return {
  id = "documents", title = "Documents", author = "The Curtain authors", version = 1,
  screen = { w = 240, h = 240 }, field = { x = 0, y = 0, w = 240, h = 240, margin = 32 },
  board = { bullets = 2048, shots = 64, enemies = 16, sparks = 32, sprites = 8, motions = 0, tasks = 64,
            frozen = true, bulletml = 160 }, -- so few that runners run out
  sheets = { all = { file = "art/all.png" } },
  sprites = { dot = { sheet = "all", x = 0, y = 0, w = 8, h = 8 },
              dart = { sheet = "all", x = 0, y = 0, w = 8, h = 4, rotations = 8 } },
}

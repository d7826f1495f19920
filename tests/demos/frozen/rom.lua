-- rom.lua - frozen: a game that never changes, so that what was recorded on it stays true. See tests/demos/README.md.
return {
  id = "frozen", title = "Frozen", author = "The Curtain authors", version = 1,
  screen = { w = 64, h = 64 }, field = { x = 0, y = 0, w = 64, h = 64, margin = 16 },
  board = { bullets = 128, shots = 16, enemies = 8, sparks = 32, sprites = 8, motions = 16, tasks = 64, lua_kib = 1024 },
  sheets = { all = { file = "art/all.png" } },
  sprites = { dot = { sheet = "all", x = 0, y = 0, w = 8, h = 8 }, dart = { sheet = "all", x = 0, y = 0, w = 8, h = 4, rotations = 8 } },
  difficulties = { "easy", "hard" }, difficulty = "hard",
  dip = { coins = { "free", "one" }, ships = { min = 1, max = 9 } },
  players = 2,
}

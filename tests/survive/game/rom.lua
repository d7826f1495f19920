-- rom.lua - the planted sets of bullets: tests/cli/survive.sh makes its art.
return {
  id = "planted", title = "Planted sets", screen = { w = 96, h = 128 },
  board = { bullets = 1024, shots = 16, enemies = 32, sparks = 16, sprites = 16, motions = 16, tasks = 128,
            lua_kib = 1024, lasers = 16, bodies = true },
  difficulties = { "easy", "hard" }, difficulty = "easy",
  sheets = { all = { file = "art/all.png" } },
  sprites = { dot = { sheet = "all", x = 0, y = 0, w = 6, h = 6 },
              line = { sheet = "all", x = 0, y = 0, w = 1, h = 8 } },
}

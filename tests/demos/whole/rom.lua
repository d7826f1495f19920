-- rom.lua - whole: a small game with all of the shell and the standard library; what demos.sh --freeze packs.
return {
  id = "whole", title = "Whole", author = "The Curtain authors", version = 1,
  screen = { w = 160, h = 160 }, field = { x = 8, y = 16, w = 144, h = 136, margin = 16 },
  board = { bullets = 512, shots = 64, enemies = 16, sparks = 160, sprites = 16, motions = 32, tasks = 128, lua_kib = 1024, nvram = 8,
    values = { bullet = 1, shot = 1, enemy = 1 }, hp = true, around = true, frozen = true,
    meet = true, wide = true, items = 64, lasers = 120, curve_points = 4096, lines = 8,
    options = 8, registers = 32, bodies = true, pierce = true },
  sheets = { all = { file = "art/all.png" } },
  sprites = { dot = { sheet = "all", x = 0, y = 0, w = 8, h = 8 }, dart = { sheet = "all", x = 0, y = 0, w = 8, h = 4, rotations = 8 } },
  maps = { ground = { tiles = "art/all.png", size = 8, bank = 0, rows = { { 1, 0, 2 }, { 2, 1, 0 } } } },
  difficulties = { "easy", "hard" }, difficulty = "hard", extends = { 2000, 9000 },
  dip = { coins = { "free", "one" }, ships = { min = 1, max = 9 } },
  players = 2,
}

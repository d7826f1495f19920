-- rom.lua - torture: a game for tests. It calls every function of the API, runs every key of a motion step, and keeps
-- every pool near its small capacity. tests/machine/test_uses.c counts them. The art is the test card's.
return {
  id = "torture", title = "Torture", author = "The Curtain authors", version = 1, entry = "main",
  screen = { w = 320, h = 240 },
  field = { x = 16, y = 8, w = 224, h = 224, margin = 32, view = { w = 160, h = 200 } },
  board = { bullets = 200, shots = 40, enemies = 32, sparks = 96, sprites = 24, motions = 24, tasks = 100, lua_kib = 1472,
            values = { bullet = 2, shot = 1, enemy = 1 }, hp = true, around = true, frozen = true,
            meet = true, items = 48,
            lines = 10, wide = true, lasers = 12, curve_points = 128, options = 5, registers = 8, bodies = true,
            pierce = true, transforms = true },
  fonts = { grid = { file = "art/font.png", cell = { 8, 8 }, chars = " !\"#$%&'()*+,-./0123456789", also = "é" } },
  blends = { alpha = { mix = 50 }, mist = { mix = 40 } },
  sounds = {
    hit = { mml = "t200 @noise E0,60,0,10 o6 c8", limit = 1 },
    shot = { mml = "t240 @pulse E0,20,0,5 o6 v9 {c<c}32", priority = 0 },
    knock = { mml = "t300 @sine E0,40,0,5 o3 [c16 r16]4", limit = 4, priority = 7 },
  },
  music = { round = { file = "music/round.mml" }, short = { file = "music/short.mml", volume = 0.5 } },
  maps = {
    tiled = { tiles = "art/card.png", rows = { { 1, 2, 0 }, { 3, 4, 1 } } },
    whole = { tiles = "art/card.png", size = 8, rows = { { 9, 10 } } },
  },
  palette = "art/palette.png", font = "art/font.png",
  sheets = { card = { file = "art/card.png", bank = 0 } },
  sprites = {
    letter = { sheet = "card", x = 0,  y = 0, w = 16, h = 16 },
    arrow  = { sheet = "card", x = 16, y = 0, w = 24, h = 24, rotations = 16 },
    box    = { sheet = "card", x = 48, y = 0, w = 16, h = 16, origin = { 3, 5 } },
    steps  = { sheet = "card", x = 64, y = 0, w = 8,  h = 8, frames = 8, every = 4 },
  },
  difficulties = { "soft", "hard" }, difficulty = "hard",
  dip = { coins = { "free", "one" } },
  players = 2, extends = { 4000, 9000, 20000 },
}

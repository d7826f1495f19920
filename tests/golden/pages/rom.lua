-- rom.lua - a game that shows every page of the library (tests/golden/sheets.sh). The script copies palette and font
-- from an example and replaces the sizes.
return {
  id = "pages", title = "Paper Boats", screen = { w = 240, h = 320 }, field = { w = 240, h = 320 }, players = 2,
  board = { bullets = 256, shots = 256, enemies = 16, sparks = 64, sprites = 64, motions = 16, tasks = 128,
            lua_kib = 2048, lines = 32, wide = true, bodies = true },
  palette = "art/palette.png", font = "art/font.png", fonts = { kana = { file = "art/kana.bdf", shadow = true } },
  sheets = {
    bullets = { file = "art/bullets.png", bank = 0 }, shots = { file = "art/shots.png", bank = 0 },
    kite    = { file = "art/kite.png", bank = 8 },    keeper = { file = "art/keeper.png", bank = 12 },
  },
  sprites = {
    orb    = { sheet = "bullets", x = 16, y = 0, w = 12, h = 12 },
    dart   = { sheet = "shots", x = 0, y = 0, w = 16, h = 16, rotations = 32 },
    kite   = { sheet = "kite", x = 0, y = 0, w = 28, h = 36, frames = 4, every = 5, origin = { 14, 19 } },
    keeper = { sheet = "keeper", x = 0, y = 0, w = 112, h = 96, frames = 4, every = 9 },
  },
  difficulties = { "easy", "normal", "hard" }, difficulty = "normal",
  music = { river = { file = "music/river.mml", title = "Down the River" },
            rain  = { file = "music/rain.mml", title = "Rain on Paper" } },
}

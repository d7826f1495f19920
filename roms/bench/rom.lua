-- rom.lua - the bench: a steady crowd of bullets through the same tick and draw as any game. DIP n: how many; DIP does:
-- what each of them does, see prices.lua.
return {
  title = "Bench", author = "The Curtain authors", version = 1, entry = "main",
  screen = { w = 320, h = 240 }, field = { x = 0, y = 0, w = 320, h = 240, margin = 32 },
  board = { bullets = 1048576, shots = 0, enemies = 0, sparks = 0, sprites = 0, motions = 8, tasks = 4112, lua_kib = 16384 },
  palette = "art/palette.png", font = "art/font.png",
  sheets = { discs = { file = "art/discs.png", bank = 0 } },
  sprites = {
    d8  = { sheet = "discs", x = 0,  y = 0, w = 8,  h = 8 },
    d12 = { sheet = "discs", x = 8,  y = 0, w = 12, h = 12 },
    d16 = { sheet = "discs", x = 20, y = 0, w = 16, h = 16 },
    d24 = { sheet = "discs", x = 36, y = 0, w = 24, h = 24 },
  },
  dip = { n = { min = 1, max = 1048576, default = 16384 }, mix = { "four", "small" }, log = { "off", "on" },
    does = { "shuttle", "straight", "drive", "home", "fine", "fine_drive", "group", "each", "task", "fire" } },
  players = 1,
}

-- rom.lua - one document many times over, for taking times: packed as tools/lab/bulletml/game is.
return {
  id = "crowd", title = "Crowd", author = "The Curtain authors", version = 1, entry = "main",
  screen = { w = 320, h = 240 }, field = { x = 0, y = 0, w = 320, h = 240, margin = 1024 },
  board = { bullets = 262144, bulletml = 65536, shots = 0, enemies = 0, sparks = 0, sprites = 0, motions = 0,
            tasks = 16,
            lua_kib = 16384 },
  palette = "art/palette.png", font = "art/font.png",
  sheets = { discs = { file = "art/discs.png", bank = 0 } },
  sprites = { dot = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 } },
}

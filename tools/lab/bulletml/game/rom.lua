-- rom.lua - a document beside libbulletml: board.c packs this with document.xml as bulletml/document.xml, with what it
-- is run with as run.lua, and with the art of roms/bench.
return {
  id = "bulletml", title = "BulletML", author = "The Curtain authors", version = 1, entry = "main",
  screen = { w = 320, h = 240 }, field = { x = 0, y = 0, w = 320, h = 240, margin = 256 },
  board = { bullets = 20000, bulletml = 24000, shots = 0, enemies = 0, sparks = 0, sprites = 0, motions = 0, tasks = 16,
            lua_kib = 16384, values = { bullet = 2 } },
  palette = "art/palette.png", font = "art/font.png",
  sheets = { discs = { file = "art/discs.png", bank = 0 } },
  sprites = { dot = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 } },
}

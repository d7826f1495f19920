return {
  id = "keys", title = "Keys", screen = { w = 64, h = 64 }, board = { bullets = 512, lua_kib = 1024 },
  sheets = { dot = { file = "art/dot.png" } }, sprites = { dot = { sheet = "dot", x = 0, y = 0, w = 4, h = 4 } },
}

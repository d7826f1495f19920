-- rom.lua - the bench: steady scenes through the same tick and draw as any game. DIP does selects the scene, which is in the
-- file of that name (shuttle: main.lua); DIP n is the number of bullets, or of enemies in the battle.
return {
  id = "bench", title = "Bench", author = "The Curtain authors", version = 1, entry = "main",
  screen = { w = 320, h = 240 }, field = { x = 0, y = 0, w = 320, h = 240, margin = 32 },
  board = { bullets = 1048576, shots = 512, enemies = 256, sparks = 0, sprites = 4096, motions = 96, tasks = 4112, lua_kib = 16384,
            items = 512, lasers = 64, curve_points = 4096 },
  palette = "art/palette.png", font = "art/font.png", blends = { glow = "add", shine = { ramp = "add" } },
  sheets = { discs = { file = "art/discs.png", bank = 0 } },
  sprites = {
    d8  = { sheet = "discs", x = 0,  y = 0, w = 8,  h = 8 },
    d12 = { sheet = "discs", x = 8,  y = 0, w = 12, h = 12 },
    d16 = { sheet = "discs", x = 20, y = 0, w = 16, h = 16 },
    ray = { sheet = "discs", x = 28, y = 0, w = 1,  h = 16 },
    d24 = { sheet = "discs", x = 36, y = 0, w = 24, h = 24 },
    -- for the boss fight
    turn8  = { sheet = "discs", x = 0,  y = 0, w = 8,  h = 8,  rotations = 32 },
    turn12 = { sheet = "discs", x = 8,  y = 0, w = 12, h = 12, rotations = 32 },
    turn16 = { sheet = "discs", x = 20, y = 0, w = 16, h = 16, rotations = 32 },
    -- the crowd's kinds; `make bench` gives each its own picture
    kind1 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 }, kind2 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 },
    kind3 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 }, kind4 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 },
    kind5 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 }, kind6 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 },
    kind7 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 }, kind8 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 },
    kind9 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 }, kind10 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 },
    kind11 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 }, kind12 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 },
    kind13 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 }, kind14 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 },
    kind15 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 }, kind16 = { sheet = "discs", x = 0, y = 0, w = 8, h = 8 },
  },
  maps = { -- for the scene `together`; `make bench` gives other scenes no backgrounds
    sea    = { tiles = "art/tiles.png", bank = 13, rows = { { 1, 2, 3, 4 } } },
    slabs  = { tiles = "art/tiles.png", bank = 13, rows = { { 5, 6, 7, 6 }, { 7, 8, 5, 6 }, { 6, 5, 8, 7 }, { 8, 7, 6, 5 } } },
    clouds = { tiles = "art/tiles.png", bank = 13, rows = {
      { 9, 10, 11, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 12, 0 }, { 0, 0, 9, 10, 11, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0 } } },
  },
  dip = { n = { min = 0, max = 65535, default = 16384 }, n_high = { min = 0, max = 64 }, -- adds 65536 each
    mix = { "four", "small" }, log = { "off", "on" },
    does = { "shuttle", "crowd", "creep", "battle", "pictures", "prices", "items", "lasers", "together", "looks", "boss" },
    price = { "straight", "accel", "turn", "drive", "aim", "home", "mixed", "half", "fine", "fine_drive", "group", "each", "task",
      "fire" },
    -- continues price: a switch can have 16 words
    price_figure = { "none", "ring", "fan", "arc", "stack", "line", "polygon", "star", "ellipse", "rose", "whip", "scatter",
      "points", "dots" },
    price_kind = { "none", "circle", "box", "capsule", "circles", "turned_circles", "frozen", "delay", "hp", "valued",
      "kept" },
    price_step = { "none", "go_to", "polar", "orbit", "around", "wave", "bounce", "named", "await", "signal", "path",
      "emit" },
    price_verb = { "none", "shift", "aim_all", "turn_all", "value", "clear_circle", "clear_box", "clear_line", "sweep", "near",
      "near_box", "near_line", "found" },
    price_look = { "none", "dots", "sparks_fly", "sparks_burst", "sparks_ring", "sparks_row", "trails", "stand", "follow" },
    price_part = { "none", "everything", "only_bullets", "only_lasers", "only_items", "only_sparks", "only_scenery", "nothing",
      "no_lasers", "no_items", "no_sparks", "no_scenery" },
    picture = { "plain", "banks", "turned", "clipped", "sprite", "flipped", "blended", "blended_banks", "ramp",
      "sprite_turned", "sprite_scaled", "alpha", "scaled", "scaled_turned" } },
  players = 1,
}

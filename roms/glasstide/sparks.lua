-- sparks.lua - kinds of sparks, and what explosions are made of, by size (fx.def): fire and light, glass in the colours
-- of the stage, and bubbles.
local FIRE <const>, COLD <const>, PALE <const>, GOLD <const>, GREEN <const> = 0, 5, 0, 3, 4

-- A spark that plays its frames once has a lifetime of frames * every.
-- All sparks are drawn below the bullets, and none has the colour of bullets near it.
local function under(name, def)
  def.layer = "middle"
  spark.def(name, def)
end

under("glint",  { sprite = "glint", life = 16, drag = 0.06 })
under("ping",   { sprite = "glint", life = 12, drag = 0.10, bank = GREEN })
under("crumb",  { sprite = "crumb", life = 26, drag = 0.04, gravity = 0.03, bank = COLD })
under("splint", { sprite = "crumb", life = 16, drag = 0.05, gravity = 0.05, bank = PALE,
                  blend = "ghost" })
under("fizz",   { sprite = "fizz",  life = 44, drag = 0.03, gravity = -0.04, bank = COLD })
under("pop",    { sprite = "hoop",  life = 12, bank = COLD })
under("shock",  { sprite = "shock", life = 16, bank = COLD })

-- Fire and light are additive, so bullets show through.
local function light(name, sprite, bank, life, drag)
  spark.def(name, { sprite = sprite, bank = bank, life = life, drag = drag or 0, blend = "glow",
                    layer = "middle" })
end

light("fire_a",  "fire_a",  FIRE, 30, 0.08)
light("fire_b",  "fire_b",  FIRE, 30, 0.08)
light("fire_c",  "fire_c",  FIRE, 40, 0.08)
light("fire_d",  "fire_d",  FIRE, 40, 0.08)
light("fire_e",  "fire_e",  FIRE, 56)
light("flare",   "flare",   GOLD, 18)
light("star",    "flare",   PALE, 18)
light("ripple",  "ripple",  COLD, 24)
light("breaker", "breaker", COLD, 32)
light("dawn",    "breaker", GOLD, 32)
light("shine",   "shine",   COLD, 12)
light("swell",   "swell",   COLD, 24)
light("muzzle",  "muzzle",  GREEN, 5)
light("spit",    "spit",    PALE, 8)

-- Glass in the stage's colours tumbles down; bubbles rise.
local function debris(name, life, def)
  def.sprite, def.life, def.layer = name, life, "middle"
  spark.def(name, def)
end

debris("sherd_s", 22, { drag = 0.035, gravity = 0.045 })
debris("sherd_m", 30, { drag = 0.030, gravity = 0.050 })
debris("sherd_l", 60, { drag = 0.030, gravity = 0.040 })
debris("bubbles", 40, { drag = 0.045, gravity = -0.055 })

local function burst(kind, n, speed, radius)
  return { kind = kind, n = n, speed = speed, radius = radius }
end

-- A shot's hit: light, and splinters that fly back at the craft.
fx.def("hit", { sparks = { burst("spit"),
  { kind = "splint", n = 2, dir = 90, spread = 140, speed = 3.5 } } })

-- Creatures of 20 to 32 px; of up to 64 px; as large as a quarter of the field.
fx.def("small", { sparks = { burst("star"), burst { "fire_a", "fire_b" }, burst("sherd_s", 6, 3),
  burst("bubbles", 1, 0.8) } })
fx.def("large", { sound = "crash", shake = 3, stop = 2, chain = 3, chain_radius = 20,
  sparks = { burst("star"), burst { "fire_c", "fire_d" }, burst("ripple"), burst("sherd_s", 9, 4),
             burst("sherd_m", 6, 2.6), burst("bubbles", 3, 1.2) } })
fx.def("huge", { sound = "collapse", shake = 5, flash = 0.35, flash_to = 0xfff2d8, stop = 4,
  chain = 8, chain_radius = 44,
  sparks = { burst("flare"), burst("fire_e"), burst({ "fire_c", "fire_d" }, 5, 1.6, 22),
             burst("swell"), burst("breaker"), burst("sherd_m", 12, 4), burst("sherd_l", 8, 2.8),
             burst("bubbles", 6, 1.6) } })

-- The loss of a craft.
fx.def("lost", { shake = 5, flash = 0.4, stop = 6, sparks = { burst("flare"), burst("fire_e"),
  burst("swell"), burst("breaker"), burst("glint", 24, 4), burst("sherd_m", 8, 3.5) } })

-- The end of a boss: cracks, and the burst into light, rings, and glass that sinks slowly.
fx.def("crack", { sound = "crash", sparks = { burst { "fire_a", "fire_c", "fire_b", "fire_d" },
  burst("sherd_m", 2, 1.8), burst { "star", "ripple" } } })
fx.def("pieces", { sparks = { burst { "fire_c", "fire_d" }, burst("sherd_l", 3, 2),
  burst("bubbles", 3, 1.4), burst { "breaker", "dawn", "ripple" } } })
fx.def("end", { sound = "burst", shake = 8, flash = 0.7, stop = 4, chain = 10, chain_size = "pieces",
  chain_radius = 52,
  sparks = { burst("flare"), burst("fire_e", 5, 1.1, 40), burst({ "fire_c", "fire_d" }, 8, 2.6, 30),
             burst("swell"), burst("dawn"), burst("sherd_l", 14, 3.6), burst("sherd_m", 15, 5),
             burst("glint", 40, 6) } })

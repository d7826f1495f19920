-- kinds.lua - bullets, sparks, and the creatures of the tide with what they leave behind.

bullet.def("pellet", { sprite = "pellet", hit = { circle = 2 } })
bullet.def("orb",    { sprite = "orb",    hit = { circle = 3.5 } })
bullet.def("ring",   { sprite = "ring",   hit = { circle = 5 } })
bullet.def("rice",   { sprite = "rice",   hit = { circle = 2 },   turns = true })
bullet.def("kunai",  { sprite = "kunai",  hit = { circle = 2.5 }, turns = true })
bullet.def("drop",   { sprite = "drop",   hit = { circle = 2.5 }, turns = true })
bullet.def("shard",  { sprite = "shard",  hit = { circle = 2 },   turns = true })
bullet.def("petal",  { sprite = "petal",  hit = { circle = 2.5 }, turns = true })
bullet.def("star",   { sprite = "star",   hit = { circle = 4 } })
bullet.def("needle", { sprite = "needle", hit = { circle = 2 },   turns = true })
bullet.def("pearl",  { sprite = "pearl",  hit = { circle = 6 } })
bullet.def("big",    { sprite = "big",    hit = { circle = 8 } })
bullet.def("bubble", { sprite = "bubble", hit = { circle = 9 } })
bullet.def("marble", { sprite = "marble", hit = { circle = 12 } })

-- A spark that plays its frames once lives frames * every.
local GOLD, BLUE = 3, 5

spark.def("glint",  { sprite = "glint", life = 16, drag = 0.06 })
spark.def("ping",   { sprite = "glint", life = 16, drag = 0.10, bank = GOLD })
spark.def("crumb",  { sprite = "crumb", life = 40, drag = 0.04, gravity = 0.03, bank = BLUE })
spark.def("splint", { sprite = "crumb", life = 28, drag = 0.05, gravity = 0.05, bank = GOLD })
spark.def("fizz",   { sprite = "fizz",  life = 44, drag = 0.03, gravity = -0.04, bank = BLUE })
spark.def("shock",  { sprite = "shock", life = 16, bank = BLUE })
spark.def("blast",  { sprite = "blast", life = 24, drag = 0.10 })
spark.def("blaze",  { sprite = "blaze", life = 32, drag = 0.10 })

-- Where a shot lands: somewhere on the lower half of the creature.
local function chip(e, _, _)
  spark.burst { kind = "splint", from = e, dy = 6, n = 1, dir = 90, spread = 140, speed = 2.5 }
end

local function small(e, _)
  spark.burst { kind = "blast", from = e, speed = 0 }
  spark.burst { kind = "fizz", from = e, n = 5, speed = 1 }
end

local function large(e, _)
  spark.burst { kind = "blaze", from = e, speed = 0 }
  spark.burst { kind = "shock", from = e, speed = 0 }
  spark.burst { kind = "fizz", from = e, n = 12, speed = 1.6 }
end

-- A tough shell throws its splinters at whoever broke it.
local function burst(e, p)
  large(e, p)
  pattern.ring { from = e, kind = "shard", bank = 7, n = by_difficulty { easy = 6, normal = 10, hard = 16 }, aim = true, speed = 1.8 }
end

-- A boss goes down in a chain of fire. Its handle is dead by then: the place is kept.
local function collapse(e, _)
  local x, y = e.x, e.y
  bullet.clear { spark = "glint" }
  task.go(function()
    for i = 1, 14 do
      local dx, dy = 34 * angle.cos(137 * i), 26 * angle.sin(137 * i)
      spark.burst { kind = i % 3 == 0 and "blaze" or "blast", x = x + dx, y = y + dy, speed = 0.4 }
      spark.burst { kind = "crumb", x = x + dx, y = y + dy, n = 8, speed = 3 }
      wait(5)
    end
    spark.burst { kind = "blaze", x = x, y = y, n = 7, speed = 2 }
    spark.burst { kind = "shock", x = x, y = y, speed = 0 }
    spark.burst { kind = "glint", x = x, y = y, n = 48, speed = 5 }
  end)
end

local COLD, WARM = 0, 1 -- the two colours of glass

local function creature(name, bank, w, h, hp, score, on_death)
  enemy.def(name, { sprite = name, bank = bank, hit = { box = { w, h } }, hp = hp, score = score, spark = "crumb", on_hit = chip, on_death = on_death })
end

creature("krill",    COLD, 16, 16, 4,   120,   small)
creature("fish",     COLD, 20, 26, 16,  360,   small)
creature("jelly",    WARM, 28, 26, 70,  1500,  large)
creature("ray",      COLD, 40, 26, 60,  1600,  large)
creature("urchin",   COLD, 28, 28, 90,  2400,  burst)
creature("nautilus", WARM, 32, 32, 150, 5000,  large)
creature("crab",     COLD, 56, 34, 100, 30000, collapse)
creature("queen",    COLD, 52, 56, 100, 90000, collapse)

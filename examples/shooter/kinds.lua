-- kinds.lua - the kinds of sparks, bullets and enemies.
local AMBER, GOLD = 2, 3 -- palette banks; 0 to 7 are the same ramp in eight colours

spark.def("glint", { sprite = "glint", life = 16, drag = 0.06, bank = GOLD })
spark.def("crumb", { sprite = "crumb", life = 40, drag = 0.04, gravity = 0.04, banks = { 3, 2, 1 } })
spark.def("hoop",  { sprite = "hoop",  life = 12, bank = GOLD })
spark.def("shock", { sprite = "shock", life = 16, bank = AMBER })

-- A bullet with a delay starts as mist; a cleared one pops.
local function kind(name, hit, more)
  local def = { sprite = name, hit = hit, cloud = "mist", vanish = "hoop" }
  for k, v in pairs(more or {}) do def[k] = v end
  bullet.def(name, def)
end
kind("pellet", { circle = 2 })
kind("orb",    { circle = 3.5 })
kind("star",   { circle = 4 })
kind("pearl",  { circle = 6 })
kind("rice",   { capsule = { 5, 1.5 } }, { turns = true })
kind("petal",  { capsule = { 4, 2 } },   { turns = true })
kind("kunai",  { circle = 2.5 },         { turns = true, order = 1 })

local function chip(e)
  sound.play("chip", { from = e })
  spark.burst { kind = "crumb", from = e, n = 1, speed = 2 }
end

local function pop(e)
  spark.burst { kind = "shock", from = e, speed = 0 }
  spark.burst { kind = "crumb", from = e, n = 12, speed = 2.5 }
end

enemy.def("lantern", { sprite = "lantern", hit = { box = { 18, 20 } }, hp = 6, score = 300, spark = "glint",
  blink = 6, on_hit = chip, on_death = pop })
enemy.def("moth", { sprite = "moth", bank = 1, hit = { box = { 26, 18 } }, hp = 14, score = 800, spark = "glint",
  blink = 6, on_hit = chip, on_death = pop })
enemy.def("drum", { sprite = "drum", hit = { box = { 28, 40 } }, hp = 90, score = 4000, spark = "glint",
  blink = 6, on_hit = chip, on_death = function(e)
    pop(e)
    sound.play("burst", { from = e })
    bullet.sweep { x = e.x, y = e.y, radius_to = 90, over = 20 } -- its light clears the bullets near it
  end })

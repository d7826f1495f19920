-- kinds.lua - the kinds of sparks, bullets and enemies.
local AMBER, GOLD = 2, 3 -- palette banks; 0 to 7 are the same ramp in eight colours

spark.def("glint", { sprite = "glint", life = 16, drag = 0.06, bank = GOLD })
spark.def("crumb", { sprite = "crumb", life = 40, drag = 0.04, gravity = 0.04, banks = { 3, 2, 1 } })
spark.def("hoop",  { sprite = "hoop",  life = 12, bank = GOLD })
spark.def("shock", { sprite = "shock", life = 16, bank = AMBER })
spark.def("muzzle", { sprite = "glint", life = 5, bank = 5 })

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

-- What hits and explosions are made of, by size: docs/guide/12-screen.md.
fx.def("hit", { sound = "chip",
  sparks = { { kind = "glint" }, { kind = "crumb", n = 2, dir = 90, spread = 160, speed = 3 } } })
fx.def("small", {
  sparks = { { kind = "shock" }, { kind = "crumb", n = 16, speed = 3.5 }, { kind = "fx_dot", n = 20, speed = 4 } } })
fx.def("medium", { shake = 2, stop = 2, chain = 3, chain_radius = 16, sparks = { { kind = "shock" },
  { kind = "crumb", n = 28, speed = 4.5 }, { kind = "glint", n = 12, radius = 8, speed = 3 },
  { kind = "fx_dot", n = 32, speed = 5 } } })
fx.def("large", { sound = "burst", shake = 5, flash = 0.4, flash_to = 0xffd080, stop = 4, chain = 8, chain_radius = 36,
  sparks = { { kind = "shock", n = 5, radius = 20 }, { kind = "crumb", n = 60, speed = 6 },
             { kind = "glint", n = 32, radius = 12, speed = 5 }, { kind = "fx_dot", n = 60, speed = 7 } } })

-- on_death for an explosion of a size.
local function explosion(size) return function(e) fx.explode { from = e, size = size } end end

enemy.def("lantern", { sprite = "lantern", hit = { box = { 18, 20 } }, hp = 6, score = 300, blink = 6,
  on_hit = fx.hit, on_death = explosion "small" })
enemy.def("moth", { sprite = "moth", bank = 1, hit = { box = { 26, 18 } }, hp = 14, score = 800, blink = 6,
  on_hit = fx.hit, on_death = explosion "medium" })
enemy.def("drum", { sprite = "drum", hit = { box = { 28, 40 } }, hp = 90, score = 4000, blink = 6,
  on_hit = fx.hit, on_death = function(e)
    fx.explode { from = e, size = "large" }
    bullet.sweep { x = e.x, y = e.y, radius_to = 90, over = 20 } -- its light clears the bullets near it
  end })

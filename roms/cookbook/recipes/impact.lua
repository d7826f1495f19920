-- impact.lua - Impact: Hits throw sparks at the ship, and things die in three sizes of explosion;
-- then a jelly dies like a boss. Each is one line. The sparks are dots; `fx.def` adds light.
spark.def("shine", { sprite = "ember", life = 20, drag = 0.08, blend = "glow", bank = 3 })
fx.def("medium", { shake = 2, stop = 2, sparks = {
  { kind = "fx_dot", n = 30, speed = 5 }, { kind = "shine", n = 8, speed = 3 } } })
fx.def("large", { shake = 5, flash = 0.35, stop = 4, chain = 6, chain_size = "medium", sparks = {
  { kind = "fx_dot", n = 60, speed = 7 }, { kind = "shine", n = 20, speed = 5 } } })

local SIZES = { "small", "medium", "large" }

for i, size in ipairs(SIZES) do
  enemy.def(size, { sprite = i == 3 and "jelly" or "wisp", hit = { circle = 10 }, hp = 10 * i,
    blink = 4, on_hit = fx.hit, on_death = function(e) fx.explode { from = e, size = size } end })
end

local function run()
  while true do
    for i, size in ipairs(SIZES) do
      local e = enemy.spawn { kind = size, x = 60 * i, y = 90 }
      while e.alive do
        shot.fire { kind = "dart", x = e.x, y = 250, speed = 9 }
        wait(6)
      end
      wait(30)
    end
    wait_for(fx.collapse { x = 120, y = 100, sprite = "jelly", radius = 18 })
    wait(90)
  end
end

return { run = run, ship = "gun", alone = true }

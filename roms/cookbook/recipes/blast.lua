-- blast.lua - Explosion: An explosion is a flash, a shake, a ring of sparks, and fire that cools
-- from white to dark. Only the picture shakes. Positions don't change, so hits are not affected.
spark.def("fire", { sprite = "ember", life = 44, drag = 0.05, banks = { 3, 2, 1, 1 },
                    blend = "glow" })
spark.def("ash",  { sprite = "dot", life = 70, drag = 0.03, gravity = 0.03,
                    banks = { 3, 2, 1, 0 } })

local function explode(x, y)
  screen.flash { to = 0xfff6bc, over = 14, share = 0.7 }
  screen.shake { size = 6, over = 36 }
  spark.burst { kind = "fire", x = x, y = y, n = 26, speed = 2.6 }
  spark.burst { kind = "fire", x = x, y = y, n = 30, radius = 10, speed = 3.4 }
  spark.burst { kind = "ash", x = x, y = y, n = 60, speed = 3 }
end

local function run()
  for k = 0, forever do
    local e = enemy.spawn { kind = "jelly", x = 60 + 60 * (k % 3), y = 110 }
    wait(40)
    explode(e.x, e.y)
    e:remove()
    wait(80)
  end
end

return { run = run, alone = true }

-- hit_stop.lua - Hit-stop: When a big enemy dies, the field freezes for eight frames and the
-- picture shakes before the enemy bursts. The field's tasks freeze too, so no script has to wait.
enemy.def("heavy", { sprite = "jelly", hit = { box = { 28, 26 } }, hp = 24, score = 2000, blink = 4,
  on_death = function(e)
    board.stop(8)
    screen.shake { size = 4, over = 20 }
    spark.burst { kind = "glint", x = e.x, y = e.y, n = 60, radius = 8, speed = 3 }
    pattern.ring { kind = "star", bank = 3, x = e.x, y = e.y, n = 24, speed = 1.8 }
  end })

local function run()
  for k = 0, forever do
    local e = enemy.spawn { kind = "heavy", x = 60 + 40 * (k % 4), y = -20 }
    e:move { x = e.x, y = 110, over = 60, ease = "out" }
    wait(70)
  end
end

return { run = run, ship = "gun", alone = true }

-- glow.lua - a demo stage for blending: lamps and embers add their light, and a ghost is half transparent.
bullet.def("ember", { sprite = "ember", hit = { circle = 5 }, blend = "glow" })
spark.def("mote", { sprite = "ember", life = 50, drag = 0.04, gravity = -0.01, bank = 2, blend = "glow" })
enemy.def("ghost", { sprite = "queen", hit = "none", touch = false, blend = "ghost" })

local function lamp(x, y, bank, radius, speed)
  local s = sprite.put { sprite = "lamp", x = x, y = y, bank = bank, layer = "back", blend = "glow" }
  task.go(function()
    for i = 0, forever do
      s.x, s.y = x + radius * angle.cos(speed * i), y + radius * angle.sin(speed * i)
      wait(1)
    end
  end)
end

stage.def("glow", function()
  local star = motion.def { { turn = 0.7, over = 120 }, { accel = 0.02, over = 60 } }
  lamp(104, 120, 1, 26, 0.9)
  lamp(140, 124, 6, 30, -0.7)
  lamp(120, 150, 4, 28, 1.1)
  local queen = enemy.spawn { kind = "queen", x = 120, y = 110 }
  queen.safe = forever
  local ghost = enemy.spawn { kind = "ghost", x = 40, y = 150 }
  ghost.safe = forever
  ghost:move { x = 170, y = 150, over = 400, ease = "both" }
  for i = 0, forever do
    pattern.ring { from = queen, kind = "ember", n = 14, dir = 7 * i, speed = 1.1, bank = i % 7 + 1, motion = star }
    for k = 1, 5 do
      spark.burst { kind = "mote", x = rng.int(20, 220), y = 320, dir = 270, spread = 40, speed = 3 }
      wait(6)
    end
  end
end)

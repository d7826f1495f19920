-- rays.lua - a demo stage for lasers: beams that turn, bolts that bounce, curves that weave, and a player's laser.
local weave = motion.def { { wave = 26, every = 70, over = forever } }
local bank = motion.def { { bounce = 3, walls = "left right" } }

stage.def("lasers", function()
  local queen = enemy.spawn { kind = "queen", x = 120, y = 90 }
  queen.safe = forever
  queen:move { x = 150, y = 80, over = 300, ease = "both" }
  laser.beam { kind = "lance", follow = player.get(1), dy = -14, dir = 270, length = 300, hold = forever, warn = 0 }
  for i = 0, forever do
    for k = 0, 3 do
      laser.beam { kind = "shine", follow = queen, dir = 45 + 90 * k, length = 330, hold = 150, spin = 0.4, bank = 7 }
    end
    wait(60)
    pattern.fan { from = queen, kind = "ray", fire = "bolt", n = 6, spread = 200, dir = 90, speed = 3, length = 60,
      motion = bank, bank = 2 }
    wait(60)
    pattern.ring { from = queen, kind = "scale", fire = "curve", n = 8, dir = 11 * i, speed = 2.4, points = 48,
      motion = weave, bank = 4 }
    wait(150)
  end
end)

-- star_drawing.lua - Drawing a star: A pen draws five lines of motionless bullets. When the star is
-- complete, a signal releases all of them, each in its own direction.
local wait_for_it = motion.def { { wait_for = { tag = "star" } }, { speed = 2.4, over = 60 } }

local function corner(i) return 120 + 76 * angle.cos(144 * i - 90),
  120 + 76 * angle.sin(144 * i - 90) end

return function()
  for round = 0, forever do
    for i = 0, 4 do
      local x1, y1 = corner(i)
      local x2, y2 = corner(i + 1)
      for k = 0, 11 do
        bullet.fire { kind = "star", bank = 3, x = x1 + (x2 - x1) * k / 12,
                      y = y1 + (y2 - y1) * k / 12,
                      dir = 72 * i + 30 * k + 40 * round, speed = 0, motion = wait_for_it }
        wait(1)
      end
    end
    wait(20)
    bullet.group("star"):signal()
    wait(70)
  end
end

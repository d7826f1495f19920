-- time_stop.lua - Time stop: All bullets freeze and lose their colour, and knives appear among
-- them. When time resumes, the bullets fly on, together with the knives.
local function strike(e, p)
  bullet.group().frozen = forever
  palette.fade { to = 0x303848, over = 10, first = 16 * 6, last = 16 * 7 - 1 }
  for i = 1, 12 do
    bullet.fire { kind = "knife", bank = 1, x = p.x + 80 * angle.cos(137.5 * i),
                  y = p.y - 70 + 50 * angle.sin(137.5 * i), aim = true, speed = 2.4,
                  delay = 5 * (12 - i) + 40 }
    wait(5)
  end
  wait(40)
  palette.fade { to = "main", over = 10 }
  bullet.group().frozen = 0
end

return function(e, p)
  while true do
    for k = 1, 8 do
      pattern.ring { from = e, kind = "orb", bank = 6, n = 22, dir = 4 * k, speed = 1.6 }
      wait(16)
    end
    task.go(strike, e, p)
    wait(140)
  end
end

-- patterns/curtains.lua - walls with a wandering gap: `skip` omits bullets.
return function(e)
  wait_for(e:move { x = 120, y = 60, over = 40, ease = "both" })
  for i = 1, forever do
    local gap = math.floor(12 + 9 * angle.sin(16 * i))
    pattern.line { x = 120, y = -8, kind = "pearl", bank = 6, n = 24, width = 236, dir = 90, speed = 1.5,
                   skip = { gap - 2, gap + 2 } }
    if i % 4 == 0 then
      pattern.fan { from = e, kind = "needle", bank = 1, n = 3, spread = 24, aim = true, speed = 2.6 }
    end
    wait(26)
  end
end

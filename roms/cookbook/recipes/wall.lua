-- wall.lua - Moving gap: Each full-width row omits four bullets, and the gap moves by one place per
-- row, to one side and then back. In a line that flies down, `skip` counts from the right end.
return function()
  for k = 0, forever do
    local at = math.abs(k % 28 - 14) + 3
    pattern.line { x = 120, y = -8, kind = "orb", bank = 5 + (k // 14) % 2, n = 20, width = 228,
                   dir = 90, speed = 1.6,
                   skip = { at - 1, at + 2 } }
    wait(14)
  end
end

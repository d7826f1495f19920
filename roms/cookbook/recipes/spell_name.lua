-- spell_name.lua - Spell name: The name appears letter by letter in the middle, slides to the top
-- and stays there while the pattern continues. text.line returns a handle, so a script can move the
-- line.
return function(e)
  while true do
    local name = text.line { x = 120, y = 150, text = "Night Sign \"Slow Rain\"", font = "slim",
                             align = "center", bank = 3, letter = 3 }
    spark.burst { kind = "glint", from = e, n = 40, radius = 30, speed = 2 }
    wait_until(function() return name.done end)
    wait(20)
    for i = 1, 40 do
      name.y = 150 - 134 * (i / 40) * (2 - i / 40)
      wait(1)
    end
    for k = 1, 12 do
      pattern.line { x = 120 + k % 2 * 9, y = -8, kind = "drop", bank = 5, n = 13, width = 220,
                     speed = 1.2 }
      wait(24)
    end
    name:remove()
    wait(60)
  end
end

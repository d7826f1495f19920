-- difficulty.lua - By difficulty: One pattern has different numbers for each difficulty.
-- by_difficulty returns the value for the current difficulty or the nearest easier one. This page
-- cycles through all three difficulties.
local function volley(e)
  local n = by_difficulty { easy = 7, normal = 13, hard = 21 }
  local lines = by_difficulty { easy = 1, hard = 3 }
  for i = 0, lines - 1 do
    pattern.fan { from = e, kind = "knife", bank = by_difficulty { easy = 4, normal = 3, hard = 1 },
                  n = n, spread = 120, aim = true, speed = 1.8 + 0.3 * i }
  end
end

return function(e)
  while true do
    for _, name in ipairs { "easy", "normal", "hard" } do
      board.difficulty(name)
      local note = text.line { x = 120, y = 24, text = name, font = "slim", align = "center",
                               bank = 5 }
      for _ = 1, 3 do
        volley(e)
        wait(44)
      end
      note:remove()
    end
  end
end

-- ending.lua - what is seen when the queen is broken: three lines, one after the other.
local LINES = { "She rings once, and breaks.", "The tide turns, and is ours.",
  "The harbour bells answer." }
local APART, STAYS = 100, 240 -- frames

local function pressed() return pad.take("fire", 0, 1) or pad.take("fire", 0, 2) end

return function(_)
  local row = hud.rows // 3
  for _, line in ipairs(LINES) do
    row = hud.centre(row, line, hud.banks.bright) + 2
    wait_until(pressed, APART)
  end
  wait_until(pressed, STAYS)
end

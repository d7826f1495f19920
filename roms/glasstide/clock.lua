-- clock.lua - the clock at the bottom of the screen, for timed modes.
local clock = {}

local OFTEN <const> = 6 -- frames between updates, a tenth of a second
clock.ROW = hud.rows - 2.5 -- above the mark of the boss's position

-- Formats frames as minutes, seconds and hundredths.
function clock.text(frames)
  return ("%d:%02d.%02d"):format(frames // 3600, frames // 60 % 60, frames % 60 * 100 // 60)
end

-- Shows f(), in frames, until the returned value is closed: local shown <close> = clock.show(f).
-- Below `alarm` frames it uses the alarm colour. While f() is nil, it shows nothing.
function clock.show(f, alarm)
  local t = task.go(function()
    local there = false
    while true do
      local frames = f()
      if frames then
        hud.centre(clock.ROW, clock.text(frames),
                   frames < (alarm or 0) and hud.banks.alarm or hud.banks.bright)
      elseif there then
        text.clear { col = 8, row = clock.ROW // 1, w = hud.cols - 16, h = 1 }
      end
      there = frames ~= nil
      wait(OFTEN)
    end
  end)
  return setmetatable({}, { __close = function() task.stop(t) end })
end

return clock

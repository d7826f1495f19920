-- clock.lua - the clock of timed modes, in place of the best score.
local clock = {}

local OFTEN <const> = 6 -- frames between updates, a tenth of a second

-- Formats frames as minutes, seconds and hundredths.
function clock.text(frames)
  return ("%d:%02d.%02d"):format(frames // 3600, frames // 60 % 60, frames % 60 * 100 // 60)
end

-- Shows f(), in frames, until the returned value is closed: local shown <close> = clock.show(f).
-- Below `alarm` frames it uses the alarm colour. While f() is nil, it shows nothing.
function clock.show(f, alarm)
  local t = task.go(function()
    while true do
      local frames = f()
      hud.note(frames and clock.text(frames),
               frames and frames < (alarm or 0) and hud.banks.alarm or hud.banks.bright)
      wait(OFTEN)
    end
  end)
  return setmetatable({}, { __close = function()
    task.stop(t)
    hud.note()
  end })
end

return clock

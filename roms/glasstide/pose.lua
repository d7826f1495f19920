-- pose.lua - the picture `attack` of bosses and creatures.
local pose = {}

local READY <const>, AFTER <const> = 16, 10 -- frames for which a creature shows it before and after it fires

-- Shows it for some frames, or until the phase or the enemy ends.
function pose.attack(e, over)
  task.go(function()
    local rest <close> = setmetatable({}, { __close = function() if e.alive then e.picture = nil end end })
    e.picture = "attack"
    wait(over)
  end)
end

-- Waits for n frames, after which creature e fires, and shows it in the last of them; streams of shots are too quick.
function pose.ready(e, n)
  if n <= READY + AFTER then return wait(n) end
  wait(n - READY)
  pose.attack(e, READY + AFTER)
  wait(READY)
end

return pose

-- boss/armour.lua - the frames of a phase, behind those that are safe, in which less damage is taken.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

-- Returns the task, which is to be stopped with the phase.
return function(team, phase)
  local usual = {}
  for i, e in ipairs(team) do usual[i] = e.rate end
  local function share(n)
    for i, e in ipairs(team) do
      if e.alive then e.rate = usual[i] * n end
    end
  end
  return task.own(sys.task(), function()
    local back <close> = setmetatable({}, { __close = function() share(1) end })
    share(phase.rate)
    wait(phase.safe + phase.armour)
  end)
end

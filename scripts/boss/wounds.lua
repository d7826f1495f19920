-- boss/wounds.lua - draws over each boss what it shows of its damage: `hurt` below half of the hit points of all its
-- phases, and `broken` below a quarter.
local STEP <const> = 6 -- frames from one look at the hit points to the next

-- The hit points of cast member m in a phase.
local function full(phase, m)
  if type(phase.hp) == "table" then return phase.hp[m.name] or 0 end
  return phase.survive and 0 or phase.hp or 1
end

-- Returns a function that returns the share of its hit points that a member still has, in a phase that runs.
local function share_of(b, m)
  local total, later = 0, {}
  for i = #b.phases, 1, -1 do
    later[b.phases[i]] = total
    total = total + full(b.phases[i], m)
  end
  return function(e, phase) return (later[phase] + math.min(e.hp, full(phase, m))) / total end
end

return function(b, m, e, status)
  local share, images = share_of(b, m), {}
  for i, name in ipairs { "hurt", "broken" } do -- put with the boss, so that their frames keep step with its own
    images[i] = m[name] and sprite.put { sprite = m[name], bank = e.bank, follow = e, layer = "middle", hidden = true }
  end
  while e.alive do
    local phase = status.phase
    if phase then
      local left = share(e, phase)
      local level = left < 1 / 4 and images[2] and 2 or left < 1 / 2 and 1
      for i, image in pairs(images) do image.hidden, image.flip_x = i ~= level, e.flip_x end
    end
    wait(STEP)
  end
end

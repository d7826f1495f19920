-- boss/cast.lua - a phase of several at once: whose bars there are, and what each runs.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

-- One bar for all: what each has lost, all have.
local function shared(team, hp)
  for _, e in ipairs(team) do e.hp = hp end
  return function()
    local lost = 0
    for _, e in ipairs(team) do lost = lost + (e.alive and hp - e.hp or 0) end
    if lost > 0 then
      hp = math.max(0, hp - lost)
      for _, e in ipairs(team) do e.hp = hp end
    end
    return hp == 0
  end
end

-- A bar each; who has none cannot be hurt. scenes: what stops with a bar, by its place in the cast.
local function each(b, team, phase, scenes)
  local bars, down = 0, {}
  for i, m in ipairs(b.cast) do
    local hp = phase.hp[m.name]
    team[i].hp = hp or 1
    if hp then bars = bars + 1 else team[i].safe = forever end
  end
  local fallen = 0
  return function()
    for i, e in ipairs(team) do
      if not down[i] and phase.hp[b.cast[i].name] and (not e.alive or e.hp <= 0) then
        down[i], fallen = true, fallen + 1
        if scenes[i] then task.stop(scenes[i]) end
        if e.alive then
          e.safe = forever
          e.x = e.x -- ends the move it makes
        end
      end
    end
    return fallen >= (phase.down == "any" and 1 or bars)
  end
end

return function(b, team, phase)
  local scene, scenes, run = sys.scene(sys.task()), {}, phase.run
  if type(run) == "function" then
    task.own(scene, function() run(table.unpack(team)) end)
  else
    for i, m in ipairs(b.cast) do
      local own, e = run[m.name], team[i]
      if own then
        scenes[i] = sys.scene(scene)
        task.own(scenes[i], function() own(e) end)
      end
    end
  end
  if type(phase.hp) == "table" then return scene, each(b, team, phase, scenes) end
  return scene, shared(team, phase.hp or 1)
end

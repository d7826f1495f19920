-- boss/talk.lua - the talks before a phase, or behind the last. Nobody can be hurt meanwhile: the boss is safe, the
-- bullets are gone.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

return function(list, team)
  local scene = sys.scene(sys.task()) -- takes what they put along
  wait(1) -- on.phase of the phase before comes at the end of the frame
  for _, f in ipairs(list) do
    local run = rawget(sys, "talk") -- talk.run, of a game that has it
    local function told() f(table.unpack(team)) end
    wait_for(task.own(scene, function() if run then run(told, { clock = true }) else told() end end))
  end
  task.stop(scene)
end

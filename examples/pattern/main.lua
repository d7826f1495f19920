-- main.lua - one enemy, one ship, and a stage for each pattern: add the name of your file to the list.
require "kinds"

local names = { "try", "flower", "curtains", "clockwork", "stopped" }
for _, name in ipairs(names) do
  local fire = require("patterns/" .. name)
  stage.def(name, function()
    local e = enemy.spawn { kind = "keeper", x = 120, y = 90 }
    task.own(e, fire, player.get(1)) -- a task gets its owner first: fire(e, p)
    wait_for(e)
  end)
end
boot.run { stages = names, players = { "kite" } }

-- main.lua - the stage `try` runs try.lua. If that file returns a function, it becomes a task of an enemy.
require "kinds"
require "glow"
require "looks"
require "moves"
require "treasure"
require "words"
require "scenes"
require "rays"
require "duel"
require "heard"
local try = require "try"

-- Features that rom.lua enables and only examples use; named here so that `curtain check` doesn't report them.
local rooms = { "value", "meet", "option", "pierce", "ml" } -- luacheck: ignore

stage.def("try", function()
  local e = enemy.spawn { kind = "jelly", x = 120, y = 70 }
  e.safe = forever
  if type(try) == "function" then task.own(e, try, player.get(1)) end
  wait(forever)
end)

boot.run { stages = { "try" }, players = { "ship" } }

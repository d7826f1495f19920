-- main.lua - a stage that does nothing but run try.lua: what that returns, if it is a function, is a task of an enemy.
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

-- What rom.lua has room for and only what is tried uses: spelt here, so that `curtain check` lets it be.
local rooms = { "value", "meet", "option", "pierce", "ml" } -- luacheck: ignore

stage.def("try", function()
  local e = enemy.spawn { kind = "jelly", x = 120, y = 70 }
  e.safe = forever
  if type(try) == "function" then task.own(e, try, player.get(1)) end
  wait(forever)
end)

boot.run { stages = { "try" }, players = { "ship" } }

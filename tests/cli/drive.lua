-- drive.lua - the main.lua under which an example of the guide is run: it spawns the enemies the example declares,
-- fights its bosses, holds fire, spares the player, and hurts what can be hurt, so that every function of the example
-- gets called.
require "kinds"

local seen = {}
local function record(space)
  local def, list = space.def, {}
  space.def = function(name, ...)
    list[#list + 1] = name
    return def(name, ...)
  end
  return list
end
seen.enemy, seen.boss, seen.player = record(enemy), record(boss), record(player)

local try = require "try"

local down, pressed, take = pad.down, pad.pressed, pad.take
function pad.down(button, p) return button == "fire" or down(button, p) end
function pad.pressed(button, p)
  if button == "start" or button == "select" then return pressed(button, p) end
  return board.frame() % 20 == 0 or pressed(button, p)
end
function pad.take(button, n, p)
  if button == "start" or button == "select" then return take(button, n, p) end
  return board.frame() % 20 <= n or take(button, n, p)
end

on.hit(function(p) if board.frame() > 400 then p.safe = 60 end end)

stage.def("drive", function()
  local e = enemy.spawn { kind = "jelly", x = 120, y = 70 }
  e.safe = forever
  if type(try) == "function" then task.own(e, try, player.get(1)) end
  task.go(function()
    while true do
      wait(15)
      enemy.each(nil, function(other) if other ~= e then other:hurt(40) end end)
    end
  end)
  for i, kind in ipairs(seen.enemy) do enemy.spawn { kind = kind, x = 30 + 20 * i % 180, y = 40 } end
  wait(200)
  for _, name in ipairs(seen.boss) do boss.fight(name) end
  wait(forever)
end)

boot.run { stages = { "drive" }, players = #seen.player > 0 and seen.player or { "ship" } }

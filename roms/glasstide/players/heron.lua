-- players/heron.lua - fast and narrow: two darts abreast, and beads that aim ahead.
local craft = require "players/craft"

shot.def("dart",   { sprite = "dart",   bank = 5, hit = { box = { 8, 14 } },
                    damage = 2, turns = true })
shot.def("sliver", { sprite = "sliver", bank = 5, hit = { box = { 6, 10 } },
                    damage = 1, turns = true })

local function fire(p, beat)
  if beat % 4 ~= 0 then return end
  sound.play("dart", { from = p })
  for side = -1, 1, 2 do
    shot.fire { kind = "dart", from = p, dx = 5 * side, dy = -12, speed = 11 }
  end
end

local function bead(o, beat)
  local side = o.index == 1 and -1 or 1
  if beat % 8 == 2 then
    shot.fire { kind = "sliver", from = o, dy = -6, speed = 10,
                dir = o.focus and 270 or 270 + 7 * side }
  end
end

craft.def("heron", { hit = { circle = 2 }, graze = 14, speed = 4, focus = 1.8 }, fire, bead)

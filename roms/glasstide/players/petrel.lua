-- players/petrel.lua - slower and wide: a fan of fangs that closes while focused, and beads that
-- fire straight.
local craft = require "players/craft"

shot.def("fang",  { sprite = "fang",   bank = 2, hit = { box = { 10, 10 } },
                    damage = 1, turns = true })
shot.def("spine", { sprite = "sliver", bank = 2, hit = { box = { 6, 10 } },
                    damage = 2, turns = true })

local function fire(p, beat)
  if beat % 6 ~= 0 then return end
  sound.play("fang", { from = p })
  local step = pad.down("focus", p) and 3 or 8
  for i = -2, 2 do
    shot.fire { kind = "fang", from = p, dx = 3 * i, dy = -10, speed = 9, dir = 270 + step * i }
  end
end

local function bead(o, beat)
  if beat % 6 == 3 then shot.fire { kind = "spine", from = o, dy = -6, speed = 10 } end
end

craft.def("petrel", { hit = { circle = 2.5 }, graze = 18, speed = 3.2, focus = 1.5 }, fire, bead)

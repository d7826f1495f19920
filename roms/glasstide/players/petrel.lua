-- players/petrel.lua - slower and wide: a fan of fangs that closes while focused, and beads that
-- fire straight.
local craft = require "players/craft"

shot.def("fang",  { sprite = "fang",   bank = 2, hit = { box = { 10, 10 } },
                    damage = 1, turns = true })
shot.def("spine", { sprite = "sliver", bank = 2, hit = { box = { 6, 10 } },
                    damage = 2, turns = true })

local function fire(p, beads, focused, beat)
  if beat % 6 == 0 then
    local step = focused and 3 or 8
    for i = -2, 2 do
      shot.fire { kind = "fang", by = p, x = p.x + 3 * i, y = p.y - 10, speed = 9,
                  dir = 270 + step * i }
    end
  end
  if beat % 6 == 3 then
    for side = -1, 1, 2 do
      shot.fire { kind = "spine", by = p, x = beads[side].x, y = beads[side].y - 6, speed = 10 }
    end
  end
end

craft.def("petrel", {
  sprite = "petrel", hit = { circle = 2.5 }, graze = 18, speed = 3.2, focus = 1.5,
  run = function(p) craft.fly(p, { bead = "petrel_bead", fire = fire }) end,
})

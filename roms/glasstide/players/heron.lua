-- players/heron.lua - fast and narrow: two darts abreast, and beads that aim ahead.
local craft = require "players/craft"

shot.def("dart",   { sprite = "dart",   bank = 5, hit = { box = { 8, 14 } },
                    damage = 2, turns = true })
shot.def("sliver", { sprite = "sliver", bank = 5, hit = { box = { 6, 10 } },
                    damage = 1, turns = true })

local function fire(p, beads, focused, beat)
  if beat % 4 == 0 then
    for side = -1, 1, 2 do
      shot.fire { kind = "dart", by = p, x = p.x + 5 * side, y = p.y - 12, speed = 11 }
    end
  end
  if beat % 8 == 2 then
    for side = -1, 1, 2 do
      local b = beads[side]
      shot.fire { kind = "sliver", by = p, x = b.x, y = b.y - 6, speed = 10,
                  dir = focused and 270 or 270 + 7 * side }
    end
  end
end

craft.def("heron", {
  sprite = "heron", hit = { circle = 2 }, graze = 14, speed = 4, focus = 1.8,
  run = function(p) craft.fly(p, { bead = "heron_bead", fire = fire }) end,
})

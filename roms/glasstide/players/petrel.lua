-- players/petrel.lua - Sen's craft, slower with a wide shot: a fan of fangs that closes with focus
-- and beads that fire straight, or a swarm of homing motes from the craft and from beads that
-- circle it.
local craft = require "players/craft"

shot.def("fang",  { sprite = "fang",   bank = craft.GREEN, hit = { box = { 10, 10 } },
                    damage = 1, turns = true })
shot.def("tusk",  { sprite = "fang",   bank = craft.GREEN, hit = { box = { 10, 10 } },
                    damage = 2, turns = true })
shot.def("spine", { sprite = "sliver", bank = craft.GREEN, hit = { box = { 6, 10 } },
                    damage = 2, turns = true })
shot.def("mote",  { sprite = "mote",   bank = craft.GREEN, hit = { circle = 5 }, damage = 2,
                    turns = true })
shot.def("midge", { sprite = "mote",   bank = craft.GREEN, hit = { circle = 4 }, damage = 1,
                    turns = true })

local seek  = motion.def { { wait = 6 }, { home = 7, over = 70 } }
local hurry = motion.def { { home = 10, over = 60 } }

local function fangs(p, beat)
  if beat % 6 ~= 0 then return end
  sound.play("fang", { from = p })
  local step = pad.down("focus", p) and 3 or 6
  for i = -2, 2 do
    shot.fire { kind = i == 0 and "tusk" or "fang", from = p, dx = 3 * i, dy = -10, speed = 9,
                dir = 270 + step * i }
  end
  for side = -1, 1 do craft.flash(p, 9 * side, -14) end
end

local function bead(o, beat)
  if beat % 6 == 3 then shot.fire { kind = "spine", from = o, dy = -6, speed = 10 } end
end

local function swarm(p, beat)
  if beat % 6 ~= 0 then return end
  sound.play("mote", { from = p })
  local out = pad.down("focus", p) and 14 or 42
  for side = -1, 1, 2 do
    shot.fire { kind = "mote", from = p, dx = 7 * side, dy = -6, speed = 7, dir = 270 + out * side,
                motion = seek }
    craft.flash(p, 7 * side, -8)
  end
end

local function circling(o, beat)
  if (beat + 5 * o.index) % 14 == 0 then
    shot.fire { kind = "midge", from = o, speed = 7, motion = hurry }
  end
end

craft.def("petrel", { hit = { circle = 2.5 }, graze = 18, speed = 3.2, focus = 1.5 },
  { fire = fangs, bead = bead, bomb = "bell",
    options = craft.pairs_of(
      { wide = { { -20, 6 }, { 20, 6 } }, close = { { -14, -10 }, { 14, -10 } } },
      { wide = { { -36, 12 }, { 36, 12 } }, close = { { -24, -4 }, { 24, -4 } } }) })
craft.def("petrel_swarm", { hit = { circle = 2.5 }, graze = 18, speed = 3.4, focus = 1.6 },
  { ship = "petrel", fire = swarm, bead = circling, bomb = "bell",
    options = { by = "shards", style = "orbit", radius = 34, close = 20, spin = 4,
                levels = { { at = 100, n = 3 }, { at = 300, n = 4 } } } })

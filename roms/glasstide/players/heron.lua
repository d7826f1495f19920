-- players/heron.lua - Iri's craft, fast with a narrow shot: two darts abreast with beads that aim
-- ahead, or a lens, a ray that pierces everything, with threads of light from the beads.
local craft = require "players/craft"

shot.def("dart",   { sprite = "dart",   bank = craft.GREEN, hit = { box = { 8, 14 } },
                    damage = 2, turns = true })
shot.def("sliver", { sprite = "sliver", bank = craft.GREEN, hit = { box = { 6, 10 } },
                    damage = 1, turns = true })
laser.def("lens", { strip = "lens_ray", width = 12, hit = { share = 0.8 }, damage = 2, every = 3,
                    bank = craft.GREEN, clearable = false, blend = "glow" })
laser.def("thread", { strip = "lens_ray", width = 6, hit = { share = 0.8 }, damage = 1, every = 6,
                      bank = craft.GREEN, clearable = false, blend = "glow" })

local function darts(p, beat)
  if beat % 4 ~= 0 then return end
  sound.play("dart", { from = p })
  for side = -1, 1, 2 do
    shot.fire { kind = "dart", from = p, dx = 5 * side, dy = -12, speed = 11 }
    craft.flash(p, 5 * side, -16)
  end
end

local function bead(o, beat)
  local side = o.index % 2 == 1 and -1 or 1
  if beat % 8 == 2 then
    shot.fire { kind = "sliver", from = o, dy = -6, speed = 10,
                dir = o.focus and 270 or 270 + 7 * side }
  end
end

-- The lens hums while it fires.
local function lens(p)
  task.own(p, function()
    while true do
      if pad.down("fire", p) then sound.play("lens", { from = p }) end
      wait(14)
    end
  end)
  craft.ray(p, p, function() return { kind = "lens", dy = -16, dir = 270, length = 330 } end)
end

local function thread(o)
  craft.ray(o, o.by, function(me)
    local side = me.index % 2 == 1 and -1 or 1
    local out = me.index > 2 and 16 or 8
    return { kind = "thread", dy = -6, dir = me.focus and 270 or 270 + out * side, length = 330 }
  end)
end

local NEAR <const> = { wide = { { -22, 5 }, { 22, 5 } }, close = { { -11, -15 }, { 11, -15 } } }
local FAR <const> = { wide = { { -34, 16 }, { 34, 16 } }, close = { { -20, -6 }, { 20, -6 } } }

craft.def("heron", { hit = { circle = 2 }, graze = 14, speed = 4, focus = 1.8 },
  { fire = darts, bead = bead, bomb = "undertow", options = craft.pairs_of(NEAR, FAR) })
craft.def("heron_lens", { hit = { circle = 2 }, graze = 14, speed = 3.8, focus = 1.6 },
  { ship = "heron", ray = lens, bead_ray = thread, bomb = "undertow",
    options = craft.pairs_of(
      { wide = { { -16, 8 }, { 16, 8 } }, close = { { -7, -12 }, { 7, -12 } } },
      { wide = { { -27, 14 }, { 27, 14 } }, close = { { -14, -8 }, { 14, -8 } } }) })

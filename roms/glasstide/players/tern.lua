-- players/tern.lua - Ono's craft, fast in a straight line, and heavy: piercing lances with beads
-- that trail behind, or hooks that fly out, come back, and hit both ways.
local craft = require "players/craft"

shot.def("pike",  { sprite = "pike", bank = craft.GREEN, hit = { box = { 6, 24 } }, damage = 5,
                    turns = true, pierce = 3, every = 8 })
shot.def("splinter", { sprite = "sliver", bank = craft.GREEN, hit = { box = { 6, 10 } },
                       damage = 1, turns = true })
shot.def("hook",  { sprite = "hook", bank = craft.GREEN, hit = { circle = 8 }, damage = 3,
                    turns = true, pierce = forever, every = 9 })

local back = motion.def { { speed = -10, over = 84 } }
local soon = motion.def { { speed = -8, over = 56 } }

local function lances(p, beat)
  if beat % 8 ~= 0 then return end
  sound.play("peal", { from = p })
  shot.fire { kind = "pike", from = p, dy = -16, speed = 13 }
  craft.flash(p, 0, -20)
  if p.focus or beat % 16 ~= 0 then return end
  for side = -1, 1, 2 do
    shot.fire { kind = "pike", from = p, dx = 8 * side, dy = -8, speed = 12, dir = 270 + 9 * side }
  end
end

local function bead(o, beat)
  if (beat + 2 * o.index) % 6 == 0 then
    shot.fire { kind = "splinter", from = o, dy = -6, speed = 10 }
  end
end

local function hooks(p, beat)
  if beat % 18 ~= 0 then return end
  sound.play("hook", { from = p })
  local out = p.focus and 5 or 17
  for side = -1, 1 do
    shot.fire { kind = "hook", from = p, dx = 6 * side, dy = -10, speed = 11,
                dir = 270 + out * side, motion = back }
    craft.flash(p, 8 * side, -16)
  end
end

local function flick(o, beat)
  if (beat + 6 * o.index) % 24 == 0 then
    local side = o.index % 2 == 1 and -1 or 1
    shot.fire { kind = "hook", from = o, speed = 8, dir = 270 + (o.focus and 8 or 28) * side,
                motion = soon }
  end
end

craft.def("tern", { hit = { circle = 2.2 }, graze = 16, speed = 3.6, focus = 1.4, needs = "tern" },
  { fire = lances, bead = bead, bomb = "lamp",
    options = { by = "shards", style = "trail", apart = 9,
                levels = { { at = 100, n = 2 }, { at = 300, n = 4 } } } })
craft.def("tern_hooks",
  { hit = { circle = 2.2 }, graze = 16, speed = 3.6, focus = 1.4, needs = "tern" },
  { ship = "tern", fire = hooks, bead = flick, bomb = "lamp",
    options = craft.pairs_of(
      { wide = { { -18, -4 }, { 18, -4 } }, close = { { -10, 10 }, { 10, 10 } } },
      { wide = { { -30, 4 }, { 30, 4 } }, close = { { -18, 16 }, { 18, 16 } } }) })

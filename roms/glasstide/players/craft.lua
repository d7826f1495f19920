-- players/craft.lua - what both craft share: the dot and halo of focus, two beads that fly along,
-- and the undertow, which is their bomb.
local craft = { MOST = 6 } -- of the undertow that can be kept

local BOMBS = 3 -- in each life

-- Puts a sprite, or puts it again when the field was wiped.
local function keep(set, key, spec)
  local s = set[key]
  if not (s and s.alive) then
    s = sprite.put(spec)
    set[key] = s
  end
  return s
end

local function remove_all(set)
  for _, s in pairs(set) do s:remove() end
end

-- Everything a craft wears; closed with its task, so nothing of it stays on the field.
local function wardrobe() return setmetatable({}, { __close = remove_all }) end

-- A wave runs out from the craft: bullets turn to light, and creatures crack. What is seen of it is
-- foam along its edge.
bomb.def("undertow", { over = 90, safe = 150, run = function(p)
  local x, y = p.x, p.y
  screen.shake { size = 3, over = 36 }
  spark.burst { kind = "shock", x = x, y = y, speed = 0 }
  bullet.sweep { x = x, y = y, radius_to = 360, over = 36, hurt = 60, by = p, spark = "glint",
                 items = "foam" }
  for radius = 10, 360, 10 do
    for k = 0, 17 do
      local a = 20 * k + 0.7 * radius
      spark.burst { kind = k % 3 == 0 and "fizz" or "pop", dir = a, speed = 1.5, spread = 0,
                    x = x + radius * angle.cos(a), y = y + radius * angle.sin(a) }
    end
    wait(1)
  end
  item.group():pull(p)
end })

-- A cell off the edges, as the hud; so a talk's plate covers all of them.
local function show_bombs(set, p, bead)
  for i = 1, craft.MOST do
    local x = p.index == 1 and 12 * i + 3 or rom.screen.w - 12 * i - 3
    local s = keep(set, "bomb" .. i, { sprite = bead, x = x, y = rom.screen.h - 15, screen = true })
    s.hidden = i > p.bombs
  end
end

local function show_focus(set, p)
  local slow = pad.down("focus", p)
  keep(set, "halo", { sprite = "halo", follow = p, bank = 5, layer = "middle" }).hidden = not slow
  keep(set, "dot", { sprite = "dot", follow = p, bank = 1 }).hidden = not slow
end

-- Calls f(thing, beat) each frame while player p fires; beat counts from 0 anew with each press.
local function while_firing(thing, p, f)
  local beat = 0
  while true do
    if pad.down("fire", p) then f(thing, beat) end
    beat = pad.down("fire", p) and beat + 1 or 0
    wait(1)
  end
end

-- Declares a craft: def as of player.def, with fire(p, beat); its beads are called NAME_bead, and
-- fire by bead(o, beat). Beads fly apart and a little behind, or close before the bow while it is
-- focused. What is near comes by itself, and all of it if one dares to fly up high.
function craft.def(name, def, fire, bead)
  local beads = name .. "_bead"
  option.def(beads, { sprite = beads, run = function(o) while_firing(o, o.by, bead) end })
  def.sprite, def.lives, def.bomb = name, 3, "undertow"
  def.registers = { bombs = { start = BOMBS, max = craft.MOST } }
  def.options = { kind = beads, over = 6, levels = {
    { wide = { { -22, 5 }, { 22, 5 } }, close = { { -11, -15 }, { 11, -15 } } } } }
  def.magnet, def.collect_line = 30, 96
  def.run = function(p)
    local set <close> = wardrobe()
    task.own(p, while_firing, p, fire)
    while true do
      show_focus(set, p)
      show_bombs(set, p, beads)
      wait(1)
    end
  end
  player.def(name, def)
end

-- A new life has its bombs; what was kept of more is not lost.
function craft.refill(p) p.bombs = math.max(p.bombs, BOMBS) end

return craft

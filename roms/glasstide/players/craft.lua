-- players/craft.lua - what all crafts share: the dot and halo of focus, beads (options), the gauge
-- and its release, and the registers for scoring. Each craft has two forms, and each form is a
-- player kind.
local scoring = require "scoring"
require "players/bombs"
local items = require "items"
local lamps = require "lamps"

-- The most bombs a craft can hold; the bank of everything a craft fires.
local craft = { MOST = items.BOMBS, GREEN = 4 }

local BOMBS <const> = 3 -- per life
local HELD <const> = 4  -- frames that a press of special is buffered

-- Puts a sprite, and again after the field was wiped.
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

-- The sprites on a craft. They are removed when its task closes this.
local function wardrobe() return setmetatable({}, { __close = remove_all }) end

-- Bombs start one cell from the edge, like the HUD's rows.
local function show_bombs(set, p)
  local large = hud.large
  local name, first, step = large and "bomb_large" or "bomb", large and 20 or 14, large and 16 or 13
  for i = 1, craft.MOST do
    local x = first + step * (i - 1)
    local s = keep(set, "bomb" .. i, { sprite = name, bank = craft.GREEN,
                                       x = p.index == 1 and x or rom.screen.w - x,
                                       y = rom.screen.h - (large and 18 or 14), screen = true })
    s.hidden = i > p.bombs or hud.gone[p.index]
  end
end

local function show_focus(set, p)
  local slow = pad.down("focus", p)
  local halo = keep(set, "halo",
                    { sprite = "halo", follow = p, bank = craft.GREEN, layer = "middle" })
  halo.hidden = not slow
  keep(set, "dot", { sprite = "dot", follow = p, bank = 1 }).hidden = not slow
  -- without focus a faint dot still shows the hitbox
  local faint = keep(set, "faint", { sprite = "dot", follow = p, bank = 1, blend = "ghost" })
  faint.hidden = slow or p.state ~= "fly"
end

-- Calls f(thing, beat) each frame while player p fires; beat counts from 0 after each press.
local function while_firing(thing, p, f)
  local beat = 0
  while true do
    if pad.down("fire", p) then f(thing, beat) end
    beat = pad.down("fire", p) and beat + 1 or 0
    wait(1)
  end
end

-- A flash at the muzzle of a craft or a bead.
function craft.flash(thing, dx, dy)
  spark.burst { kind = "muzzle", from = thing, dx = dx, dy = dy, speed = 0 }
end

-- A ray from a craft or a bead while player p fires; spec(thing) returns its current options.
function craft.ray(thing, p, spec)
  local ray
  while true do
    local wanted = pad.down("fire", p) and p.state == "fly"
    if wanted and not (ray and ray.alive) then
      local s = spec(thing)
      s.follow, s.warn, s.grow, s.hold, s.fade = thing, 0, 4, forever, 6
      ray = laser.beam(s)
    elseif not wanted and ray then
      if ray.alive then ray:fade() end
      ray = nil
    elseif ray then
      if board.frame() % 3 == 0 then craft.flash(thing, 0, -10) end
      ray.dir = spec(thing).dir
    end
    wait(1)
  end
end

-- Declares a form of a craft. def is as for player.def. arms has ship, the craft whose pictures it
-- uses; fire(p, beat) and bead(o, beat), or the tasks ray(p) and bead_ray(o); bomb; and options, as
-- for player.def but without kind. The craft attracts nearby items, and all items while it is high
-- up.
function craft.def(name, def, arms)
  local bead, ship = name .. "_bead", arms.ship or name
  option.def(bead, { sprite = ship .. "_bead", run = function(o)
    if arms.bead_ray then return arms.bead_ray(o) end
    while_firing(o, o.by, arms.bead)
  end })
  def.sprite, def.lives, def.bomb = ship, 3, arms.bomb
  def.pictures = lamps.pictures(ship)
  def.registers = scoring.registers()
  def.registers.bombs = { start = BOMBS, max = craft.MOST }
  def.options = arms.options
  def.options.kind = bead
  def.magnet, def.collect_line = 30, 96
  def.run = function(p)
    local set <close> = wardrobe()
    local look = { lean = 0, colour = "" }
    if arms.fire then task.own(p, while_firing, p, arms.fire) end
    if arms.ray then task.own(p, arms.ray, p) end
    while true do
      lamps.wear(p, look)
      show_focus(set, p)
      show_bombs(set, p)
      scoring.watch(p)
      local lets_go = p.gauge >= scoring.NEED and p.state == "fly"
      if lets_go and pad.take("special", HELD, p) then scoring.release(p) end
      wait(1)
    end
  end
  player.def(name, def)
end

-- Options for both forms: one pair, and a second pair with the multiplier at x3.00.
function craft.pairs_of(one, two)
  local all = { wide = {}, close = {} }
  for _, of in ipairs { one, two } do
    for _, how in ipairs { "wide", "close" } do
      for _, at in ipairs(of[how]) do table.insert(all[how], at) end
    end
  end
  return { by = "shards", over = 6, levels = { { at = 100, wide = one.wide, close = one.close },
                                               { at = 300, wide = all.wide, close = all.close } } }
end

-- A new life starts with at least BOMBS bombs; a larger stock stays.
function craft.refill(p) p.bombs = math.max(p.bombs, BOMBS) end

-- The ship of a player's kind, for either form: "heron", "petrel" or "tern".
function craft.ship(p) return p.kind:match("^%a+") end

return craft

-- players/craft.lua - what both craft share: the dot and halo of focus, two beads that fly along,
-- and the undertow, which is their bomb.
local craft = {}

local BOMBS = 3 -- of the undertow, in each life
local MOST = 6 -- that can be kept

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
local function undertow(p)
  local x, y = p.x, p.y
  p.bombs, p.safe = p.bombs - 1, 150
  sound.play("bomb", { from = p })
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
end

local function show_bombs(set, p, bead)
  for i = 1, MOST do
    local x = p.index == 1 and 12 * i - 2 or rom.screen.w - 12 * i + 2
    local s = keep(set, "bomb" .. i, { sprite = bead, x = x, y = rom.screen.h - 9, screen = true })
    s.hidden = i > p.bombs
  end
end

local function show_focus(set, x, y, focused)
  local halo = keep(set, "halo", { sprite = "halo", x = x, y = y, bank = 5, layer = "middle" })
  local dot = keep(set, "dot", { sprite = "dot", x = x, y = y, bank = 1 })
  halo.x, halo.y, halo.hidden = x, y, not focused
  dot.x, dot.y, dot.hidden = x, y, not focused
end

-- Beads swing to their places: apart and a little behind, or close before the bow while focused.
local function swing(beads, x, y, focused)
  local wide, ahead = focused and 11 or 22, focused and -15 or 5
  for side = -1, 1, 2 do
    local b = beads[side]
    b.x = b.x + (x + side * wide - b.x) * 0.35
    b.y = b.y + (y + ahead - b.y) * 0.35
  end
end

-- What both craft are to player.def, beside their pictures: what is near comes by itself, and all
-- of it if one dares to fly up high.
function craft.def(name, def)
  def.lives = 3
  def.registers = { bombs = { start = BOMBS, max = MOST } }
  def.magnet, def.collect_line = 30, 96
  player.def(name, def)
end

-- A new life has its bombs; what was kept of more is not lost.
function craft.refill(p) p.bombs = math.max(p.bombs, BOMBS) end

-- Flies p until it is out of the game. ship: bead (a sprite), fire(p, beads, focused, beat), called
-- each frame while it fires.
function craft.fly(p, ship)
  local set <close> = wardrobe()
  local x, y, beat = p.x, p.y, 0
  local beads = { [-1] = { x = x, y = y }, [1] = { x = x, y = y } }
  while true do
    -- Tasks run before the craft moves, so what follows it leads by its last step.
    local dx, dy = p.x - x, p.y - y
    if dx * dx + dy * dy > 64 then dx, dy = 0, 0 end
    x, y = p.x, p.y
    local focused = pad.down("focus", p)
    swing(beads, x + dx, y + dy, focused)
    for side = -1, 1, 2 do
      local s = keep(set, "bead" .. side, { sprite = ship.bead, x = x, y = y, layer = "middle" })
      s.x, s.y = beads[side].x, beads[side].y
    end
    show_focus(set, x + dx, y + dy, focused)
    show_bombs(set, p, ship.bead)
    if pad.down("fire", p) then
      ship.fire(p, beads, focused, beat)
      beat = beat + 1
    else
      beat = 0
    end
    if pad.pressed("bomb", p) and p.bombs > 0 and p.safe < 60 then task.own(p, undertow) end
    wait(1)
  end
end

return craft

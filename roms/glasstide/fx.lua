-- fx.lua - explosions in three sizes, and the end of a boss. Stages use them through kinds.small,
-- large, huge, burst and collapse. Each takes a place: a thing, or a table with x and y.
local fx = {}

fx.COLLAPSE = 170 -- frames that a boss's end takes; stages wait this long after the fight

local FIRE <const>, COLD <const>, PALE <const>, GOLD <const> = 0, 5, 0, 3 -- banks of additive sprites

-- Fire and light are additive, so bullets show through.
local function light(name, sprite, bank, life, drag)
  spark.def(name, { sprite = sprite, bank = bank, life = life, drag = drag or 0, blend = "glow",
                    layer = "middle" })
end

light("fire_a",  "fire_a",  FIRE, 30, 0.08)
light("fire_b",  "fire_b",  FIRE, 30, 0.08)
light("fire_c",  "fire_c",  FIRE, 40, 0.08)
light("fire_d",  "fire_d",  FIRE, 40, 0.08)
light("fire_e",  "fire_e",  FIRE, 56)
light("flare",   "flare",   GOLD, 18)
light("star",    "flare",   PALE, 18)
light("ripple",  "ripple",  COLD, 24)
light("breaker", "breaker", COLD, 32)
light("dawn",    "breaker", GOLD, 32)

-- Glass in the stage's colours tumbles down; bubbles rise.
local function debris(name, life, def)
  def.sprite, def.life, def.layer = name, life, "middle"
  spark.def(name, def)
end

debris("sherd_s", 22, { drag = 0.035, gravity = 0.045 })
debris("sherd_m", 30, { drag = 0.030, gravity = 0.050 })
debris("sherd_l", 60, { drag = 0.030, gravity = 0.040 })
debris("bubbles", 40, { drag = 0.045, gravity = -0.055 })

local function throw(kind, at, n, speed, radius)
  spark.burst { kind = kind, x = at.x, y = at.y, n = n, speed = speed, radius = radius }
end

-- Sound options from a place, which has no handle.
local function from(at) return { pan = math.max(-1, math.min(1, at.x / 120 - 1)) * 0.6 } end

local turn = 0 -- alternates, so that adjacent fires differ

local function either(a, b)
  turn = turn + 1
  return turn % 2 == 0 and a or b
end

-- For creatures of 20 to 32 px.
function fx.small(at)
  throw(either("fire_a", "fire_b"), at, 1, 0)
  throw("sherd_s", at, 3, 2.2)
  throw("bubbles", at, 1, 0.8)
end

-- For creatures up to 64 px, with a short hit-stop.
function fx.large(at)
  sound.play("crash", from(at))
  throw("star", at, 1, 0)
  throw(either("fire_c", "fire_d"), at, 1, 0)
  throw("ripple", at, 1, 0)
  throw("sherd_s", at, 5, 3)
  throw("sherd_m", at, 3, 2.3)
  throw("bubbles", at, 2, 1.2)
  screen.shake { size = 2, over = 12 }
  board.stop(2)
end

-- For things as large as a quarter of the field: midbosses, claws.
function fx.huge(at)
  sound.play("collapse", from(at))
  throw("flare", at, 1, 0)
  throw("fire_e", at, 1, 0)
  throw(either("fire_c", "fire_d"), at, 5, 1.6, 22)
  throw("breaker", at, 1, 0)
  throw("sherd_m", at, 8, 3.4)
  throw("sherd_l", at, 5, 2.4)
  throw("bubbles", at, 5, 1.6)
  screen.shake { size = 4, over = 30 }
  screen.flash { to = 0xfff2d8, over = 14, share = 0.35 }
  board.stop(4)
end

-- The loss of a craft.
function fx.lost(p)
  throw("flare", p, 1, 0)
  throw("fire_e", p, 1, 0)
  throw("breaker", p, 1, 0)
  throw("glint", p, 24, 4)
  throw("sherd_m", p, 5, 3.5)
  screen.shake { size = 5, over = 30 }
  screen.flash { over = 16, share = 0.4 }
  board.stop(6)
end

-- A bomb or another sweep: rings that spread one after another.
function fx.wave(at)
  local x, y = at.x, at.y
  task.go(function()
    for i = 1, 3 do
      throw(i == 2 and "ripple" or "breaker", { x = x, y = y }, 1, 0)
      wait(6)
    end
  end)
  throw("star", at, 1, 0)
  throw("glint", at, 24, 5, 10)
end

-- The boss's picture, which trembles. A creature's kind and sprite have the same name.
local function remains(e)
  if not (e.kind and rom.has(e.kind)) then return nil end
  return sprite.put { sprite = e.kind, x = e.x, y = e.y, bank = e.bank or 0, layer = "back" }
end

-- It cracks: fires spread over it, faster and faster, and pieces fall off.
local function crack(x, y, body)
  for i = 1, 16 do
    if body and body.alive then body.x, body.y = x + (i % 3 - 1) * 2, y + i // 2 end
    local at = { x = x + 38 * angle.cos(137 * i), y = y + 28 * angle.sin(137 * i) }
    throw(i % 4 == 0 and either("fire_c", "fire_d") or either("fire_a", "fire_b"), at, 1, 0)
    throw("sherd_m", at, 1, 1.8)
    if i == 4 or i == 10 then screen.flash { over = 6, share = 0.2 } end -- at most 3 per second
    if i % 4 == 0 then
      sound.play("crash", from(at))
      throw("ripple", at, 1, 0)
      throw("sherd_l", at, 1, 1.6)
    end
    wait(math.max(3, 9 - i // 2))
  end
end

-- It bursts into light, three rings, and glass that sinks slowly.
local function break_up(x, y)
  local at = { x = x, y = y }
  screen.flash { over = 40, share = 0.7 }
  screen.shake { size = 8, over = 60 }
  throw("flare", at, 1, 0)
  throw("fire_e", at, 1, 0)
  throw("fire_e", at, 4, 1.1, 40)
  throw("fire_d", at, 8, 2.6, 30)
  throw("sherd_l", at, 14, 3.6)
  throw("sherd_m", at, 15, 5)
  throw("glint", at, 40, 6)
  for i = 1, 3 do
    throw(i == 2 and "dawn" or "breaker", at, 1, 0)
    throw("bubbles", at, 12, 2.2, 10 * i)
    wait(7)
  end
  for k = 1, 8 do
    local near = { x = x + 46 * angle.cos(77 * k), y = y + 36 * angle.sin(131 * k) }
    throw("sherd_l", near, 1, 1.8)
    throw("bubbles", near, 2, 1.4)
    wait(6)
  end
end

-- A boss's end lasts longer than two seconds. Its handle is already dead, so the place is copied.
-- The game stops briefly before the burst.
function fx.collapse(e)
  local x, y = e.x, e.y
  sound.play("collapse", from(e))
  throw("star", e, 1, 0)
  throw("ripple", e, 1, 0)
  local body = remains(e)
  screen.shake { size = 4, over = 90 }
  board.stop(8)
  task.go(function()
    crack(x, y, body)
    wait(10)
    board.stop(4)
    if body then body:remove() end
    sound.play("burst")
    break_up(x, y)
  end)
end

return fx

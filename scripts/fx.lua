-- fx.lua - explosions: sparks, shake, flash, hit-stop and sound in one call, by a size. fx.hit is a handler for on_hit;
-- fx.collapse is the death of a boss. Everything but the hit-stop only changes what is drawn and heard.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local fx = {}

local sizes, names = {}, {}      -- declared explosions by size, and their sizes in order of declaration
local turn = 0                   -- selects one of a burst's kinds; counts explosions
local flashed, shaken = -1000, 0 -- game time of the last flash; frame at which the last shake ends
local strength = 0               -- px of that shake

local FLASH_APART <const> = 20 -- frames: at most three flashes per second
local EVERY <const> = 4        -- frames between chained explosions
local GOLDEN <const> = 137.5   -- degrees from one place to the next; they never line up
local MOST_HITS <const> = 5    -- bursts of one hit
local SLOW <const>, FAST <const> = 9, 3 -- frames between the cracks of a collapse: the first ones, the last ones

-- ---- declarations ----

-- Returns a burst for each of its kinds, checked; an explosion uses one of them in turn.
local function variants(burst)
  if type(burst) ~= "table" then sys.check("fx.def sparks", burst) end
  local list, kinds = {}, type(burst.kind) == "table" and burst.kind or { burst.kind }
  for i = 1, math.max(1, #kinds) do
    local one = {}
    for _, key in ipairs(sys.keys(burst)) do one[key] = burst[key] end
    one.kind = kinds[i]
    list[i] = sys.check("fx.def sparks", one)
  end
  return list
end

local function find(api, size) return sizes[size] or sys.unknown(api, "size", size, names) end

local function declare(a)
  local sparks = {}
  for i, burst in ipairs(a.sparks or {}) do sparks[i] = variants(burst) end
  a.sparks = sparks
  if a.chain > 0 then find("fx.def", a.chain_size) end
  if not sizes[a.size] then names[#names + 1] = a.size end
  sizes[a.size] = a
end

function fx.def(size, def) declare(sys.check("fx.def", size, def)) end

-- The sizes that every game has, made of dots. A game without sparks has the rest.
local function dots(n, speed, debris)
  if not sys.on("sparks") then return {} end
  return { { kind = "fx_dot", n = n, speed = speed }, { kind = "fx_dot", n = n // 2, speed = speed / 2 },
           { kind = "fx_debris", n = debris, speed = speed / 3 } }
end

if sys.on("sparks") then
  spark.def("fx_dot", { life = 22, drag = 0.09, layer = "middle" })
  spark.def("fx_debris", { life = 44, drag = 0.03, gravity = 0.05, layer = "middle" })
end
fx.def("hit", { sparks = dots(2, 3, 0) })
fx.def("small", { sparks = dots(14, 4, 4) })
fx.def("medium", { sparks = dots(24, 5, 10), shake = 2, stop = 2 })
fx.def("large", { sparks = dots(48, 7, 24), shake = 5, flash = 0.35, stop = 4, chain = 6, chain_radius = 32 })

-- ---- explosions ----

-- Returns the position, or nil if the thing it is taken from has despawned.
local function placed(api, a)
  if (a.x ~= nil) ~= (a.y ~= nil) or (a.x == nil) == (a.from == nil) then
    sys.fail(api, "place: expected `x` and `y`, or `from` (a thing)")
  end
  if a.from then return a.from.x, a.from.y end
  return a.x, a.y
end

local function shake(size, over)
  local now = sys.clock()
  if now < shaken and size < strength then return end -- a small shake doesn't end a large one
  strength, shaken = size, now + over
  screen.shake { size = size, over = over }
end

local function flash(share, colour)
  if sys.clock() - flashed < FLASH_APART then return end
  flashed = sys.clock()
  screen.flash { to = colour, over = math.max(6, math.floor(40 * share)), share = share }
end

local function throw(e, x, y, dx, dy)
  turn = turn + 1
  for _, list in ipairs(e.sparks) do
    local burst = list[turn % #list + 1]
    burst.x, burst.y, burst.dx, burst.dy = x, y, dx, dy
    spark.burst(burst)
  end
end

local function cue(e, x)
  if e.sound then sys.cue(e.sound, math.max(-1, math.min(1, 2 * x / rom.field.w - 1)) * 0.6) end
end

local function chain(e, x, y, dx, dy)
  local next_one = sizes[e.chain_size]
  for i = 1, e.chain do
    wait(EVERY)
    local far = e.chain_radius * math.sqrt(i / e.chain)
    throw(next_one, x, y, dx + far * angle.cos(GOLDEN * i), dy + far * angle.sin(GOLDEN * i))
  end
end

local function explode(e, x, y, dx, dy)
  throw(e, x, y, dx, dy)
  cue(e, x + dx)
  if e.shake > 0 then shake(e.shake, 6 * e.shake) end
  if e.flash > 0 then flash(e.flash, e.flash_to) end
  if e.stop > 0 then board.stop(e.stop) end
  if e.chain > 0 then task.go(chain, e, x, y, dx, dy) end
end

function fx.explode(args)
  local a = sys.check("fx.explode", args)
  local e, x, y = find("fx.explode", a.size), placed("fx.explode", a)
  if x then explode(e, x, y, a.dx, a.dy) end
end

-- ---- hits ----

-- Sparks fly from the side of e that faces the player, more for more damage.
function fx.hit(e, p, damage)
  local a = sys.check("fx.hit", e, p, damage)
  local x, y, toward = a.e.x, a.e.y, 90
  if not x then return end
  local _, h, _, top = sys.size(sys.enemy_sprite(a.e.kind))
  if a.p and a.p.alive then toward = angle.of(a.p.x - x, a.p.y - y) end
  local reach, hit = (h - top) / 2, sizes.hit
  for _ = 1, math.min(MOST_HITS, 1 + a.damage // 2) do
    throw(hit, x, y, reach * angle.cos(toward), reach * angle.sin(toward))
  end
  cue(hit, x)
end

-- ---- the death of a boss ----

local function remove(body) if body.alive then body:remove() end end

-- The picture of what dies: it trembles and sinks while cracks run over it.
local function remains(a, x, y)
  local body = a.sprite and sprite.put { sprite = a.sprite, x = x, y = y, bank = a.bank, layer = "back", stay = true }
  return setmetatable({}, { __close = function() if body then remove(body) end end }), body
end

local function collapse(a, x, y)
  local crack, last, over, i = sizes[a.crack], sizes[a.size], a.over, 0
  do
    local guard <close>, body = remains(a, x, y)
    while over > 0 and guard do
      i = i + 1
      if body and body.alive then body.x, body.y = x + (i % 3 - 1) * 2, y + i // 2 end
      local dx, dy = a.radius * angle.cos(GOLDEN * i), 0.75 * a.radius * angle.sin(GOLDEN * i)
      throw(crack, x, y, dx, dy)
      if i % 4 == 0 then
        cue(crack, x + dx)
        flash(0.2)
      end
      local rest = math.max(1, math.min(over, FAST + (SLOW - FAST) * over // a.over))
      wait(rest)
      over = over - rest
    end
  end
  explode(last, x, y, 0, 0)
end

function fx.collapse(args)
  local a = sys.check("fx.collapse", args)
  local x, y = placed("fx.collapse", a)
  for _, size in ipairs { a.size, a.crack } do find("fx.collapse", size) end
  if not x then return task.own(a.from, collapse) end -- a task that ends at once
  shake(4, a.over)
  board.stop(8)
  return task.go(collapse, a, x + a.dx, y + a.dy)
end

return fx

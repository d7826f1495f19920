-- scoring.lua - what is worth how much: grazes fill the gauge, its release turns bullets to
-- shards, shards raise the multiplier, and kills in a chain are worth more.
local scoring = { NEED = 250, FULL = 1000 } -- of the gauge, to let it go at all

require "rank" -- its registers
require "items"

local GRAZE <const> = 50        -- points
local FILLS <const> = 10        -- of the gauge, by a graze
local TIRED <const> = 200       -- grazes of a phase that pay in full; then a half, a quarter
local MINIONS <const> = 20      -- of those that a boss sends in one phase so many leave something
local SAFE <const> = 40         -- frames, when the gauge is let go
local LARGE <const> = 3000      -- points that are seen where they were won
local DEAD <const> = 2          -- at a death what is over x1.00 is divided by this
local MOST_CHAIN <const> = 200  -- beyond this a chain is worth no more

local COUNT <const> = { show = "none" } -- nobody practises with more of it

-- What every craft keeps. worn: grazes in this phase; it recovers in waves. Those in the second
-- part are for the tally; brushes: grazes that paid in full.
function scoring.registers()
  return {
    gauge = { max = scoring.FULL, show = "bar", at = "low", label = "GLASS", mark = scoring.NEED },
    shards = { start = 100, min = 100, max = 999, show = "times", at = "low", label = "",
               mark = 500 }, -- in hundredths
    chain = { max = 9999, drain = 1, every = 4, hold = 90, show = "number", at = "low", mark = 50 },
    worn = { drain = 1, every = 30, hold = 120, show = "none" },
    brushes = COUNT, prisms = COUNT, longest = COUNT, captures = COUNT, misses = COUNT,
    used = COUNT }
end

-- A number that rises where it was won.
local function float(x, y, words, bank)
  local l = text.line { x = math.max(16, math.min(x, 224)), y = math.max(24, y), text = words,
                        align = "center", bank = bank }
  if not l then return end
  task.go(function()
    for _ = 1, 36 do
      if not l.alive then return end
      l.y = l.y - 0.5
      wait(1)
    end
    if l.alive then l:remove() end
  end)
end

-- What the k-th graze of a phase pays: all, a half, a quarter, nothing.
local function share(k)
  if k < TIRED then return 1 end
  return k < 2 * TIRED and 0.5 or k < 3 * TIRED and 0.25 or 0
end

local function fill(p, n)
  local before = p.gauge
  p.gauge = before + n
  if before < scoring.FULL and p.gauge == scoring.FULL then
    sound.play("full", { from = p })
    spark.burst { kind = "glint", from = p, n = 16, speed = 3 }
  end
end

on.graze(function(p, _)
  local pays = share(p.worn)
  p.worn = p.worn + 1
  fill(p, math.floor(FILLS * pays))
  score.add(math.floor(GRAZE * pays), p)
  if pays == 1 then p.brushes = p.brushes + 1 end
  if pays > 0 then spark.burst { kind = "ping", from = p, n = 2, speed = 3.5 } end
end)

-- ---- the gauge let go ----

local function wave(p, radius)
  spark.burst { kind = "shock", from = p, speed = 0 }
  for k = 0, 23 do
    local a = 15 * k
    spark.burst { kind = "glint", x = p.x + radius * angle.cos(a), y = p.y + radius * angle.sin(a),
                  dir = a + 180, spread = 0, speed = 0.8 }
  end
end

-- Bullets about the craft become shards that fly to it. Returns how many.
function scoring.release(p)
  if p.gauge < scoring.NEED then return 0 end
  local radius = 40 + p.gauge // 8
  local n = bullet.clear { from = p, radius = radius, items = "prism", spark = "glint" }
  for _, e in ipairs(query.near { what = "enemy", from = p, radius = radius }) do e:hurt(12, p) end
  p.gauge, p.safe = 0, math.max(p.safe, SAFE)
  sound.play("release", { from = p })
  wave(p, radius)
  item.each(nil, function(i) if i.kind == "prism" then i:pull(p) end end)
  if n >= 20 then float(p.x, p.y - 24, ("%d"):format(n), 4) end
  return n
end

-- Who is out has no registers any more.
local function rate(p) return (p.shards or 100) / 100 end

score.rule { on = "take", kind = "prism", points = 100, times = rate,
             gain = { shards = 1, prisms = 1 } }
score.rule { on = "take", kind = "pearl", times = rate }
score.rule { on = "take", kind = "foam", times = rate }

-- ---- chains ----

local function worth(p) return rate(p) * (1 + math.min(p.chain or 0, MOST_CHAIN) / 100) end

score.rule { on = "kill", gain = { chain = 1 }, most = { longest = "chain" }, times = worth }

-- What a boss sends without end is no way to riches: what it left goes again, and counts in no
-- chain.
local function spoil(e, p)
  game.minions = game.minions + 1
  if game.minions <= MINIONS then return end
  if p then p.chain = math.max(0, p.chain - 1) end
  for _, i in ipairs(query.near { what = "item", x = e.x, y = e.y, radius = 12 }) do
    if i.age == 0 then i:remove() end
  end
end

-- Of each player: score, a frame ago; x and y, where it made its last kill since.
local seen = { {}, {} }

-- So many in a chain are heard, once each until it is broken.
local HEARD <const> = { { 25, "chain_one" }, { 60, "chain_two" }, { 120, "chain_three" } }

local function hear(p, s)
  local chain, tier = p.chain or 0, s.tier or 0
  local higher = HEARD[tier + 1]
  if chain == 0 then
    s.tier = 0
  elseif higher and chain >= higher[1] then
    s.tier = tier + 1
    sound.play(higher[2], { from = p })
  end
  local whole = (p.shards or 0) // 100 -- each whole of the multiplier too
  if whole > (s.whole or 1) then sound.play("medal", { from = p }) end
  s.whole = whole
end

on.kill(function(e, p)
  if p then seen[p.index].x, seen[p.index].y = e.x, e.y end
  if boss.now() then spoil(e, p) end
end)

-- Each frame, by the craft: what a kill brought is shown above it, if it is much; not among those
-- who fire.
function scoring.watch(p)
  local s = seen[p.index]
  local n = p.score - (s.score or p.score)
  if s.x and n >= LARGE then float(p.x, p.y - 28, ("%d"):format(n), 4) end
  s.score, s.x, s.y = p.score, nil, nil
  hear(p, s)
end

-- ---- what ends it ----

on.death(function(p)
  p.shards, p.chain, p.gauge = 100 + (p.shards - 100) // DEAD, 0, p.gauge // DEAD
  p.misses = p.misses + 1
end)
on.bomb(function(p) p.used = p.used + 1 end)
on.phase(function(_, _, won, captured)
  game.minions = 0
  player.each(function(p)
    if won then p.worn = 0 end -- who waits for the clock stays tired
    if captured then p.captures = p.captures + 1 end
  end)
end)
on.stage(function(_, state)
  if state ~= "start" then return end
  player.each(function(p) p.worn = 0 end)
end)

score.tally {
  { label = "GRAZE", value = "brushes", points = 200, stage = true },
  { label = "SHARDS", value = "prisms", points = 100, stage = true },
  { label = "BEST CHAIN", value = "longest", points = 1000 },
  { label = "SIGNS BROKEN", value = "captures", points = 20000, stage = true },
  { label = "NO MISS", value = function(p) return p.misses == 0 end, points = 100000 },
  { label = "NO BOMB", value = function(p) return p.used == 0 end, points = 50000 },
  { label = "LIVES", value = "lives", points = 200000, last = true } }

return scoring

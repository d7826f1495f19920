-- scoring.lua - the scoring: grazes fill the gauge, releasing it turns bullets into shards, shards
-- raise the multiplier, and kills in a chain are worth more.
local scoring = { NEED = 250, FULL = 1000 } -- the gauge: least for a release, and full

require "rank" -- its registers
require "items"

local GRAZE <const> = 50        -- points
local FILLS <const> = 10        -- gauge for each graze
local TIRED <const> = 200       -- grazes per phase that pay in full; as many pay half, then a quarter
local MINIONS <const> = 20      -- minions per phase of a boss that drop items
local SAFE <const> = 40         -- frames of safety after a release
local LARGE <const> = 3000      -- points from which a kill shows a floating number
local DEAD <const> = 2          -- a death divides the multiplier's part above x1.00 by this
local MOST_CHAIN <const> = 200  -- longer chains are worth no more

local COUNT <const> = { show = "none" } -- practice doesn't offer it

-- The registers of every craft. worn counts grazes in this phase and recovers over time. The last
-- two rows are for the tally; brushes are grazes that paid in full.
function scoring.registers()
  return {
    gauge = { max = scoring.FULL, show = "bar", at = "low", label = "GLASS", mark = scoring.NEED },
    shards = { start = 100, min = 100, max = 999, show = "times", at = "low", label = "RATE",
               mark = 500 }, -- in hundredths
    chain = { max = 9999, drain = 1, every = 4, hold = 90, show = "number", at = "low", mark = 50 },
    worn = { drain = 1, every = 30, hold = 120, show = "none" },
    brushes = COUNT, prisms = COUNT, longest = COUNT, captures = COUNT, misses = COUNT,
    used = COUNT }
end

-- A number that floats up from a place.
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

-- The share that the k-th graze of a phase pays: full, a half, a quarter, nothing.
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

-- ---- the release of the gauge ----

local function wave(p, radius)
  spark.burst { kind = "shock", from = p, speed = 0 }
  for k = 0, 23 do
    local a = 15 * k
    spark.burst { kind = "glint", x = p.x + radius * angle.cos(a), y = p.y + radius * angle.sin(a),
                  dir = a + 180, spread = 0, speed = 0.8 }
  end
end

-- Bullets around the craft become prisms that fly to it. Returns their number.
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

-- A player who is out has no registers.
local function rate(p) return (p.shards or 100) / 100 end

score.rule { on = "take", kind = "prism", points = 100, times = rate,
             gain = { shards = 1, prisms = 1 } }
score.rule { on = "take", kind = "pearl", times = rate }
score.rule { on = "take", kind = "foam", times = rate }

-- ---- chains ----

local function worth(p) return rate(p) * (1 + math.min(p.chain or 0, MOST_CHAIN) / 100) end

score.rule { on = "kill", gain = { chain = 1 }, most = { longest = "chain" }, times = worth }

-- A boss's endless minions must not pay: after the first MINIONS their items disappear, and they
-- don't count for the chain.
local function spoil(e, p)
  game.minions = game.minions + 1
  if game.minions <= MINIONS then return end
  if p then p.chain = math.max(0, p.chain - 1) end
  for _, i in ipairs(query.near { what = "item", x = e.x, y = e.y, radius = 12 }) do
    if i.age == 0 then i:remove() end
  end
end

-- Per player: the score one frame ago; x and y, the place of its last kill since then.
local seen = { {}, {} }

-- Chain lengths that play a sound, once each until the chain breaks.
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
  local whole = (p.shards or 0) // 100 -- so does each whole number of the multiplier
  if whole > (s.whole or 1) then sound.play("medal", { from = p }) end
  s.whole = whole
end

on.kill(function(e, p)
  if p then seen[p.index].x, seen[p.index].y = e.x, e.y end
  if boss.now() then spoil(e, p) end
end)

-- Called each frame by the craft. Shows a large score from a kill above the craft, away from the
-- enemies.
function scoring.watch(p)
  local s = seen[p.index]
  local n = p.score - (s.score or p.score)
  if s.x and n >= LARGE then float(p.x, p.y - 28, ("%d"):format(n), 4) end
  s.score, s.x, s.y = p.score, nil, nil
  hear(p, s)
end

-- ---- deaths, bombs, phases ----

on.death(function(p)
  p.shards, p.chain, p.gauge = 100 + (p.shards - 100) // DEAD, 0, p.gauge // DEAD
  p.misses = p.misses + 1
end)
on.bomb(function(p) p.used = p.used + 1 end)
on.phase(function(_, _, won, captured)
  game.minions = 0
  player.each(function(p)
    if won then p.worn = 0 end -- a phase that times out doesn't reset it
    if captured then p.captures = p.captures + 1 end
  end)
end)
on.stage(function(_, state)
  if state ~= "start" then return end
  player.each(function(p) p.worn = 0 end)
end)

score.tally {
  { label = "Graze", value = "brushes", points = 200, stage = true },
  { label = "Prisms", value = "prisms", points = 100, stage = true },
  { label = "Best Chain", value = "longest", points = 1000 },
  { label = "Signs Broken", value = "captures", points = 20000, stage = true },
  { label = "No Miss", value = function(p) return p.misses == 0 end, points = 100000 },
  { label = "No Bomb", value = function(p) return p.used == 0 end, points = 50000 },
  { label = "Lives", value = "lives", points = 200000, last = true } }

return scoring

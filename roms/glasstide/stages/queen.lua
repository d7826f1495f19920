-- stages/queen.lua - the floor of the sea: the Queen of the Glass Tide, four phases and the one she comes back with.

-- Opens, hangs, turns aside and goes on: one half of the flower turns the other way.
local function bloom(name, turn, bank)
  return motion.def { name = name,
    { speed = 0.5, over = 34 }, { bank = bank }, { wait = 10 }, { turn = turn, over = 40 }, { speed = 2.1, over = 60 } }
end
local bloom_left, bloom_right = bloom("bloom left", 1.7, 2), bloom("bloom right", -1.7, 7)
local drift = motion.def { { turn = 0.5, over = 120 } }
local swell = motion.def { { speed = 0.6, over = 40 }, { home = 1.2, over = 50 }, { speed = 2.4, over = 30 } }

local function wander(e, over)
  e:move { x = rng.int(80, 160), y = rng.int(62, 92), over = over, ease = "both" }
end

-- 1. Two wheels turn against each other; a volley of blades looks for a way between them.
local function wheels(e)
  task.go(function()
    local n = by_difficulty { easy = 3, normal = 4, hard = 6 }
    while true do
      wait(110)
      pattern.fan { from = e, dy = 4, n = n, spread = 50, aim = true, kind = "kunai", bank = 1, speed = 2.4,
                    each = function(a) a.n, a.speed_to = 3, 3.4 pattern.stack(a) end }
      wander(e, 90)
    end
  end)
  task.go(pattern.spiral, { from = e, dy = -6, kind = "orb", bank = 6, n = forever, arms = by_difficulty { easy = 2, normal = 3, hard = 4 },
                            step = -11, every = 9, speed = 1.4 })
  pattern.spiral { from = e, dy = -6, kind = "rice", bank = 5, n = forever, arms = by_difficulty { easy = 4, normal = 5, hard = 6 }, step = 7,
                   every = 7, speed = 1.7 }
end

-- 2. The water stops. What hangs in it turns white, then half of it looks at you and half goes home.
local function held(e)
  local breath, loose = bullet.group("breath"), 0
  while true do
    local n = by_difficulty { easy = 18, normal = 24, hard = 30 }
    for i = 1, 7 do
      pattern.ring { from = e, dy = -6, kind = "orb", bank = 6, tag = "breath", n = n, dir = 180 * i / n + loose, speed = 2.6 }
      wait(10)
    end
    wait(18)
    breath.speed, breath.bank = 0, 0
    pattern.aimed { from = e, kind = "needle", bank = 3, n = by_difficulty { easy = 4, normal = 6, hard = 9 }, every = 5, speed = 3.2, lock = true }
    wait(30)
    loose = loose + 1
    bullet.each("breath", function(b)
      loose = loose + 1
      if loose % 2 == 0 then
        b:aim(rng.number(-14, 14))
        b.kind = "drop"
        b.bank = 1
      else
        b:turn(180)
        b.bank = 5
      end
      b.tag = "let go"
    end)
    local gone = bullet.group("let go")
    for i = 1, 20 do
      gone.speed = 0.1 * i
      wait(1)
    end
    gone.tag = "past"
    wander(e, 60)
    wait(40)
  end
end

-- 3. Rain from the surface, and all of it sways with the tide.
local function rain_over(e)
  local gap = by_difficulty { easy = 5, normal = 3, hard = 2 }
  while e.alive do
    bullet.fire { kind = "drop", bank = 5, tag = "rain", x = rng.int(-50, 290), y = -10, dir = 90, speed = rng.number(1.1, 1.7) }
    bullet.fire { kind = "rice", bank = 6, tag = "rain", x = rng.int(-50, 290), y = -10, dir = 90, speed = rng.number(1.3, 2.0) }
    wait(gap)
  end
end

local function ebb(e)
  local rain, way = bullet.group("rain"), 1
  task.go(rain_over, e)
  while true do
    wait(60)
    pattern.ring { from = e, kind = "petal", bank = 7, n = by_difficulty { easy = 12, normal = 18, hard = 26 }, dir = rng.dir(), speed = 1.5, motion = drift }
    wait(30)
    for _ = 1, 30 do
      rain:turn(1.5 * way)
      wait(1)
    end
    pattern.fan { from = e, kind = "big", bank = 3, n = by_difficulty { easy = 1, normal = 3, hard = 3 }, spread = 70, aim = true, speed = 1.7 }
    wait(20)
    for _ = 1, 30 do
      rain:turn(-1.5 * way)
      wait(1)
    end
    way = -way
    wander(e, 80)
  end
end

-- 4. A flower a thousand fathoms deep: petals in stacks that open both ways. When she cracks, stars fall out of her.
local function petals(e, turn, motion_name, bank)
  pattern.ring { from = e, dy = -6, n = by_difficulty { easy = 8, normal = 11, hard = 14 }, dir = turn, kind = "petal", bank = bank, speed = 1.6,
                 motion = motion_name, each = function(a) a.n, a.speed_to = 4, 3.6 pattern.stack(a) end }
end

local function flower(e, full)
  local turn, k = 0, 0
  while true do
    petals(e, turn, "bloom left", 3)
    wait(12)
    petals(e, turn + 12, "bloom right", 6)
    turn, k = turn + 23, k + 1
    if k % 3 == 0 then
      pattern.ring { from = e, dy = -6, kind = "bubble", bank = 5, n = 6, aim = true, speed = 1.8, motion = swell }
      wander(e, 60)
    end
    wait(by_difficulty { easy = 74, normal = 60, hard = 46 })
    if e.hp * 2 < full then
      pattern.arc { from = e, dy = -6, kind = "star", bank = 1, n = by_difficulty { easy = 6, normal = 9, hard = 13 }, dir = 20 + turn % 20, sweep = 140,
                    speed = 2.1 }
    end
  end
end

boss.def("queen", { title = "Queen of the Glass Tide", kind = "queen", x = 120, y = 76, phases = {
  { id = "wheels", hp = 1500, time = 45 * 60, run = wheels },
  { id = "held", spell = "Glass Sign: Held Breath", hp = 1600, time = 50 * 60, bonus = 30000, run = held },
  { id = "ebb", spell = "Moon Sign: Ebb and Flow", hp = 1700, time = 50 * 60, bonus = 30000, run = ebb },
  { id = "flower", spell = "Last Sign: Fathomless Flower", hp = 2000, time = 60 * 60, bonus = 60000, run = function(e) flower(e, 2000) end } } })

-- Outlasting her is not enough: she comes back until she breaks.
boss.def("undertow", { title = "Queen of the Glass Tide", kind = "queen", x = 120, y = 76, phases = {
  { id = "again", spell = "The Tide Returns", hp = 900, time = 40 * 60, run = function(e) flower(e, 1800) end } } })

local broken -- the queen's last phase so far was beaten

on.phase(function(_, id, won)
  if id == "flower" or id == "again" then broken = won end
end)

local queen = {}

-- Returns when she is broken.
function queen.fight()
  broken = false
  boss.fight("queen")
  wait(2) -- on.phase comes at the end of the frame
  while not broken and not stage.skipping() do
    boss.fight("undertow")
    wait(2)
  end
end

return queen

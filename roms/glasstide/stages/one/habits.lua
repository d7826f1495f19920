-- stages/one/habits.lua - what each creature fires on its path. All are `run` functions, which end
-- with their creature. Each has its own version for each difficulty.
local rank = require "rank"
local ready = require "pose".ready

local habits = {}

local RUBY, AMBER, GOLD, MAGENTA = 1, 2, 3, 7

-- Two ribbons that cross with every wave.
local ribbon  = motion.def { { wave = 17, every = 84, over = forever } }
local counter = motion.def { { wave = 17, every = 84, phase = 180, over = forever } }

-- Spirals out from a fixed centre; after four seconds, straight on.
local curl_left  = motion.def { { polar = 1.15, spin = 0.55, over = 240 } }
local curl_right = motion.def { { polar = 1.15, spin = -0.55, over = 240 } }

-- Bounces off each side once.
local rebound = motion.def { { bounce = 2, walls = "left right", { bank = GOLD } } }

-- px: creatures don't fire at a ship this near.
local NEAR <const> = 56

local function may_fire(e)
  if not e.alive then return false end
  local p = player.nearest(e.x, e.y)
  if e.y < 0 or e.y > 220 then return false end
  if not (p and p.alive) then return true end
  local dx, dy = p.x - e.x, p.y - e.y
  return dx * dx + dy * dy > NEAR * NEAR
end

-- Spit: a few aimed pellets. The mist shows where they will come from.
function habits.spit(e)
  ready(e, rng.int(16, 44))
  if not may_fire(e) then return end
  local rows = by_difficulty { easy = 1, abyss = 2 }
  for row = 1, rows do
    pattern.aimed { from = e, kind = "pellet", bank = MAGENTA, every = 7,
                    speed = rank.faster(1.6 + 0.3 * row), delay = 20,
                    n = by_difficulty { easy = 1, normal = 2, hard = 4 } }
  end
end

-- Drip: drops one after another, straight down; on hard every third is three drops, on abyss all.
function habits.drip(e)
  ready(e, 20)
  for k = 1, forever do
    local wide = by_difficulty { easy = false, hard = k % 3 == 0, abyss = true }
    if e.y < 200 then
      pattern.fan { from = e, kind = "drop", bank = RUBY, dir = 90, n = wide and 3 or 1,
                    spread = 26, delay = 10,
                    speed = rank.faster(by_difficulty { easy = 1.3, normal = 1.7, hard = 1.9,
                                                      abyss = 1.5 }) }
    end
    ready(e, by_difficulty { easy = 84, normal = 34, hard = 25, abyss = 17 })
  end
end

-- Fan: rice, twice.
function habits.fan(e)
  ready(e, 62)
  for row = 1, 2 do
    if may_fire(e) then
      pattern.fan { from = e, dy = 8, kind = "rice", bank = RUBY, spread = 58, aim = true,
                    speed = rank.faster(1.9), delay = 12,
                    n = by_difficulty { easy = 2, normal = 4 + row, hard = 6 + row,
                                        abyss = 8 + row },
                    each = function(a)
        a.n, a.speed_to = by_difficulty { easy = 1, abyss = 3 }, a.speed + 0.8
        pattern.stack(a)
      end }
    end
    ready(e, 46)
  end
end

-- Wake: two trails that wind around each other; only one on easy, with extra pellets on abyss.
function habits.wake(e)
  ready(e, 24)
  for k = 1, forever do
    local speed = by_difficulty { easy = 1.1, normal = 1.3, hard = 1.5, abyss = 1.4 }
    bullet.fire { from = e, dx = -12, kind = "petal", bank = MAGENTA, speed = speed,
                  motion = ribbon }
    if by_difficulty { easy = false, normal = true } then
      bullet.fire { from = e, dx = 12, kind = "petal", bank = RUBY, speed = speed,
                    motion = counter }
    end
    if by_difficulty { easy = false, abyss = k % 2 == 0 } then
      pattern.fan { from = e, kind = "pellet", bank = 0, n = 2, spread = 120, dir = 90,
                    speed = 1.2 }
    end
    ready(e, by_difficulty { easy = 17, normal = 11, hard = 8, abyss = 8 })
  end
end

-- Pulse: rings that open like a flower, turning left and right alternately.
function habits.pulse(e)
  ready(e, 80)
  for k = 1, forever do
    local left = k % 2 == 0
    pattern.ring { from = e, kind = "orb", bank = left and AMBER or MAGENTA, dir = 11 * k,
                   speed = 1.15, n = by_difficulty { easy = 8, normal = 13, hard = 18, abyss = 20 },
                   motion = left and curl_left or curl_right }
    ready(e, by_difficulty { easy = 96, normal = 56, hard = 48, abyss = 42 })
  end
end

-- Gild: warm-coloured fish fire gold fans, each wider than the last.
function habits.gild(e)
  e.bank = 1
  ready(e, 62)
  for i = 1, by_difficulty { easy = 2, normal = 3, abyss = 4 } do
    if may_fire(e) then
      pattern.fan { from = e, dy = 8, kind = "kunai", bank = GOLD, spread = 24 * i, aim = true,
                    speed = rank.faster(2.2), delay = 12,
                    n = by_difficulty { easy = 2, normal = 4, hard = 6, abyss = 8 } }
    end
    ready(e, 30)
  end
end

-- Bristle: rotating rings of needles.
function habits.bristle(e)
  ready(e, 40)
  local turn = rng.dir()
  while e.y < 250 do
    pattern.ring { from = e, kind = "needle", bank = GOLD, dir = turn,
                   speed = rank.faster(by_difficulty { easy = 1.6, normal = 1.8, abyss = 1.6 }),
                   n = by_difficulty { easy = 3, normal = 6, abyss = 8 } }
    turn = turn + 17
    ready(e, rank.sooner(by_difficulty { easy = 40, normal = 20, hard = 17 }))
  end
end

-- Whorl: a spiral of stars, and pearls that bounce off the walls on both sides.
function habits.whorl(e)
  ready(e, 70)
  task.go(function()
    while true do
      pattern.fan { from = e, kind = "pearl", bank = AMBER, n = 2, spread = 100, speed = 1.8,
                    motion = rebound }
      ready(e, by_difficulty { easy = 120, normal = 84, hard = 64, abyss = 48 })
    end
  end)
  pattern.spiral { from = e, kind = "star", bank = RUBY, n = 64, step = 13, every = 5, speed = 1.6,
                   arms = by_difficulty { easy = 2, normal = 3, hard = 4 } }
end

-- Arrow Salvo: splinters in the shape of an arrow, aimed.
local ARROW = { { 0, 0 }, { -8, 6 }, { -8, -6 }, { -16, 12 }, { -16, -12 }, { -10, 0 }, { -20, 0 } }
local SHORT = { { 0, 0 }, { -8, 6 }, { -8, -6 } }

function habits.salvo(e)
  ready(e, 56)
  for _ = 1, by_difficulty { easy = 1, normal = 2, hard = 3 } do
    spark.burst { kind = "shock", from = e, speed = 0 }
    ready(e, 26)
    if may_fire(e) then
      sound.play("snap", { from = e })
      pattern.fan { from = e, dy = 14, kind = "shard", bank = MAGENTA, aim = true, spread = 76,
                    n = by_difficulty { easy = 1, hard = 2, abyss = 3 }, speed = rank.faster(2.1),
                    delay = 20,
                    each = function(a)
        a.list, a.turns, a.aim = by_difficulty { easy = SHORT, normal = ARROW }, true, nil
        pattern.points(a)
      end }
    end
    ready(e, 40)
  end
end

-- Bubble Chain: bubbles that sway as they drift down, and burst into splinters.
local function drift(n)
  return motion.def { { wave = 14, every = 70, over = 96 },
    { emit = { pattern = "ring", n = n, kind = "chip", bank = AMBER, speed = 1.2,
              delay = 20 } },
    { die = true } }
end
local DRIFTS = { easy = drift(5), normal = drift(8), hard = drift(11), abyss = drift(14) }

function habits.bubbles(e)
  ready(e, 50)
  while true do
    if e.y < 160 then
      pattern.fan { from = e, dy = -8, kind = "bubble", bank = AMBER, dir = 90, spread = 70,
                    n = by_difficulty { easy = 1, normal = 2, hard = 3 }, speed = 1.1, delay = 16,
                    motion = by_difficulty(DRIFTS) }
    end
    ready(e, by_difficulty { easy = 150, normal = 84, hard = 76, abyss = 56 })
  end
end

-- Bloom: a flower's petals fly off in two rings that turn against each other.
function habits.bloom(e)
  for k = 1, by_difficulty { easy = 3, normal = 4, hard = 5 } do
    if e.y > 190 then return end
    for way = 0, by_difficulty { easy = 0, normal = 1 } do
      pattern.ring { from = e, kind = "petal", bank = way == 0 and MAGENTA or AMBER, dir = 13 * k,
                     n = by_difficulty { easy = 9, normal = 11, hard = 15, abyss = 18 }, speed = 1.7, delay = 12,
                     motion = way == 0 and curl_left or curl_right }
    end
    wait(by_difficulty { easy = 58, normal = 46, hard = 36, abyss = 30 })
  end
end

-- Pollen: three arms of stars sweep around.
function habits.pollen(e)
  for k = 1, forever do
    if e.y > 200 then return end
    pattern.ring { from = e, kind = "star", bank = GOLD, dir = 17 * k, speed = rank.faster(1.6),
                   n = by_difficulty { easy = 2, normal = 3, hard = 4, abyss = 5 } }
    wait(by_difficulty { easy = 16, normal = 9, hard = 7, abyss = 6 })
  end
end

-- Gaze: fans that close around you, volley by volley.
function habits.gaze(e)
  for k = 1, forever do
    if may_fire(e) then
      pattern.fan { from = e, kind = "kunai", bank = RUBY, aim = true, speed = rank.faster(1.9), delay = 16,
                    spread = 120 - 28 * (k % 4), n = by_difficulty { easy = 2, normal = 4, hard = 6, abyss = 8 } }
    end
    wait(rank.sooner(by_difficulty { easy = 60, normal = 38, hard = 30, abyss = 24 }))
  end
end

return habits

-- stages/one/crab.lua - the boss at the end of the shallows: the Chandelier Crab, five phases. Its
-- claws are parts and can break off; the shell then fires other patterns in their place.
local meeting = require "stages/one/meeting"
local pose = require "pose"
local rank = require "rank"

local RUBY, AMBER, GOLD, MAGENTA = 1, 2, 3, 7

-- The two claws, left and right, dead or alive.
local function claws(e)
  return { e:parts("left claw")[1], e:parts("right claw")[1] }
end

local function either(e, f)
  local both = claws(e)
  for i = 1, 2 do f(both[i], i == 1 and -1 or 1) end
end

local function wander(e, over)
  e:move { x = rng.int(86, 154), y = rng.int(84, 100), over = over, ease = "both" }
end

-- 1. Both claws sweep the sides and snap at a ship between them. A stump fires slow rings.
local function snapping(speed)
  return motion.def { { speed = 0.8, over = 12 }, { aim = true }, { speed = speed, over = 24 } }
end
local snap = { easy = snapping(2.4), normal = snapping(2.6), hard = snapping(2.4),
               abyss = snapping(2.2) }

local function sweep(e, side)
  local dir = 90 + 60 * side
  for k = 1, forever do
    local claw = claws(e)[side < 0 and 1 or 2]
    if claw and claw.alive then
      pattern.fan { from = claw, dy = 14, kind = "rice", bank = side < 0 and MAGENTA or RUBY,
                    spread = 20, dir = dir, n = by_difficulty { easy = 2, hard = 3 },
                    speed = rank.faster(by_difficulty { easy = 1.6, normal = 1.8, hard = 1.7,
                                                        abyss = 1.5 }) }
    elseif k % 8 == 0 then
      pattern.ring { from = e, dx = 43 * side, dy = 17, kind = "orb",
                     bank = side < 0 and MAGENTA or RUBY, dir = dir, speed = 1.3,
                     n = by_difficulty { easy = 8, normal = 12, hard = 16, abyss = 20 } }
    end
    dir = dir - 13 * side
    wait(by_difficulty { easy = 28, normal = 20, hard = 16, abyss = 14 })
  end
end

local function pincers(e)
  task.go(sweep, e, -1)
  task.go(sweep, e, 1)
  for k = 1, forever do
    wait(by_difficulty { easy = 100, normal = 83, hard = 70, abyss = 67 })
    if by_difficulty { easy = false, abyss = true } then
      pattern.ring { from = e, kind = "pellet", bank = 0, dir = 11 * k, speed = 1, n = 17 }
    end
    wait(by_difficulty { easy = 50, normal = 46, hard = 42 })
    pose.attack(e, 40)
    either(e, function(claw, side)
      local at = claw and claw.alive and { claw, 0, 24 } or { e, 43 * side, 20 }
      sound.play("snap", { from = e })
      pattern.line { from = at[1], dx = at[2], dy = at[3], kind = "kunai", bank = AMBER, dir = 90,
                     width = by_difficulty { easy = 24, normal = 28, hard = 30, abyss = 32 },
                     speed = 2.2, delay = 24,
                     motion = by_difficulty(snap),
                     n = by_difficulty { easy = 1, normal = 2, abyss = 3 } }
    end)
    wander(e, 50)
  end
end

-- 2. Rings bounce off the walls and turn gold.
local echo = motion.def { { bounce = 1, walls = "left right top", { bank = GOLD } } }

local function grotto(e)
  for k = 1, forever do
    pose.attack(e, 70)
    for i = 1, by_difficulty { easy = 1, normal = 2, abyss = 3 } do
      pattern.ring { from = e, kind = "ring", bank = AMBER, dir = 11 * (k + i),
                     speed = by_difficulty { easy = 1.5, normal = 1.6, abyss = 1.4 },
                     n = by_difficulty { easy = 7, normal = 10, hard = 13, abyss = 18 },
                     motion = echo }
      wait(by_difficulty { easy = 30, hard = 28, abyss = 24 })
    end
    either(e, function(claw, side)
      local held = claw and claw.alive
      pattern.whip { from = held and claw or e, dx = held and 0 or 43 * side, dy = 18,
                     kind = "kunai", bank = RUBY, aim = true,
                     speed = by_difficulty { easy = 1.7, abyss = 1.5 }, speed_to = 2.8,
                     bend = 30 * side, delay = 14,
                     n = by_difficulty { easy = 1, normal = 3, hard = 4, abyss = 6 } }
    end)
    wander(e, 50)
    wait(by_difficulty { easy = 130, normal = 110, hard = 80, abyss = 56 })
  end
end

-- 3. Its lamps cast rays that rotate one way, then the other. Move along with the rays, between
-- the rings.
local function lamplight(e)
  for k = 1, forever do
    local n = by_difficulty { easy = 3, normal = 4, hard = 5 }
    local way = k % 2 == 0 and -1 or 1
    local p = player.nearest(e.x, e.y)
    -- starts with the player between two rays
    local dir = (p and p.alive and angle.to(e, p) or 90) + 180 / n
    for i = 1, n do
      laser.beam { kind = "ray", bank = GOLD, follow = e, dy = 4, dir = dir + 360 * i / n,
                   length = 380, warn = 56, hold = 260, fade = 20,
                   spin = way * by_difficulty { easy = 0.14, normal = 0.15, abyss = 0.26 } }
    end
    sound.play("charge", { from = e })
    wait(56)
    sound.play("beam", { from = e })
    pose.attack(e, 180)
    wait(14)
    for i = 1, by_difficulty { easy = 6, normal = 8, hard = 9, abyss = 8 } do
      local even = i % 2 == 0
      pattern.ring { from = e, kind = even and "orb" or "pellet", bank = even and MAGENTA or RUBY,
                     dir = 17 * (k + i), speed = 1.3,
                     n = by_difficulty { easy = 12, normal = 22, hard = 28, abyss = 27 } }
      if even then -- and some wax, aimed
        pattern.fan { from = e, dy = 10, kind = "drop", bank = AMBER, aim = true, speed = 1.6,
                      spread = 44, delay = 20, n = by_difficulty { easy = 1, normal = 3,
                                                                   abyss = 5 } }
      end
      wait(by_difficulty { easy = 40, normal = 26, hard = 24, abyss = 32 })
    end
    wander(e, 60)
    wait(64)
  end
end

-- 4. Lamps circle the crab. They fall one after another and shed light to both sides; a lamp that
-- is shot down clears the bullets around it.
local hang = motion.def {
  { orbit = 0, radius_to = 62, spin = 1.6, over = 50 }, { orbit = 62, spin = 1.6, over = forever } }
-- It sheds a limited number of times, so that it has stopped before it reaches you.
local function falling(every, n, times)
  local shed = { pattern = "fan", n = n, spread = 180, kind = "pellet", bank = MAGENTA,
                 speed = 0.8, delay = 20 }
  return motion.def { { speed = 0, over = 12 }, { bank = RUBY }, { wait = "rest" }, { aim = true },
    { speed = 2.3, over = 30 }, { loop = times, { wait = every }, { emit = shed } } }
end
local fall = { easy = motion.def { { speed = 0, over = 12 }, { bank = RUBY }, { wait = "rest" },
                                   { aim = true }, { speed = 2.3, over = 30 } },
               normal = falling(30, 2, 2), hard = falling(16, 3, 3), abyss = falling(12, 4, 5) }
-- A bubble slows down, bursts, and becomes a falling splinter.
local crack = motion.def {
  { speed = 0.2, over = 40 }, { kind = "shard", bank = MAGENTA, speed = 0.3 }, { dir = 90 },
  { speed = 2.2, over = 50 } }
local CRACKS = { RUBY, MAGENTA, GOLD }

-- Wax between the falling lamps.
local function drips(e)
  while true do
    wait(by_difficulty { easy = 160, normal = 50, hard = 34, abyss = 30 })
    pattern.fan { from = e, dy = 14, kind = "drop", bank = AMBER, aim = true, spread = 50,
                  speed = 1.7, delay = 20, n = by_difficulty { easy = 1, hard = 3, abyss = 5 } }
  end
end

local function chandelier(e)
  local lamps = bullet.group("lamp")
  task.go(drips, e)
  for k = 1, forever do
    local n = by_difficulty { easy = 4, normal = 5, hard = 6, abyss = 8 }
    for i = 1, n do
      bullet.fire { kind = "lamp", from = e, bank = AMBER, dir = 360 * i / n, speed = 0,
                    tag = "lamp", around = e, motion = hang, rest = 18 * i }
    end
    wait(50)
    pose.attack(e, 60)
    for i = 1, by_difficulty { easy = 3, hard = 4 } do
      pattern.ring { from = e, kind = "ring", bank = CRACKS[i % 3 + 1], dir = 9.5 * (3 * k + i),
                     speed = 1.4 + i, motion = crack,
                     n = by_difficulty { easy = 11, normal = 26, hard = 44, abyss = 42 } }
      wait(14)
    end
    wander(e, 50)
    wait(by_difficulty { easy = 60, hard = 28, abyss = 32 })
    lamps.motion = by_difficulty(fall)
    lamps.tag = "fallen"
    wait(by_difficulty { easy = 100, normal = 54, hard = 18 })
  end
end

-- 5. Every lamp it has taken drifts out over the water: slow rings spiral through each other in
-- both directions, and wax drips. Find the lanes; they turn.
local function lights(v, spin) return motion.def { { polar = v, spin = spin, over = 420 } } end
local ebbing = { easy = { lights(1.0, 0.2), lights(1.0, -0.2) },
                 normal = { lights(1.0, 0.24), lights(1.0, -0.24) },
                 hard = { lights(1.05, 0.26), lights(1.05, -0.26) },
                 abyss = { lights(0.7, 0.16), lights(0.7, -0.16) } }

local function wax(e)
  while true do
    wait(by_difficulty { easy = 150, normal = 110, hard = 84, abyss = 56 })
    pose.attack(e, 40)
    for i = -1, 1, 2 do
      pattern.aimed { from = e, dx = 36 * i, dy = -14, kind = "drop", bank = RUBY, every = 6,
                      n = by_difficulty { easy = 1, normal = 2, hard = 3, abyss = 4 },
                      speed = 2.0, lock = true, delay = 12 }
    end
  end
end

local function harbour(e)
  local ways = by_difficulty(ebbing)
  task.go(wax, e)
  e:move { x = 120, y = 90, over = 60, ease = "both" }
  wait(40)
  for k = 1, forever do
    local left = k % 2 == 0
    pattern.ring { from = e, kind = left and "orb" or "pellet", bank = left and AMBER or MAGENTA,
                   n = by_difficulty { easy = 9, normal = 16, hard = 22, abyss = 40 },
                   dir = (left and 5 or -5) * k, speed = 1, motion = ways[left and 1 or 2] }
    wait(by_difficulty { easy = 45, normal = 34, hard = 24, abyss = 14 })
  end
end

local FOAM = { items = "foam", spark = "pop" } -- what its bullets become when a phase is beaten

boss.def("crab", { title = "Chandelier Crab", kind = "crab", x = 120, y = 92, music = "claws",
                   epithet = "Keeper of the Shallows", entrance = "bubbles",
                   portrait = "crab_cross", cut_in = "crab_cut_in", warning = 120, hurt = "crab_hurt", broken = "crab_broken", phases = {
  { talk = meeting },
  { id = "pincers", hp = 1000, time = 30 * 60, run = pincers, clear = FOAM, drops = { pearl = 5 } },
  { id = "grotto", spell = "Echo Sign: Grotto of Rings", hp = 1100, time = 35 * 60, bonus = 15000,
    bonus_to = 5000, run = grotto, clear = FOAM, drops = { pearl = 8 } },
  { id = "lamplight", spell = "Light Sign: Waltz of Lamps", hp = 1100, time = 35 * 60,
    bonus = 15000, bonus_to = 5000, run = lamplight, clear = FOAM, drops = { conch = 1 } },
  { id = "chandelier", spell = "Shell Sign: Falling Chandelier", hp = 900, time = 40 * 60,
    bonus = 20000, bonus_to = 6000, run = chandelier, clear = FOAM, drops = { pearl = 6 } },
  { id = "harbour", spell = "Last Sign: Harbour Lights", hp = 1400, time = 45 * 60,
    bonus = 30000, bonus_to = 10000, run = harbour, clear = FOAM,
    drops = { pearl = 8, heart = 1 } } } })

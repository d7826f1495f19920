-- stages/two/bellows.lua - halfway through the works: the Bellows, a ray that breathes bubbles.
local pose = require "pose"
local rank = require "rank"

local function wander(e, over)
  e:move { x = rng.int(86, 154), y = rng.int(78, 94), over = over, ease = "both" }
end

-- 1. Bubbles slow down, stop, and burst into rings; on abyss, the orbs of the rings burst
-- again. After a while it blows them in a row from side to side.
motion.def { name = "crumble", { wait = 70 },
  { emit = { pattern = "fan", n = 2, spread = 60, kind = "pellet", bank = 7, speed = 1.3 } },
  { die = true } }
local function bubble(n, after)
  return motion.def { { speed = 0.35, over = 56 }, { wait = 6 },
    { emit = { pattern = "ring", n = n, kind = "orb", bank = after and 6 or 5, speed = 1.3,
               motion = after } },
    { die = true } }
end
local bubbles = { easy = bubble(7), normal = bubble(10), hard = bubble(15),
                  abyss = bubble(10, "crumble") }

local BLOWS <const> = 3 -- breaths before the first row

local function blow(e, way)
  for i = -1, 1, by_difficulty { easy = 1, normal = 0.5 } do
    bullet.fire { from = e, dy = 30, kind = "gob", bank = 7, dir = 90 + 66 * i * way, speed = rank.faster(2.1),
                  motion = by_difficulty(bubbles) }
    wait(9)
  end
end

local function breath(e)
  wait(20)
  for k = 1, forever do
    sound.play("steam", { from = e })
    pose.attack(e, 40)
    if k > BLOWS then
      blow(e, k % 2 == 0 and 1 or -1)
    else
      pattern.fan { from = e, dy = 30, kind = "gob", bank = 7, dir = 90 + 16 * angle.sin(67 * k), spread = 110,
                    speed = rank.faster(2.1), n = by_difficulty { easy = 2, hard = 3 },
                    motion = by_difficulty(bubbles) }
    end
    wait(rank.sooner(by_difficulty { easy = 80, normal = 61, hard = 59, abyss = 56 }))
    pattern.fan { from = e, dy = 30, kind = "kunai", bank = 5, aim = true, spread = 44,
                  speed = by_difficulty { easy = 1.6, hard = 1.8, abyss = 1.5 },
                  n = by_difficulty { easy = 1, hard = 3 }, each = function(a)
      a.n, a.speed_to = by_difficulty { easy = 1, normal = 2, hard = 4 }, a.speed + 0.9
      pattern.stack(a)
    end }
    wander(e, 50)
    wait(rank.sooner(by_difficulty { easy = 102, normal = 89, hard = 97, abyss = 64 }))
  end
end

-- 2. It breathes in, and drops along the walls fly to its mouth. Then it breathes out wave after
-- wave; each has a gap, which moves to and fro from wave to wave, in
-- the other direction with each breath.
local MOUTH_X <const>, MOUTH_Y <const> = 120, 118
local drawn = motion.def { { go_to = { MOUTH_X, MOUTH_Y }, over = 70, ease = "in" },
                           { die = true } }

local function inhale()
  local rows = by_difficulty { easy = 5, normal = 7, hard = 9, abyss = 11 }
  for i = 1, rows do
    for side = 0, 1 do
      bullet.fire { kind = "drop", bank = 5, x = side == 0 and 6 or 234, y = 18 + 14 * i,
                    dir = 180 * side, speed = 0.4, delay = 24 + 2 * i, motion = drawn }
    end
  end
  wait(74 + 2 * rows)
end

local function exhale(first, way)
  local n = by_difficulty { easy = 28, normal = 43, hard = 50, abyss = 70 }
  local wide = by_difficulty { easy = 6, normal = 5, hard = 4 }
  local swing = way * by_difficulty { easy = 9, normal = 14, hard = 20, abyss = 16 }
  local waves = by_difficulty { easy = 7, normal = 9, hard = 11, abyss = 26 }
  for i = 1, waves do
    local odd = i % 2 == 1
    pattern.ring { x = MOUTH_X, y = MOUTH_Y, n = n, skip = { n - wide + 1, n },
                   bank = odd and 7 or 6,
                   kind = odd and by_difficulty { easy = "ring", abyss = "pellet" } or "orb",
                   speed = by_difficulty { easy = 1.2, normal = 1.35, hard = 1.5, abyss = 0.95 },
                   dir = 90 + 30 * angle.sin(first + swing * i) + 180 * (wide + 1) / n }
    if i % by_difficulty { easy = 99, normal = 6, hard = 5, abyss = 7 } == 0 then
      pattern.aimed { x = MOUTH_X, y = MOUTH_Y, kind = "kunai", bank = 5, speed = 1.9, every = 6,
                      n = by_difficulty { normal = 1, hard = 2, abyss = 3 }, delay = 20 }
    end
    wait(by_difficulty { easy = 24, normal = 19, hard = 17, abyss = 11 })
  end
  return first + swing * waves
end

local function draught(e)
  local swung = rng.dir()
  e:move { x = 120, y = 86, over = 40, ease = "both" }
  wait(30)
  for k = 1, forever do
    sound.play("charge", { from = e })
    inhale()
    sound.play("steam", { from = e })
    pose.attack(e, 160)
    swung = exhale(swung, k % 2 == 0 and -1 or 1)
    pattern.fan { from = e, dy = 30, kind = "gob", bank = 5, aim = true, spread = 70, speed = 1.6,
                  delay = 20, n = by_difficulty { easy = 1, normal = 2, hard = 3, abyss = 4 } }
    wait(by_difficulty { easy = 50, normal = 30, hard = 20, abyss = 30 })
  end
end

-- 3. Wheels come down side by side; their teeth mesh. Every third time, wheels cross from the corners.
local REACH <const> = 30 -- px from a wheel's hub to its teeth

local function teeth(name, spin)
  motion.def { name = name, { orbit = 6, radius_to = REACH, spin = spin, over = 40 },
    { orbit = REACH, spin = spin, over = forever }, { die = true } }
end
teeth("teeth left", 1.3)
teeth("teeth right", -1.3)

local function wheel(x, y, dir, left, speed)
  local count = by_difficulty { easy = 5, hard = 6, abyss = 7 }
  local hub = bullet.fire { kind = "cog", bank = 0, x = x, y = y, dir = dir, speed = speed,
                            delay = 20 }
  for i = 1, count do
    bullet.fire { kind = "ingot", bank = left and 6 or 7, x = x, y = y, speed = 0, around = hub,
                  dir = 360 * (i + (left and 0 or 0.5)) / count, delay = 20,
                  motion = left and "teeth left" or "teeth right" }
  end
end

local function wheels(e)
  wait(30)
  for k = 1, forever do
    local speed = by_difficulty { easy = 0.8, normal = 0.9, hard = 0.95, abyss = 1 }
    local n = by_difficulty { easy = 2, hard = 3 }
    sound.play("gear", { from = e })
    pose.attack(e, 60)
    if k % 3 == 0 then
      for side = -1, 1, 2 do wheel(120 + 96 * side, 40, 90 + 32 * side, side < 0, 1.2 * speed) end
    else
      for i = 1, n do
        wheel(120 + 62 * (i - (n + 1) / 2) + 24 * angle.sin(90 * k), 52, 90, (i + k) % 2 == 0, speed)
      end
    end
    wait(40)
    pattern.fan { from = e, dy = 26, kind = "orb", bank = 5, aim = true, spread = 90, speed = 1.5,
                  n = by_difficulty { easy = 2, normal = 3, hard = 5, abyss = 6 } }
    wander(e, 50)
    wait(by_difficulty { easy = 141, normal = 130, hard = 140, abyss = 85 })
  end
end

local FOAM = { items = "foam", spark = "pop" } -- what its bullets become when a phase is beaten

boss.def("bellows", { title = "The Bellows", kind = "bellows", x = 120, y = 86, music = "lantern",
                      entrance = "bubbles", bg = "hearth", hurt = "bellows_hurt", broken = "bellows_broken",
                      phases = {
  { id = "breath", hp = 1560, time = 30 * 60, run = breath, clear = FOAM, drops = { pearl = 5 } },
  { id = "draught", spell = "Breath Sign: Held Draught", hp = 1500, time = 34 * 60, bonus = 12000,
    bonus_to = 4000, run = draught, clear = FOAM, drops = { pearl = 6 } },
  { id = "wheels", spell = "Gear Sign: Meshing Wheels", hp = 1500, time = 34 * 60, bonus = 15000,
    bonus_to = 5000, run = wheels, clear = FOAM, drops = { conch = 1 } } } })

-- stages/two/bellows.lua - halfway through the works: the Bellows, a ray that breathes molten
-- glass.

local function wander(e, over)
  e:move { x = rng.int(86, 154), y = rng.int(66, 86), over = over, ease = "both" }
end

-- 1. Bubbles: each slows down, stands, and falls apart; in the abyss what is left of it does so
-- again.
motion.def { name = "crumble", { wait = 70 },
  { emit = { pattern = "fan", n = 2, spread = 60, kind = "pellet", bank = 7, speed = 1.3 } },
  { die = true } }
local function bubble(n, after)
  return motion.def { { speed = 0.35, over = 56 }, { wait = 6 },
    { emit = { pattern = "ring", n = n, kind = "orb", bank = after and 6 or 5, speed = 1.3,
               motion = after } },
    { die = true } }
end
local bubbles = { easy = bubble(7), normal = bubble(11), hard = bubble(14),
                  abyss = bubble(12, "crumble") }

local function breath(e)
  wait(20)
  for k = 1, forever do
    sound.play("steam", { from = e })
    local turn = 16 * angle.sin(67 * k)
    pattern.fan { from = e, dy = 30, kind = "gob", bank = 7, dir = 90 + turn, spread = 110,
                  speed = 2.1,
                  n = by_difficulty { easy = 2, normal = 3, hard = 4, abyss = 5 },
                  motion = by_difficulty(bubbles) }
    wait(by_difficulty { easy = 60, normal = 46, hard = 34, abyss = 34 })
    pattern.stack { from = e, dy = 30, kind = "kunai", bank = 5, aim = true, speed = 1.7,
                    speed_to = 2.7,
                    n = by_difficulty { easy = 1, normal = 3, hard = 4, abyss = 5 } }
    wander(e, 50)
    wait(by_difficulty { easy = 70, normal = 52, hard = 44, abyss = 40 })
  end
end

-- 2. It draws in its breath: what lies along the walls goes home to it. Then it lets go, wave after
-- wave, and every
-- wave has a gap a little further on.
local MOUTH_X <const>, MOUTH_Y <const> = 120, 106
local drawn = motion.def { { go_to = { MOUTH_X, MOUTH_Y }, over = 70, ease = "in" },
                           { die = true } }

local function inhale()
  local rows = by_difficulty { easy = 5, normal = 7, hard = 9, abyss = 11 }
  for i = 1, rows do
    for side = 0, 1 do
      bullet.fire { kind = "drop", bank = 5, x = side == 0 and 6 or 234, y = 18 + 14 * i,
                    dir = 180 * side,
                    speed = 0.4, delay = 24 + 3 * i, motion = drawn }
    end
  end
  wait(100 + 3 * rows)
end

local function exhale(k)
  local n = by_difficulty { easy = 26, normal = 34, hard = 42, abyss = 56 }
  local wide = by_difficulty { easy = 5, normal = 5, hard = 5, abyss = 5 }
  local way, turn = k % 2 == 0 and 1 or -1, rng.int(-24, 24)
  for i = 1, by_difficulty { easy = 5, normal = 7, hard = 8, abyss = 12 } do
    pattern.ring { x = MOUTH_X, y = MOUTH_Y, kind = i % 2 == 0 and "orb" or "ring", n = n,
                   bank = i % 2 == 0 and 6 or 7, speed = by_difficulty { easy = 1.2, normal = 1.35,
                                                                         hard = 1.45,
                                                                         abyss = 1.2 },
                   dir = 90 + turn + way * 7 * i + 180 * wide / n, skip = { n - wide + 1, n } }
    wait(by_difficulty { easy = 26, normal = 21, hard = 18, abyss = 16 })
  end
end

local function draught(e)
  e:move { x = 120, y = 74, over = 40, ease = "both" }
  wait(40)
  for k = 1, forever do
    sound.play("charge", { from = e })
    inhale()
    sound.play("steam", { from = e })
    exhale(k)
    wait(by_difficulty { easy = 60, normal = 40, hard = 30, abyss = 20 })
  end
end

-- 3. Wheels come down side by side; the teeth of each go between those of the next.
local REACH <const> = 30 -- px from a wheel's hub to its teeth
motion.def { name = "teeth left",
  { orbit = 6, radius_to = REACH, spin = 1.3, over = 40 }, { orbit = REACH, spin = 1.3,
                                                             over = forever },
  { die = true } }
motion.def { name = "teeth right",
  { orbit = 6, radius_to = REACH, spin = -1.3, over = 40 }, { orbit = REACH, spin = -1.3,
                                                              over = forever },
  { die = true } }

local function wheel(x, y, left, speed)
  local teeth = by_difficulty { easy = 5, normal = 6, hard = 8, abyss = 10 }
  local hub = bullet.fire { kind = "cog", bank = 0, x = x, y = y, dir = 90, speed = speed,
                            delay = 20 }
  for i = 1, teeth do
    bullet.fire { kind = "ingot", bank = left and 6 or 7, x = x, y = y, speed = 0, around = hub,
                  dir = 360 * (i + (left and 0 or 0.5)) / teeth, delay = 20,
                  motion = left and "teeth left" or "teeth right" }
  end
end

local function wheels(e)
  wait(30)
  for k = 1, forever do
    local speed = by_difficulty { easy = 0.8, normal = 0.9, hard = 1, abyss = 1 }
    local n = by_difficulty { easy = 2, normal = 3, hard = 3, abyss = 4 }
    sound.play("gear", { from = e })
    for i = 1, n do
      wheel(120 + 62 * (i - (n + 1) / 2) + 24 * angle.sin(90 * k), 40, (i + k) % 2 == 0, speed)
    end
    wait(40)
    pattern.fan { from = e, dy = 26, kind = "orb", bank = 5, aim = true, spread = 90, speed = 1.5,
                  n = by_difficulty { easy = 2, normal = 4, hard = 6, abyss = 8 } }
    wander(e, 50)
    wait(by_difficulty { easy = 90, normal = 66, hard = 52, abyss = 44 })
  end
end

local FOAM = { items = "foam", spark = "pop" } -- what is left of its bullets when a phase is beaten

boss.def("bellows", { title = "The Bellows", kind = "bellows", x = 120, y = 74, music = "lantern",
                      phases = {
  { id = "breath", hp = 560, time = 20 * 60, run = breath, clear = FOAM, drops = { pearl = 5 } },
  { id = "draught", spell = "Breath Sign: Held Draught", hp = 640, time = 26 * 60, bonus = 12000,
    run = draught,
    clear = FOAM, drops = { pearl = 6 } },
  { id = "wheels", spell = "Gear Sign: Meshing Wheels", hp = 700, time = 26 * 60, bonus = 15000,
    run = wheels,
    clear = FOAM, drops = { conch = 1 } } } })

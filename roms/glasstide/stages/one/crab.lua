-- stages/guard.lua - halfway down: the Chandelier Crab.

-- A bubble slows, bursts, and is a splinter that falls.
motion.def { name = "burst",
  { speed = 0.2, over = 40 }, { kind = "shard", bank = 5, speed = 0.3 }, { dir = 90 },
  { speed = 2.3, over = 50 } }
local snap = motion.def { { speed = 0.8, over = 12 }, { aim = true }, { speed = 3, over = 20 } }

-- 1. Both claws sweep the sides, and snap at whoever is between them.
local function claw(e, side)
  local dir = 90 + 60 * side
  while true do
    pattern.fan { from = e, dx = 26 * side, dy = 20, kind = "rice", bank = side < 0 and 6 or 7,
                  spread = 20, dir = dir, speed = 1.9,
                  n = by_difficulty { easy = 2, normal = 3, hard = 4 } }
    dir = dir - 13 * side
    wait(by_difficulty { easy = 9, normal = 6, hard = 5 })
  end
end

local function pincers(e)
  task.go(claw, e, -1)
  task.go(claw, e, 1)
  while true do
    wait(84)
    for side = -1, 1, 2 do
      pattern.line { from = e, dx = 26 * side, dy = 32, kind = "kunai", bank = 2, width = 40,
                     dir = 90, speed = 2.4, delay = 22, motion = snap,
                     n = by_difficulty { easy = 3, normal = 5, hard = 7 } }
    end
    e:move { x = rng.int(80, 160), y = rng.int(60, 84), over = 50, ease = "both" }
  end
end

-- 2. What goes to the walls comes back from them, once, and then it is gold.
local echo = motion.def { { bounce = 1, walls = "left right top", { bank = 3 } } }

local function grotto(e)
  for k = 1, forever do
    for i = 1, 2 do
      pattern.ring { from = e, kind = "ring", bank = 4, dir = 11 * (k + i), speed = 1.6,
                     n = by_difficulty { easy = 10, normal = 15, hard = 22 }, motion = echo }
      wait(24)
    end
    for side = -1, 1, 2 do
      pattern.whip { from = e, dx = 26 * side, dy = 20, kind = "kunai", bank = 1, aim = true,
                     speed = 1.7, speed_to = 3.2, bend = 30 * side,
                     n = by_difficulty { easy = 3, normal = 5, hard = 8 } }
    end
    e:move { x = rng.int(70, 170), y = rng.int(56, 84), over = 50, ease = "both" }
    wait(by_difficulty { easy = 76, normal = 58, hard = 46 })
  end
end

-- 3. It turns its lamps on you: rays that go round, one way and then the other. You go along with
-- them, between the rings that it lets go.
local function lamplight(e)
  for k = 1, forever do
    local n = by_difficulty { easy = 3, normal = 4, hard = 5 }
    local way = k % 2 == 0 and -1 or 1
    local p = player.nearest(e.x, e.y)
    local dir = (p and angle.to(e, p) or 90) + 180 / n -- whoever is there stands between two
    for i = 1, n do
      laser.beam { kind = "ray", bank = 3, follow = e, dy = -4, dir = dir + 360 * i / n,
                   length = 380, warn = 56, hold = 260, fade = 20,
                   spin = way * by_difficulty { easy = 0.22, normal = 0.3, hard = 0.36 } }
    end
    sound.play("charge", { from = e })
    wait(56)
    sound.play("beam", { from = e })
    wait(14)
    for i = 1, 5 do
      pattern.ring { from = e, kind = i % 2 == 0 and "orb" or "pellet", bank = i % 2 == 0 and 6 or 5,
                     dir = 17 * (k + i), speed = 1.3,
                     n = by_difficulty { easy = 7, normal = 11, hard = 16 } }
      wait(50)
    end
    e:move { x = rng.int(80, 160), y = rng.int(60, 84), over = 60, ease = "both" }
    wait(70)
  end
end

-- 4. Lamps hang round the crab. Each falls when its rest is over; shot down, it clears a space.
value.def("rest") -- frames a lamp waits after the first one fell
motion.def { name = "hang",
  { orbit = 0, radius_to = 54, spin = 1.6, over = 50 }, { orbit = 54, spin = 1.6, over = forever } }
motion.def { name = "fall",
  { speed = 0, over = 12 }, { bank = 1 }, { wait = "rest" }, { aim = true },
  { speed = 2.6, over = 30 } }

local function chandelier(e)
  local lamps = bullet.group("lamp")
  for k = 1, forever do
    local n = by_difficulty { easy = 4, normal = 5, hard = 6 }
    for i = 1, n do
      bullet.fire { kind = "lamp", from = e, bank = 2, dir = 360 * i / n, speed = 0, tag = "lamp",
                    around = e, motion = "hang", rest = 18 * i }
    end
    wait(50)
    for i = 1, 3 do
      pattern.ring { from = e, kind = "ring", bank = i + 3, dir = 9.5 * (3 * k + i),
                     speed = 1.4 + i, motion = "burst",
                     n = by_difficulty { easy = 12, normal = 17, hard = 24 } }
      wait(14)
    end
    e:move { x = rng.int(70, 170), y = rng.int(56, 80), over = 50, ease = "both" }
    wait(60)
    lamps.motion = "fall"
    lamps.tag = "fallen"
    wait(by_difficulty { easy = 130, normal = 100, hard = 80 })
  end
end

local FOAM = { items = "foam", spark = "pop" } -- what is left of its bullets when a phase is beaten

boss.def("guard", { title = "Chandelier Crab", kind = "crab", x = 120, y = 70, music = "queen", phases = {
  { id = "pincers", hp = 800, time = 26 * 60, run = pincers, clear = FOAM, drops = { pearl = 5 } },
  { id = "grotto", spell = "Echo Sign: Grotto of Rings", hp = 800, time = 30 * 60, bonus = 15000,
    run = grotto, clear = FOAM, drops = { pearl = 8 } },
  { id = "lamplight", spell = "Light Sign: Waltz of Lamps", hp = 800, time = 30 * 60,
    bonus = 15000, run = lamplight, clear = FOAM, drops = { conch = 1 } },
  { id = "chandelier", spell = "Shell Sign: Falling Chandelier", hp = 900, time = 30 * 60,
    bonus = 20000, run = chandelier, clear = FOAM, drops = { pearl = 6, heart = 1 } } } })

-- stages/one/nautilus.lua - the Lantern Nautilus, which has taken a ship's lamp. It appears after
-- the wreck.
local pose = require "pose"
local rank = require "rank"

local RUBY, AMBER, GOLD, MAGENTA = 1, 2, 3, 7
local LAMP = { dx = -3, dy = 26 } -- where it holds the lamp

-- 1. Its arms release rings of orbs that spiral outwards. When the lamp flares, it throws needles
-- at you; later the lamp also swings, and drips between the rings.
local wind_left  = motion.def { { polar = 1.25, spin = 0.5, over = 200 } }
local wind_right = motion.def { { polar = 1.25, spin = -0.5, over = 200 } }

local function flare(e)
  while true do
    wait(by_difficulty { easy = 150, normal = 120, hard = 88, abyss = 80 })
    spark.burst { kind = "shock", from = e, dx = LAMP.dx, dy = LAMP.dy, speed = 0 }
    sound.play("charge", { from = e })
    pose.attack(e, 50)
    wait(24)
    pattern.fan { from = e, dx = LAMP.dx, dy = LAMP.dy, kind = "needle", bank = GOLD, aim = true,
                  spread = by_difficulty { easy = 40, normal = 48, abyss = 60 }, speed = 2.2,
                  n = by_difficulty { easy = 1, normal = 3, hard = 6, abyss = 8 }, delay = 10,
                  each = function(a)
      a.n, a.speed_to = by_difficulty { easy = 1, normal = 2, hard = 3 }, a.speed + 0.7
      pattern.stack(a)
    end }
  end
end

local function drips(e)
  wait(6 * 60)
  for k = 1, forever do
    pattern.fan { from = e, dx = LAMP.dx, dy = LAMP.dy, kind = "drop", bank = RUBY, dir = 90 + 64 * angle.sin(23 * k),
                  spread = 16, speed = 1.5, n = by_difficulty { easy = 1, hard = 2, abyss = 3 } }
    wait(rank.sooner(by_difficulty { easy = 20, normal = 11, abyss = 8 }))
  end
end

local function lantern(e)
  e:wander { w = 70, h = 24, every = 110, over = 90 }
  task.go(flare, e)
  task.go(drips, e)
  for k = 1, forever do
    local n = by_difficulty { easy = 5, normal = 7, hard = 11, abyss = 14 }
    local left = k // 4 % 2 == 0
    pattern.ring { from = e, kind = "orb", bank = left and MAGENTA or AMBER, n = n, dir = 7 * k,
                   speed = 1.25, motion = left and wind_left or wind_right }
    wait(rank.sooner(by_difficulty { easy = 80, normal = 66, hard = 40, abyss = 38 }))
  end
end

-- 2. It lays its own shell around itself in pearls of light, chamber by chamber, and then unwinds
-- it: the last pearls fly first.
local function unwinding(bank, speed)
  return motion.def { { wait = "rest" }, { bank = bank }, { speed = speed, over = 50 } }
end
local unwind = { easy = unwinding(RUBY, 1.5), normal = unwinding(RUBY, 1.7),
                 hard = unwinding(RUBY, 1.5), abyss = unwinding(RUBY, 1.3) }
-- Pearls laid in the opposite direction aim at you when they start.
local moth = motion.def { { wait = "rest" }, { bank = AMBER, aim = true },
                          { speed = 1.5, over = 40 } }

-- One pearl of an arm that winds outwards; none in the lower field, where you are.
local function lay(e, a, r, way, def)
  local x, y = r * angle.cos(a), r * angle.sin(a)
  if e.y + y >= 196 then return end
  def.from, def.dx, def.dy, def.dir = e, x, y, a + 64 * way
  def.speed, def.bank, def.delay = 0, MAGENTA, 20
  bullet.fire(def)
end

local function wind(e, n, arms, from, way, kind, program)
  local r = 26
  for i = 1, n do
    r = r * 1.0235
    for arm = 1, arms do
      lay(e, from + way * 21 * i + 360 * arm / arms, r, way,
          { kind = kind, rest = 34 + (n - i), motion = program })
    end
    if i % 2 == 0 then wait(1) end
  end
end

local function chambers(e)
  for k = 1, forever do
    local way = k % 2 == 0 and -1 or 1
    local n = by_difficulty { easy = 20, normal = 63, hard = 53, abyss = 50 }
    local arms = by_difficulty { easy = 1, normal = 1, hard = 2, abyss = 3 }
    e:move { x = rng.int(96, 144), y = rng.int(76, 92), over = 30, ease = "both" }
    wait(30)
    sound.play("still", { from = e })
    pose.attack(e, 60)
    wind(e, n, arms, 40 * k, way, "orb", by_difficulty(unwind))
    if by_difficulty { easy = false, hard = true } then
      wind(e, by_difficulty { easy = 0, hard = 33, abyss = 40 }, 1, 40 * k + 180, -way, "pellet",
           moth)
    end
    for _ = 1, by_difficulty { easy = 1, normal = 2, abyss = 3 } do
      wait(26)
      pattern.fan { from = e, dx = LAMP.dx, dy = LAMP.dy, kind = "kunai", bank = GOLD, aim = true,
                    spread = 50, n = by_difficulty { easy = 1, normal = 2, hard = 4, abyss = 6 },
                    speed = by_difficulty { easy = 1.7, normal = 1.8, hard = 2.1 }, delay = 12 }
    end
    wait(by_difficulty { easy = 120, normal = 24, hard = 57, abyss = 20 })
  end
end

local FOAM = { items = "foam", spark = "pop" }

boss.def("nautilus", { title = "Lantern Nautilus", kind = "lantern_nautilus", x = 120, y = 86,
                       entrance = "bubbles",
                       music = "lantern", portrait = "lantern_nautilus",
                       hurt = "lantern_nautilus_hurt", broken = "lantern_nautilus_broken", phases = {
  { id = "lantern", hp = 1240, time = 30 * 60, run = lantern, clear = FOAM, drops = { pearl = 5 } },
  { id = "chambers", spell = "Spiral Sign: Chambered Lamp", hp = 1200, time = 34 * 60,
    bonus = 12000, bonus_to = 4000, run = chambers, clear = FOAM, drops = { pearl = 6 } } } })

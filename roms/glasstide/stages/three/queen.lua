-- stages/queen.lua - the floor of the sea: the Queen of the Glass Tide, four phases and the one she
-- comes back with.
local sea = require "sea"

local function wander(e, over)
  e:move { x = rng.int(80, 160), y = rng.int(62, 92), over = over, ease = "both" }
end

-- 1. Moons circle her and throw orbs outward, rice turns against them; a volley of blades looks for
-- a way between both.
motion.def { name = "moon",
  { orbit = 0, radius_to = 58, spin = -1.7, over = 50 },
  { orbit = 58, spin = -1.7, over = forever } }

local function moon(e, dir)
  local b = bullet.fire { kind = "moon", bank = 6, from = e, dir = dir, speed = 0, around = e,
                          motion = "moon" }
  task.own(b, function()
    wait(50)
    while true do
      bullet.fire { kind = "orb", bank = 6, from = b, dir = angle.to(e, b), speed = 1.4 }
      wait(by_difficulty { easy = 19, normal = 15, hard = 13 })
    end
  end)
end

local function wheels(e)
  local moons = by_difficulty { easy = 3, normal = 4, hard = 6 }
  for i = 1, moons do moon(e, 360 * i / moons) end
  task.go(pattern.spiral, { from = e, kind = "rice", bank = 5, n = forever, step = 7, every = 7,
                            speed = 1.7, arms = by_difficulty { easy = 4, normal = 5, hard = 6 } })
  while true do
    wait(110)
    pattern.fan { from = e, dy = 4, spread = 50, aim = true, kind = "kunai", bank = 1, speed = 2.4,
                  n = by_difficulty { easy = 3, normal = 4, hard = 6 },
                  each = function(a) a.n, a.speed_to = 3, 3.4 pattern.stack(a) end }
    wander(e, 90)
  end
end

-- 2. The water stands still, and all that is in it. Lances gather round you, which start when it
-- flows again; half of the orbs then look at you, and half go home: each has written on it where.
value.def("home_x")
value.def("home_y")
motion.def { name = "home",
  { go_to = { "home_x", "home_y" }, over = 80, ease = "in" }, { die = true } }
local pounce = motion.def { { speed = 0 }, { speed = 2, over = 20 } }

local function gather(n)
  for i = 1, n do
    player.each(function(p)
      if not p.alive then return end
      local a = 137.5 * i -- as the seeds of a sunflower lie: never beside the one before
      bullet.fire { kind = "lance", bank = 3, from = p, aim = true, speed = 3,
                    dx = 88 * angle.cos(a), dy = 88 * angle.sin(a), delay = 4 * (n - i) + 30 }
    end)
    wait(4)
  end
  wait(30)
end

local function let_go(e)
  local odd = false
  bullet.each("breath", function(b)
    odd = not odd
    b.tag = "let go"
    if odd then
      b.kind, b.motion = "drop", pounce
      b.bank = 1 -- after kind, which brings its own
      b:aim(rng.number(-14, 14))
    else
      b.bank, b.home_x, b.home_y, b.motion = 5, e.x, e.y, "home"
    end
  end)
end

local function held(e)
  local breath = bullet.group("breath")
  for k = 1, forever do
    local n = by_difficulty { easy = 16, normal = 22, hard = 28 }
    for i = 1, 6 do
      pattern.ring { from = e, dy = -6, kind = "orb", bank = 6, tag = "breath", n = n,
                     dir = 180 * i / n + 7 * k, speed = 2.4 }
      wait(10)
    end
    wait(18)
    do
      local still <close> = sea.still()
      sound.play("still", { from = e })
      bullet.group().frozen = forever
      breath.bank = 0
      gather(by_difficulty { easy = 5, normal = 8, hard = 12 })
      bullet.group().frozen = 0
      sound.play("flow", { from = e })
    end
    let_go(e)
    wander(e, 60)
    wait(90)
  end
end

-- 3. Rain from the surface sways with the tide, all of it as one; walls of water come down, and the
-- gap in them goes to and fro.
value.def("sway") -- degrees of the tide's to and fro when a drop began to fall
local TIDE = 160  -- frames of it
motion.def { name = "sway", { wave = 16, every = TIDE, phase = "sway", over = forever } }

local function tide() return 360 * (board.frame() % TIDE) / TIDE end

local function rain_over(e)
  local drop = { kind = "drop", bank = 5, y = -10, dir = 90, motion = "sway" }
  while e.alive do
    drop.x, drop.speed = rng.int(-20, 260), rng.number(1.1, 1.8)
    drop.sway = tide()
    bullet.fire(drop)
    wait(by_difficulty { easy = 5, normal = 3, hard = 2 })
  end
end

local function wall(first)
  local wide = by_difficulty { easy = 6, normal = 5, hard = 4 }
  for row = 0, 2 do
    pattern.line { x = 120 + 6 * (row % 2), y = -10, kind = "rice", bank = 6, n = 28, width = 324,
                   dir = 90, speed = 1.3, motion = "sway", sway = tide(),
                   skip = { first + row, first + row + wide } }
    wait(10)
  end
end

local function ebb(e)
  task.go(rain_over, e)
  for k = 1, forever do
    wait(50)
    wall((12.5 + 3.5 * angle.sin(80 * k)) // 1)
    pattern.fan { from = e, kind = "big", bank = 3, spread = 70, aim = true, speed = 1.7,
                  n = by_difficulty { easy = 1, normal = 3, hard = 3 } }
    wait(40)
    pattern.ring { from = e, kind = "petal", bank = 7, dir = rng.dir(), speed = 1.4,
                   n = by_difficulty { easy = 10, normal = 14, hard = 20 },
                   motion = "sway", sway = tide() }
    wander(e, 80)
  end
end

-- 4. A flower a thousand fathoms deep: petals in stacks that open, hang, turn aside to both sides
-- and go on. When she cracks, roses of stars fall out of her.
local function bloom(name, turn, bank)
  motion.def { name = name,
    { speed = 0.5, over = 34 }, { bank = bank }, { wait = 10 }, { turn = turn, over = 40 },
    { speed = 2.1, over = 60 } }
end
bloom("bloom left", 1.7, 2)
bloom("bloom right", -1.7, 7)
local swell = motion.def {
  { speed = 0.6, over = 40 }, { home = 1.2, over = 50 }, { speed = 2.4, over = 30 } }

local function petals(e, turn, motion_name, bank)
  pattern.ring { from = e, dy = -6, dir = turn, kind = "petal", bank = bank, speed = 1.6,
                 n = by_difficulty { easy = 8, normal = 11, hard = 14 }, motion = motion_name,
                 each = function(a) a.n, a.speed_to = 4, 3.6 pattern.stack(a) end }
end

local function flower(e, full)
  for k = 1, forever do
    local turn = 23 * k
    petals(e, turn, "bloom left", 3)
    wait(12)
    petals(e, turn + 12, "bloom right", 6)
    if k % 3 == 0 then
      pattern.ring { from = e, dy = -6, kind = "bubble", bank = 5, n = 6, aim = true, speed = 1.8,
                     delay = 24, motion = swell }
      wander(e, 60)
    end
    wait(by_difficulty { easy = 74, normal = 60, hard = 46 })
    if e.hp * 2 < full then
      pattern.rose { from = e, dy = -6, kind = "star", bank = 1, dir = turn, petals = 5,
                     speed = 2.3, speed_to = 1.2,
                     n = by_difficulty { easy = 15, normal = 25, hard = 35 } }
    end
  end
end

local FOAM = { items = "foam", spark = "pop" } -- what is left of her bullets when a phase is beaten

boss.def("queen", { title = "Queen of the Glass Tide", kind = "queen", x = 120, y = 76,
                    music = "queen", phases = {
  { id = "wheels", hp = 1500, time = 45 * 60, run = wheels, clear = FOAM,
    drops = { pearl = 8 } },
  { id = "held", spell = "Glass Sign: Held Breath", hp = 1600, time = 50 * 60, bonus = 30000,
    run = held, clear = FOAM, drops = { pearl = 8, conch = 1 } },
  { id = "ebb", spell = "Moon Sign: Ebb and Flow", hp = 1700, time = 50 * 60, bonus = 30000,
    run = ebb, clear = FOAM, drops = { pearl = 8, heart = 1 } },
  { id = "flower", spell = "Last Sign: Fathomless Flower", hp = 2000, time = 60 * 60, bonus = 60000,
    run = function(e) flower(e, 2000) end, clear = FOAM } } })

-- Outlasting her is not enough: she comes back until she breaks.
boss.def("undertow", { title = "Queen of the Glass Tide", kind = "queen", x = 120, y = 76, music = "queen",
  phases = { { id = "again", spell = "The Tide Returns", hp = 900, time = 40 * 60,
               run = function(e) flower(e, 1800) end } } })

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

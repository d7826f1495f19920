-- stages/three/queen.lua - the boss on the sea floor: the Queen of the Glass Tide, five phases and
-- the one she returns with.
local kinds = require "kinds"
local pose = require "pose"
local sea = require "sea"
local by = require "stages/three/by"
local pace = require "stages/three/pace"
local figures = require "stages/three/queen_figures"
local meeting = require "stages/three/meeting"
local fast, soon = pace.fast, pace.soon

local function wander(e, over)
  e:move { x = rng.int(80, 160), y = rng.int(74, 98), over = over, ease = "both" }
end

-- 1. Moons circle her and throw orbs outwards, arms of rice turn the other way, and volleys of
-- blades fly between them. On abyss, all of this forms a slow curtain.
motion.def { name = "moon",
  { orbit = 0, radius_to = 64, spin = -1.7, over = 50 },
  { orbit = 64, spin = -1.7, over = forever } }

local function moon(e, dir)
  local b = bullet.fire { kind = "moon", bank = 0, from = e, dir = dir, speed = 0, around = e,
                          motion = "moon" }
  task.own(b, function()
    wait(50)
    while true do
      bullet.fire { kind = "orb", bank = 5, from = b, dir = angle.to(e, b),
                    speed = fast(1.3, 1.4, 1.5, 0.9) }
      wait(soon(39, 25, 8, 11))
    end
  end)
end

local function wheels(e)
  local moons = by(2, 4, 5, 6)
  for i = 1, moons do moon(e, 360 * i / moons) end
  task.go(pattern.spiral, { from = e, kind = "rice", bank = 1, n = forever, step = 7,
                            every = by(20, 9, 5, 6), speed = by(1.3, 1.7, 1.8, 0.9),
                            arms = by(2, 4, 10, 10) })
  while true do
    wait(110)
    pose.attack(e, 50)
    pattern.fan { from = e, dy = 4, spread = 50, aim = true, kind = "kunai", bank = 3,
                  speed = fast(1.9, 2.4, 2.5, 1.8), n = by(1, 3, 6, 7),
                  each = function(a) a.n, a.speed_to = 3, a.speed + 1 pattern.stack(a) end }
    wander(e, 90)
  end
end

-- 2. The water and everything in it stops. Lances gather around you and start when the water flows
-- again; then half of the orbs aim at you, and the other half fly back to her.
motion.def { name = "home",
  { go_to = { "home_x", "home_y" }, over = 80, ease = "in" }, { die = true } }
motion.def { name = "pounce", { speed = 0 }, { speed = 1.8, over = 26 } }
motion.def { name = "creep", { speed = 0 }, { speed = 1.4, over = 40 } }

local function gather(n)
  local apart = by(4, 4, 4, 2) -- frames
  for i = 1, n do
    player.each(function(p)
      if not p.alive then return end
      local a = 137.5 * i -- like the seeds of a sunflower: never next to the one before
      bullet.fire { kind = "lance", bank = 3, from = p, aim = true,
                    speed = by(2.4, 2.6, 2.8, 3),
                    dx = 88 * angle.cos(a), dy = 88 * angle.sin(a), delay = apart * (n - i) + 30 }
    end)
    wait(apart)
  end
  wait(30)
end

local NEAR <const> = 44 -- px: bullets this close to a craft don't aim at it

local function let_go(e)
  local odd = false
  bullet.each("breath", function(b)
    odd = not odd
    b.tag = "let go"
    local p = player.nearest(b.x, b.y)
    local dx, dy = p and p.x - b.x or 0, p and p.y - b.y or 0
    if odd and dx * dx + dy * dy > NEAR * NEAR then
      b.kind, b.motion = "drop", by("creep", "pounce", "pounce", "creep")
      b.bank = 1 -- after kind, which also sets a bank
      b:aim(rng.number(-14, 14))
    else
      b.bank, b.home_x, b.home_y, b.motion = 5, e.x, e.y, "home"
    end
  end)
end

local function held(e)
  local breath = bullet.group("breath")
  for k = 1, forever do
    local n = by(8, 15, 24, 39)
    for i = 1, by(4, 6, 6, 10) do
      pattern.ring { from = e, dy = -6, kind = "orb", bank = 5, tag = "breath", n = n,
                     dir = 180 * i / n + 7 * k, speed = by(2.2, 2.4, 2.4, 1.7) }
      wait(by(10, 10, 12, 6))
    end
    wait(18)
    do
      local still <close> = sea.still()
      sound.play("still", { from = e })
      pose.attack(e, 90)
      bullet.group().frozen = forever
      breath.bank = 0
      gather(by(2, 4, 6, 12))
      bullet.group().frozen = 0
      sound.play("flow", { from = e })
    end
    let_go(e)
    wander(e, 60)
    wait(by(138, 131, 88, 86))
  end
end

-- 3. Rain from the surface sways with the tide, all drops together. Walls of water come down, and
-- the gap in them swings to and fro.
value.def("sway") -- the tide's phase in degrees when a drop starts to fall
local TIDE = 160  -- frames per period
motion.def { name = "sway", { wave = 16, every = TIDE, phase = "sway", over = forever } }

local function tide() return 360 * (board.frame() % TIDE) / TIDE end

-- Each drop falls as far as possible from those before: steps of the golden ratio.
local function rain_over(e)
  local drop = { kind = "drop", bank = 5, y = -10, dir = 90, motion = "sway" }
  local every, many = by(19, 6, 4, 4), by(1, 1, 1, 2)
  for k = 0, forever do
    for i = 1, many do
      drop.x = -20 + 280 * (0.618034 * (many * k + i) % 1)
      drop.speed = by(1.2, 1.4, 1.5, 0.85) + by(0.1, 0.1, 0.1, 0) * (k % 3)
      drop.sway = tide()
      bullet.fire(drop)
    end
    wait(every)
    if not e.alive then return end
  end
end

local function wall(first)
  local wide = by(9, 5, 4, 6)
  for row = 0, by(2, 2, 2, 5) do
    pattern.line { x = 120 + 6 * (row % 2), y = -10, kind = "rice", bank = 1, n = 28, width = 324,
                   dir = 90, speed = by(1.2, 1.3, 1.4, 0.9), motion = "sway", sway = tide(),
                   skip = { first + row, first + row + wide } }
    wait(10)
  end
end

local function ebb(e)
  task.go(rain_over, e)
  for k = 1, forever do
    wait(by(96, 61, 50, 90))
    pose.attack(e, 60)
    wall((by(9.5, 12.5, 12.5, 12.5) + 3.5 * angle.sin(80 * k)) // 1)
    pattern.fan { from = e, kind = "big", bank = 3, spread = 70, aim = true,
                  speed = by(1.4, 1.7, 1.8, 1.2), n = by(1, 3, 3, 1) }
    wait(by(78, 49, 39, 72))
    pattern.ring { from = e, kind = "petal", bank = 2, dir = rng.dir(),
                   speed = by(0.84, 1.19, 1.41, 1), n = by(8, 14, 20, 8),
                   motion = "sway", sway = tide() }
    wander(e, 80)
  end
end

-- 5. A flower a thousand fathoms deep: stacks of petals open, hang, turn to both sides and fly on.
-- Below half of her health, roses of stars join in.
local function unfold(name, turn, bank, speed)
  motion.def { name = name,
    { speed = 0.5, over = 34 }, { bank = bank }, { wait = 10 }, { turn = turn, over = 40 },
    { speed = speed, over = 60 } }
end
unfold("bloom left", 1.7, 2, 2.1)
unfold("bloom right", -1.7, 1, 2.1)
unfold("slow flower left", 1.7, 2, 1)
unfold("slow flower right", -1.7, 1, 1)
local swell = motion.def {
  { speed = 0.6, over = 40 }, { home = 1.2, over = 50 }, { speed = 2.2, over = 30 } }

local function petals(e, turn, motion_name, bank)
  pattern.ring { from = e, dy = -6, dir = turn, kind = "petal", bank = bank,
                 speed = by(1.81, 1.83, 1.66, 1.24), n = by(8, 12, 16, 16), motion = motion_name,
                 each = function(a) a.n, a.speed_to = by(3, 4, 4, 5), 3.4 pattern.stack(a) end }
end

local function flower(e, full)
  local left = by("bloom left", "bloom left", "bloom left", "slow flower left")
  local right = by("bloom right", "bloom right", "bloom right", "slow flower right")
  for k = 1, forever do
    local turn = 23 * k
    if k % 3 == 1 then pose.attack(e, 44) end
    petals(e, turn, left, 3)
    wait(12)
    petals(e, turn + 12, right, 5)
    if k % 3 == 0 then
      pattern.ring { from = e, dy = -6, kind = "bubble", bank = 0, n = by(4, 6, 6, 4), aim = true,
                     speed = 1.8, delay = 24, motion = swell }
      wander(e, 60)
    end
    wait(by(53, 37, 40, 45))
    if e.hp * 2 < full then
      pattern.rose { from = e, dy = -6, kind = "star", bank = 0, dir = turn, petals = 5,
                     speed = by(2, 2.3, 2.3, 1.5), speed_to = by(1.1, 1.2, 1.2, 0.8),
                     n = by(10, 20, 30, 22) }
    end
  end
end

local FOAM = { items = "foam", spark = "pop" } -- what her bullets become when a phase is beaten

local function window(e)
  figures.window(e)
end

local returns = 0 -- how often she has returned

-- Channels open between swaying arms of kelp. Each time she returns, she has less health.
local function again(e)
  e.hp = math.max(60, e.hp - 240 * returns)
  figures.again(e)
end

boss.def("queen", { title = "Queen of the Glass Tide", kind = "queen", x = 120, y = 88,
                    epithet = "She Who Took Back the Sea", entrance = "bubbles", bg = "court",
                    portrait = "queen_face", cut_in = "queen_cut_in", music = "queen", warning = 120,
                    hurt = "queen_hurt", broken = "queen_broken", phases = {
  { talk = meeting },
  { id = "wheels", hp = 1000, time = 45 * 60, run = wheels, clear = FOAM,
    drops = { pearl = 8 } },
  { id = "held", spell = "Glass Sign: Held Breath", hp = 1050, time = 50 * 60, bonus = 30000,
    bonus_to = 10000, run = held, clear = FOAM, drops = { pearl = 8, conch = 1 } },
  { id = "ebb", spell = "Moon Sign: Ebb and Flow", hp = 1100, time = 50 * 60, bonus = 30000,
    bonus_to = 10000, run = ebb, clear = FOAM, drops = { pearl = 8, heart = 1 } },
  { id = "window", spell = "Pane Sign: Rose Window", hp = 1150, time = 50 * 60, bonus = 40000,
    bonus_to = 13000, run = window, clear = FOAM, drops = { pearl = 8, conch = 1 } },
  { id = "flower", spell = "Last Sign: Fathomless Flower", hp = 1350, time = 60 * 60,
    bonus = 60000, bonus_to = 20000, run = function(e) flower(e, 1350) end, clear = FOAM } } })

-- Outlasting her is not enough: she returns until she breaks.
boss.def("undertow", { title = "Queen of the Glass Tide", kind = "queen", x = 120, y = 88,
  music = "queen", bg = "court", hurt = "queen_broken",
  phases = { { id = "again", spell = "The Tide Returns", hp = 800, time = 40 * 60,
               bonus = 30000, bonus_to = 5000, run = again } } })

local broken -- was she, in her last return?

on.phase(function(_, id, won)
  if id == "again" then broken, returns = won, won and 0 or returns + 1 end
end)

local queen = {}

-- Returns when she is broken. The first time, only her shell breaks.
function queen.fight()
  boss.fight("queen")
  if not stage.skipping() then wait(kinds.COLLAPSE) end
  returns = 0
  repeat
    broken = false
    boss.fight("undertow")
    wait(2) -- on.phase comes at the end of the frame
  until broken or stage.skipping()
end

return queen

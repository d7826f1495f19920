-- stages/moon/boss.lua - the Drowned Moon. It wanes, is new, becomes full, and then goes dark: five
-- phases to beat, and one to survive.
local by = require "stages/three/by"
local late = require "stages/moon/late"

local FOAM = { items = "foam", spark = "pop" } -- what its bullets become when a phase is beaten

-- 1. Two wheels of light turn against each other; the gaps are where they cross.
local function wheel(e, kind, bank, step)
  pattern.spiral { from = e, kind = kind, bank = bank, n = forever, step = step,
                   every = by(14, 9, 9, 11),
                   speed = by(1.2, 1.4, 1.5, 1.05),
                   arms = by(8, 11, 12, 18) }
end

local function gibbous(e)
  task.go(wheel, e, "rice", 6, 5)
  if board.difficulty() ~= "easy" then task.go(wheel, e, "petal", 5, -5) end
  while true do
    wait(by(150, 80, 100, 82))
    late.glare(e, 40)
    pattern.fan { from = e, kind = "kunai", bank = 1, aim = true, spread = 40, speed = 2,
                  n = by(1, 3, 5, 3),
                  each = function(a)
                    a.n, a.speed_to = by(3, 4, 5, 5), 2.8
                    pattern.stack(a)
                  end }
  end
end

-- 2. Above the line is air, below it water. Bullets that enter the water curve downwards, change
-- colour and slow down, so they are denser there.
local LINE <const> = 190 -- y of the water
local CLASSES <const> = 9
local SLOW <const> = { easy = 0.9, normal = 1, hard = 1.1, abyss = 0.8 }

local bent = {} -- by a bullet's angle from straight down
for i = 1, CLASSES do
  local off = 20 * (i - 5) -- degrees from straight down
  bent[i] = {}
  for name, speed in pairs(SLOW) do
    bent[i][name] = motion.def { { wait_for = { y = LINE } },
      { turn = off * 0.5, bank = off * off < 2000 and 2 or 3 }, { speed = speed, over = 14 } }
  end
end

local function refract(a)
  local off = (90 - a.dir + 180) % 360 - 180
  local i = ((off + 10) // 20 + 5) // 1
  if i >= 1 and i <= CLASSES then a.motion = bent[i][board.difficulty()] bullet.fire(a) end
end

-- The foam along the line, which appears before anything crosses it.
local function shore()
  for i = 0, forever do
    spark.burst { kind = "pop", x = 97 * i % 240, y = LINE + 2 * angle.sin(11 * i), speed = 0.2 }
    wait(2)
  end
end

local function half(e)
  e.picture = "half"
  task.go(shore)
  wait(30)
  for k = 1, forever do
    pattern.ring { from = e, kind = "orb", bank = 6, dir = 5.5 * k + 3 * k * k % 17, speed = 2,
                   n = by(23, 43, 48, 66),
                   each = refract }
    if k % by(6, 4, 3, 4) == 0 then
      late.glare(e, 40)
      pattern.fan { from = e, kind = "big", bank = 1, aim = true, spread = 64, speed = 1.7,
                    delay = 24, n = by(1, 2, 3, 3) }
    end
    wait(by(42, 16, 15, 16))
  end
end

-- 3. Sickles of bullets fly in one piece and break up over you.
local sickle = {}
for i = -7, 7 do
  local a = 12 * i
  sickle[#sickle + 1] = { 30 * angle.cos(a), 30 * angle.sin(a) }
  if i % 2 == 0 then sickle[#sickle + 1] = { 36 * angle.cos(a) - 16, 33 * angle.sin(a) } end
end

local whole  = motion.def { { wait = 1 } }
local loose  = motion.def { { wait = 76 }, { speed = 0, over = 24 }, { wait = 12 },
                            { turn = 90, bank = 7 }, { speed = 1.5, over = 50 } }
local closer = motion.def { { wait = 70 }, { speed = 0, over = 24 }, { wait = 16 },
                            { aim = true, bank = 7 }, { speed = 1.8, over = 60 } }

local function reap(e, dir, aim, way)
  pattern.points { from = e, dx = 44 * way, dy = 14, kind = "shard", bank = 3, list = sickle,
                   turns = true, aim = aim, dir = dir, delay = 20,
                   speed = by(1.5, 1.6, 1.6, 1.7),
                   motion = way < 0 and
                   by(whole, loose, loose, loose) or
                   by(whole, loose, closer, closer) }
end

local function crescent(e)
  e.picture = "sickle"
  task.go(late.stream, e, by(64, 15, 6, 11), 2)
  task.go(function()
    pattern.spiral { from = e, kind = "pellet", bank = 5, n = forever, step = 29,
                     arms = by(4, 6, 8, 11),
                     every = by(11, 6, 4, 4),
                     speed = by(1.1, 1.2, 1.3, 0.9) }
  end)
  for k = 1, forever do
    wait(20)
    local way = k % 2 == 0 and 1 or -1
    late.glare(e, 30)
    reap(e, 0, true, way)
    wait(by(39, 22, 13, 14))
    if board.difficulty() ~= "easy" then
      reap(e, 90 + 38 * way, false, -way)
      reap(e, 90 - 38 * way, false, way)
    end
    wait(by(57, 58, 46, 42))
  end
end

-- Rings the bell at the start of a phase.
local function tolled(run)
  return function(e)
    sound.play("toll", { from = e })
    run(e)
  end
end

boss.def("moon", { title = "The Drowned Moon", kind = "moon", x = 120, y = 100,
  epithet = "That Which Pulls the Water", entrance = "bubbles", bg = "moon",
  music = "moon", portrait = "moon_cross", cut_in = "moon_cut_in", hurt = "moon_hurt", broken = "moon_broken",
  warning = 150, phases = {
    { id = "gibbous", hp = 1600, time = 45 * 60, run = tolled(gibbous), clear = FOAM,
      drops = { pearl = 8 } },
    { id = "half", spell = "Half Sign: Two Waters", hp = 2300, time = 50 * 60, bonus = 40000,
      bonus_to = 13000, run = tolled(half), clear = FOAM, drops = { pearl = 8 } },
    { id = "crescent", spell = "Crescent Sign: Reaping Tide", hp = 2300, time = 50 * 60,
      bonus = 40000, bonus_to = 13000, run = tolled(crescent),
      clear = FOAM, drops = { pearl = 8, conch = 1 } },
    { id = "new", spell = "New Sign: A Way Through Rings", hp = 2300, time = 55 * 60,
      bonus = 50000, bonus_to = 16000, run = tolled(late.new), clear = FOAM,
      drops = { pearl = 8 } },
    { id = "full", spell = "Full Sign: Nearest of Nights", hp = 2600, time = 60 * 60,
      bonus = 60000, bonus_to = 20000, run = tolled(late.full),
      clear = FOAM, drops = { pearl = 8, heart = 1 } },
    { id = "eclipse", spell = "Last Sign: The Sea Falls In", survive = true, time = 44 * 60,
      bonus = 100000, run = tolled(late.eclipse), clear = FOAM } } })

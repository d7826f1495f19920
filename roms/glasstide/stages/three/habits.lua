-- stages/three/habits.lua - what each creature of the abyss fires on its path. All are `run`
-- functions, which end with their creature.
local by = require "stages/three/by"
local pace = require "stages/three/pace"
local ready = require "pose".ready
local fast, soon = pace.fast, pace.soon
local habits = {}

local NEAR = 44 -- px: creatures don't fire at a ship this near

local function face_to_face(e)
  local p = player.nearest(e.x, e.y)
  if not (p and p.alive) then return false end
  local dx, dy = p.x - e.x, p.y - e.y
  return dx * dx + dy * dy < NEAR * NEAR
end

-- Mites spit aimed cyan pellets: one on easy, five in a row on abyss.
function habits.spit(e)
  ready(e, rng.int(20, 50))
  if face_to_face(e) then return end
  pattern.aimed { from = e, kind = "pellet", bank = 5, every = 8, delay = 14,
                  n = by(1, 2, 3, 5), speed = fast(1.6, 1.9, 2.1, 2.2) }
end

-- Mites in crowds drop glass behind them.
function habits.litter(e)
  ready(e, 26)
  while true do
    bullet.fire { from = e, kind = "rice", bank = 5, dir = 90, speed = fast(1.1, 1.3, 1.5, 1.2) }
    ready(e, soon(72, 34, 22, 15))
  end
end

-- A viperfish bites: two rows of teeth fly at you in the shape of its jaw.
local JAW = { { 0, -16 }, { 9, -12 }, { 15, -5 }, { 15, 5 }, { 9, 12 }, { 0, 16 } }
local WIDE_JAW = { { -8, -24 }, { 0, -16 }, { 9, -12 }, { 15, -5 }, { 15, 5 }, { 9, 12 }, { 0, 16 },
                   { -8, 24 } }

function habits.bite(e)
  ready(e, 58)
  for _ = 1, by(1, 1, 2, 3) do
    if not face_to_face(e) then
      pattern.points { from = e, dy = 14, kind = "kunai", bank = 1, aim = true, turns = true,
                       delay = 22, speed = fast(1.6, 2, 2.2, 2.2),
                       list = by(JAW, JAW, WIDE_JAW, WIDE_JAW) }
    end
    ready(e, 34)
  end
end

-- A squid puffs ink: orbs that hang in a cloud, then sink, and hide the stars that follow.
motion.def { name = "ink", { speed = 0.25, over = 46 }, { wait = 24 }, { dir = 90 },
             { speed = 1.1, over = 70 } }

function habits.ink(e)
  ready(e, 70)
  while true do
    pattern.scatter { from = e, dy = 12, kind = "orb", bank = 0, dir = 90, spread = 150,
                      speed = 0.7, speed_to = 2.2, motion = "ink", n = by(7, 11, 16, 19) }
    ready(e, 40)
    if not face_to_face(e) then
      pattern.fan { from = e, dy = 12, kind = "star", bank = 3, aim = true, spread = 34,
                    speed = fast(1.5, 1.8, 2, 2), n = by(1, 3, 3, 5) }
    end
    ready(e, soon(163, 100, 79, 55))
  end
end

-- The lights of a comb jelly run down its sides and fire from there: two fans that cross, open and
-- close.
function habits.lights(e)
  ready(e, 60)
  for k = 0, forever do
    local open = 46 + 40 * angle.sin(9 * k)
    for side = -1, 1, 2 do
      bullet.fire { from = e, dx = 12 * side, dy = -12 + 3 * (k % 9), kind = "petal", bank = 2,
                    dir = 90 + open * side, speed = fast(1.2, 1.4, 1.5, 1.1) }
      if k % by(9, 4, 2, 2) == 0 then
        bullet.fire { from = e, dx = 12 * side, dy = -12 + 3 * (k % 9), kind = "rice", bank = 3,
                      dir = 90 - 0.6 * open * side, speed = fast(1, 1.1, 1.2, 0.9) }
      end
    end
    ready(e, soon(15, 8, 6, 4))
  end
end

-- A sea spider spins a web, which hangs for a while and then comes down.
motion.def { name = "web", { speed = 0, over = 44 }, { wait = 22 }, { dir = 90 },
             { speed = 0.9, over = 50 } }

function habits.web(e)
  ready(e, 76)
  for k = 0, forever do
    for row = 1, by(2, 3, 3, 3) do
      pattern.polygon { from = e, kind = "pellet", bank = 0, sides = 6, dir = 30 * (k % 2),
                        n = 6 * (row + by(0, 0, 1, 1)), speed = 0.7 + 0.75 * row, motion = "web" }
      wait(6)
    end
    pattern.ring { from = e, kind = "drop", bank = 1, n = 6, dir = 30 * (k % 2), motion = "web",
                   speed = 4.2 }
    ready(e, soon(188, 124, 98, 75))
  end
end

-- Rows of bells turn around its head like the hands of a clock; each bell sheds drops to one side.
local function shed(bell)
  ready(bell, 50)
  while true do
    if not face_to_face(bell) then
      bullet.fire { from = bell, kind = "drop", bank = 5, dir = 1.7 * board.frame() % 360,
                    speed = fast(0.9, 1.1, 1.2, 0.9) }
    end
    ready(bell, soon(50, 27, 16, 12))
  end
end

function habits.chain(e)
  local arms = by(2, 2, 3, 3)
  local way = e.x < 120 and 1 or -1
  ready(e, 40)
  for row = 1, 3 do
    for arm = 1, arms do
      local bell = enemy.spawn { kind = "bell", from = e, run = shed }
      bell:orbit { around = e, radius = 4, radius_to = 22 * row + 8, spin = 0.9 * way, over = 40,
                   dir = 360 * arm / arms }
      task.own(bell, function(me)
        wait(40)
        me:orbit { around = e, spin = 0.9 * way }
      end)
    end
    wait(24)
  end
  while true do
    pattern.ring { from = e, kind = "ring", bank = 2, n = by(6, 9, 12, 16), dir = rng.dir(),
                   speed = fast(1, 1.2, 1.3, 1) }
    ready(e, soon(164, 89, 56, 38))
  end
end

motion.def { name = "round the back", { wait = 16 }, { home = 2.2, over = 46 } }

-- A lantern shark flashes its lamp, then throws lances along its light.
function habits.hunt(e)
  ready(e, 64)
  while true do
    if not face_to_face(e) then
      sound.play("lamp", { from = e })
      spark.burst { kind = "glint", from = e, dy = 26, n = 8, speed = 2 }
      pattern.fan { from = e, dy = 24, kind = "lance", bank = 3, aim = true, delay = 30,
                    spread = by(0, 26, 40, 64), speed = fast(2.4, 2.8, 3.1, 3), n = by(1, 3, 5, 7) }
    end
    for _ = 1, 4 do
      ready(e, soon(35, 19, 11, 8))
      pattern.fan { from = e, dy = -20, kind = "needle", bank = 5, n = 2, dir = 270, spread = 150,
                    speed = 1.3, motion = "round the back" }
    end
  end
end

-- A gulper draws in water, swallows, and spits out marbles that burst.
motion.def { name = "gulp", { speed = 0.5, over = 70 },
  { emit = { pattern = "ring", n = 8, kind = "orb", bank = 2, speed = 1.1 } }, { die = true } }
motion.def { name = "great gulp", { speed = 0.5, over = 70 },
  { emit = { pattern = "ring", n = 16, kind = "orb", bank = 2, speed = 1 } },
  { emit = { pattern = "ring", n = 10, kind = "pellet", bank = 1, speed = 0.7 } }, { die = true } }

function habits.gulp(e)
  ready(e, 80)
  while true do
    for i = 1, 12 do
      local a = 137.5 * i
      spark.burst { kind = "fizz", x = e.x + 40 * angle.cos(a), y = e.y + 14 + 40 * angle.sin(a),
                    dir = a + 180, spread = 0, speed = 1.6 }
      wait(3)
    end
    pattern.fan { from = e, dy = 16, kind = "marble", bank = 5, dir = 90, n = by(2, 3, 3, 4),
                  spread = by(60, 90, 90, 140), speed = 2.3, delay = 20,
                  motion = by("gulp", "gulp", "great gulp", "great gulp") }
    ready(e, soon(116, 84, 83, 87))
  end
end

-- A lit lamp throws its light: petals all around, then stars at you.
function habits.burn(e)
  for k = 0, forever do
    if e.y > 226 then return end
    pattern.ring { from = e, kind = "petal", bank = 2, n = by(6, 9, 13, 17), dir = 11 * k, delay = 12,
                   speed = fast(1.1, 1.25, 1.35, 1) }
    wait(soon(60, 34, 28, 24))
    if not face_to_face(e) then
      pattern.fan { from = e, kind = "star", bank = 3, aim = true, n = by(1, 2, 3, 3), spread = 30, delay = 14,
                    speed = fast(1.5, 1.8, 1.9, 1.8) }
    end
    wait(soon(80, 46, 36, 30))
  end
end

return habits

-- moves.lua - a demo stage for motion programs: familiars on an orbit, rings that bounce, waves,
-- and a return to the boss; time also stops while thorns appear.
bullet.def("move_thorn", { sprite = "rice", hit = { capsule = { 5, 1.5 } }, turns = true,
                           order = 1, cloud = "glint", vanish = "glint" })

local circle = motion.def {
  { orbit = 0, radius_to = 44, spin = 2, over = 40 }, { orbit = 44, spin = 2, over = forever } }
local echo = motion.def { { bounce = 2, walls = "left right top", { bank = 3 } } }
local snake = motion.def { { wave = 20, every = 60, over = forever } }
local home = motion.def { { go_to = { 120, 70 }, over = 60, ease = "in" }, { die = true } }

-- A familiar throws petals outwards. The task ends with its bullet.
local function throw(me, queen)
  while true do
    wait(16)
    bullet.fire { kind = "orb", from = me, dir = angle.to(queen, me), speed = 1.2, tag = "petal" }
  end
end

-- Time stops, and thorns appear one after another. They all start to move when time resumes.
local function stop_time(p)
  bullet.group().frozen = forever
  for i = 1, 16 do
    local a = 137.5 * i
    bullet.fire { kind = "move_thorn", bank = 1, from = p, aim = true, speed = 2.5,
                  dx = 80 * angle.cos(a), dy = 80 * angle.sin(a), delay = 4 * (16 - i) + 30 }
    wait(4)
  end
  wait(30)
  bullet.group().frozen = 0
end

-- The queen's task.
local function dance(queen, p)
  for i = 1, 4 do
    local b = bullet.fire { kind = "big", from = queen, bank = 6, dir = 90 * i, speed = 0,
                            around = queen, motion = circle }
    task.own(b, throw, queen)
  end
  for k = 1, forever do
    wait(40)
    pattern.ring { from = queen, kind = "star", bank = 4, n = 14, dir = 13 * k, speed = 1.8,
                   motion = echo }
    pattern.fan { from = queen, kind = "rice", bank = 5, n = 5, spread = 90, speed = 1.6,
                  motion = snake }
    wait(100)
    if k % 2 == 0 then stop_time(p) end
    bullet.group("petal").bank = 2
    bullet.group("petal").motion = home
  end
end

stage.def("moves", function()
  local queen = enemy.spawn { kind = "queen", x = 120, y = 70 }
  queen.safe = forever
  task.own(queen, dance, player.get(1))
  wait(forever)
end)

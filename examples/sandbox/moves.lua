-- moves.lua - a stage to look at what leads bullets: familiars on an orbit, rings that bounce, a
-- wave, a way home; and at time that stands still while thorns are put up.
bullet.def("move_thorn", { sprite = "rice", hit = { capsule = { 5, 1.5 } }, turns = true,
                           order = 1, cloud = "glint", vanish = "glint" })

local circle = motion.def {
  { orbit = 0, radius_to = 44, spin = 2, over = 40 }, { orbit = 44, spin = 2, over = forever } }
local echo = motion.def { { bounce = 2, walls = "left right top", { bank = 3 } } }
local snake = motion.def { { wave = 20, every = 60, over = forever } }
local home = motion.def { { go_to = { 120, 70 }, over = 60, ease = "in" }, { die = true } }

-- A familiar throws a petal outward now and then; it lives as long as its bullet does.
local function throw(me, queen)
  while true do
    wait(16)
    bullet.fire { kind = "orb", from = me, dir = angle.to(queen, me), speed = 1.2, tag = "petal" }
  end
end

-- Time stands; one thorn after the other is put up, and all of them start when it goes on.
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

-- What the queen does.
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

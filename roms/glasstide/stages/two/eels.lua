-- stages/two/eels.lua - the two eels that run the works: Cinder, who melts, and Quench, who cools.
-- In the last phase each has a bar, and the one that is left gets angry.
local pose = require "pose"
local rank = require "rank"
local meeting = require "stages/two/meeting"
local duel = require "stages/two/duel"
local angry, rest, pair = duel.angry, duel.rest, duel.pair

-- 1. Cinder turns and throws sparks; Quench throws bars at the walls.
local rebound = motion.def { { bounce = 1, walls = "left right", { bank = 0 } } }

local function sparks(e)
  wait(20)
  local dir = 40
  for k = 1, forever do
    local arms = by_difficulty { easy = 3, normal = 4, abyss = 5 }
    pattern.ring { from = e, dy = 14, kind = "petal", bank = 7, dir = dir, speed = rank.faster(1.6),
                   n = arms + (angry(e) and 2 or 0) }
    dir = dir + 11 + 6 * angle.sin(3 * k)
    if k % 24 == 0 then
      pose.attack(e, 70)
      e:move { x = rng.int(44, 90), y = rng.int(82, 104), over = 60, ease = "both" }
    end
    wait(rank.sooner(by_difficulty { easy = 13, normal = 8, abyss = 6 }))
  end
end

local function bars(e)
  wait(50)
  for k = 1, forever do
    pattern.fan { from = e, dy = 16, kind = "ingot", bank = 5, dir = 96 + 20 * angle.sin(77 * k),
                  spread = 120, speed = 2, motion = rebound,
                  n = by_difficulty { easy = 3, normal = 5, hard = 6, abyss = 7 } }
    rest(e, rank.sooner(by_difficulty { easy = 76, normal = 51, hard = 43, abyss = 32 }))
    pose.attack(e, 24)
    if angry(e) or k % 2 == 0 or by_difficulty { easy = false, hard = true } then
      pattern.stack { from = e, dy = 16, kind = "kunai", bank = 6, aim = true, speed = 1.6,
                      speed_to = 2.6, n = by_difficulty { easy = 1, normal = 3, hard = 4,
                                                          abyss = 6 } }
    end
    if k % 3 == 0 then
      e:move { x = rng.int(150, 196), y = rng.int(82, 104), over = 60, ease = "both" }
    end
  end
end

-- 2. Cinder pours glass, which winds down in streams; on abyss the streams drip. Quench only
-- steams.
local weave = motion.def { { wave = 15, every = 110, over = forever } }
local weave_back = motion.def { { wave = 15, every = 110, phase = 180, over = forever } }

local function pour(e)
  wait(46)
  for k = 1, forever do
    local left = k % 2 == 0
    sound.play("pour", { from = e })
    pose.attack(e, 60)
    pattern.fan { from = e, dy = 18, fire = "curve", kind = "pour", bank = left and 7 or 6,
                  speed = 1.7,
                  spread = 130, dir = 90 + (left and 9 or -9), tag = "poured",
                  motion = left and weave or weave_back,
                  n = by_difficulty { easy = 4, abyss = 5 },
                  points = by_difficulty { easy = 30, normal = 44, hard = 54, abyss = 64 } }
    wait(by_difficulty { easy = 34, normal = 27, hard = 29, abyss = 19 })
    for i = 1, by_difficulty { easy = 2, normal = 3, abyss = 5 } do
      pattern.ring { from = e, dy = 18, kind = "pellet", bank = 5, dir = 7 * (k + i), speed = 1.25,
                     n = by_difficulty { easy = 12, normal = 17, abyss = 21 } }
      wait(12)
    end
    e:move { x = rng.int(90, 150), y = rng.int(80, 96), over = 50, ease = "both" }
    wait(by_difficulty { easy = 53, normal = 35, hard = 39, abyss = 24 })
  end
end

-- On abyss, the heads of the streams drip on their way.
local drop = motion.def { { speed = 0.2, over = 10 }, { accel = 0.01, over = 120 } }

local function leak()
  while true do
    laser.each("poured", function(l)
      if l.y > 90 and l.y < 230 then
        bullet.fire { kind = "drop", bank = 5, x = l.x, y = l.y, dir = 90, speed = 0.5, delay = 24,
                      motion = drop }
      end
    end)
    wait(by_difficulty { hard = 26, abyss = 14 })
  end
end

local function simmer(e)
  e:move { x = 196, y = 68, over = 50, ease = "both" }
  wait(80)
  for k = 1, forever do
    sound.play("steam", { from = e })
    pattern.fan { from = e, dy = 16, kind = "steam", bank = 0, dir = 122, spread = 84, speed = 0.9,
                  n = by_difficulty { easy = 2, normal = 4, hard = 6, abyss = 8 } }
    if k % 2 == 0 then e:move { x = k % 4 == 0 and 196 or 44, y = 68, over = 90, ease = "both" } end
    wait(by_difficulty { easy = 130, normal = 110, hard = 90, abyss = 70 })
  end
end

local function furnace(cinder, quench)
  cinder:move { x = 120, y = 84, over = 46, ease = "both" }
  task.go(simmer, quench)
  if by_difficulty { easy = false, hard = true } then task.go(leak) end
  pour(cinder)
end

-- 3. Quench casts rows of panes, each row with a gap. Panes that are shot
-- burst into shards. Steam hangs between the rows, and Cinder spits from
-- the side.
local function cast(k)
  local count <const>, step <const> = 7, 36
  local wide = by_difficulty { easy = 2, normal = 1, hard = 1, abyss = 1 }
  local gap = (3 + 3 * angle.sin(104 * k) + 0.5) // 1
  for i = 0, count - 1 do
    if i < gap or i >= gap + wide then
      bullet.fire { kind = "pane", bank = 5, x = 12 + step * i, y = 40, dir = 90, delay = 30,
                    tag = "pane",
                    speed = by_difficulty { easy = 0.75, normal = 0.85, hard = 0.95, abyss = 0.9 } }
    end
  end
end

local function temper(e)
  e:move { x = 120, y = 86, over = 46, ease = "both" }
  wait(50)
  for k = 1, forever do
    sound.play("gear", { from = e })
    pose.attack(e, 50)
    cast(k)
    wait(by_difficulty { easy = 64, normal = 46, hard = 42, abyss = 39 })
    pattern.ring { from = e, kind = "steam", bank = 0, dir = 11 * k, speed = 0.85,
                   n = by_difficulty { easy = 6, normal = 12, hard = 16, abyss = 22 } }
    e:move { x = rng.int(84, 156), y = rng.int(78, 94), over = 50, ease = "both" }
    wait(by_difficulty { easy = 74, normal = 54, hard = 46, abyss = 38 })
  end
end

local function spit(e)
  e:move { x = 44, y = 68, over = 50, ease = "both" }
  wait(110)
  for k = 1, forever do
    pose.attack(e, 30)
    pattern.whip { from = e, dy = 16, kind = "rice", bank = 7, aim = true, speed = 1.4,
                   speed_to = 2.2, bend = k % 2 == 0 and 34 or -34,
                   n = by_difficulty { easy = 1, normal = 5, hard = 7, abyss = 9 } }
    wait(by_difficulty { easy = 120, normal = 76, hard = 53, abyss = 43 })
    if k % 3 == 0 then e:move { x = k % 2 == 0 and 44 or 196, y = 68, over = 80, ease = "both" } end
  end
end

local function panes(cinder, quench)
  task.go(spit, cinder)
  temper(quench)
end

-- 4. Each eel throws back what the other throws, and they change places.
local FLIGHT <const> = 46 -- frames from one eel to the other

local function throw(from, to, k, back)
  local list, out = {}, 90 + 78 * angle.sin(19 * k + (back and 90 or 0))
  local n = by_difficulty { easy = 3, normal = 5, hard = 7, abyss = 8 }
  local dx, dy = to.x - from.x, to.y - from.y
  for i = 1, n do
    list[i] = bullet.fire { from = from, dy = 10, kind = back and "orb" or "rice", bank = 7,
                            dir = angle.to(from, to), speed = math.sqrt(dx * dx + dy * dy) / FLIGHT,
                            delay = 3 * i }
  end
  wait(FLIGHT + 3)
  sound.play("reflect", { from = to })
  for i, b in ipairs(list) do
    if b.alive then
      b.bank, b.dir, b.speed = back and 6 or 5, out + 34 * (i - (n + 1) / 2), back and 1.3 or 1.5
    end
    wait(3)
  end
end

local function volleys(cinder, quench)
  wait(60)
  for k = 1, forever do
    task.go(throw, cinder, quench, k)
    if by_difficulty { easy = k % 2 == 0, normal = true } then
      task.go(throw, quench, cinder, k, true)
    end
    wait(by_difficulty { easy = 24, normal = 14, hard = 11, abyss = 8 })
  end
end

-- One eel fires aimed drops and the other a ring; they swap each time.
local function spill(cinder, quench)
  wait(100)
  for k = 1, forever do
    pattern.fan { from = k % 2 == 0 and cinder or quench, dy = 14, kind = "drop", bank = 7 - k % 2,
                  aim = true, spread = 60, speed = 1.5, delay = 20,
                  n = by_difficulty { easy = 1, normal = 3, abyss = 5 } }
    pattern.ring { from = k % 2 == 0 and quench or cinder, dy = 8, kind = "pellet",
                   bank = 5 + k % 2,
                   dir = 11 * k, speed = 1.15, n = by_difficulty { easy = 9, normal = 16,
                                                                   hard = 22, abyss = 24 } }
    wait(by_difficulty { easy = 56, normal = 25, hard = 20, abyss = 24 })
  end
end

local function crossing(cinder, quench)
  task.go(volleys, cinder, quench)
  task.go(spill, cinder, quench)
  for k = 1, forever do
    local left, right = cinder, quench
    if k % 2 == 0 then left, right = quench, cinder end
    left:move { x = 46, y = 92 + 20 * angle.sin(90 * k), over = 60, ease = "both" }
    right:move { x = 194, y = 92 - 20 * angle.sin(90 * k), over = 60, ease = "both" }
    wait(60)
    left:move { dx = 0, dy = 20, over = 70, ease = "both" }
    right:move { dx = 0, dy = -10, over = 70, ease = "both" }
    wait(90)
    left:move { x = 120, y = 70, over = 60, ease = "in" }
    right:move { x = 120, y = 116, over = 60, ease = "in" }
    wait(60)
    sound.play("gear", { from = left })
    pose.attack(left, 50)
    pose.attack(right, 50)
    pattern.ring { x = 120, y = 100, kind = "steam", bank = 0, dir = 8 * k, speed = 1.1,
                   n = by_difficulty { easy = 12, normal = 18, hard = 24, abyss = 30 } }
  end
end

-- 5. Cinder shuts a press of bars that wait at the walls; one gap stays
-- open. Quench lowers a slow curtain, which you must pass to reach the
-- gap.
local STEP <const>, LOW <const> = 13, 312
local shut = motion.def {
  { speed = 0, over = 1 }, { wait = 30 }, { speed = 1.5, over = 20 }, { wait = 58 },
  { speed = 0, over = 8 }, { wait = 20 }, { turn = 180, speed = 0.6 }, { speed = 3, over = 40 } }

-- Cinder spits whether the press is open or shut.
local function hammer(e)
  for k = 1, forever do
    rest(e, by_difficulty { easy = 94, normal = 54, hard = 51, abyss = 50 })
    pattern.whip { from = e, dy = 16, kind = "rice", bank = 7, aim = true, speed = 1.4,
                   speed_to = 2.1, bend = k % 2 == 0 and 30 or -30, delay = 14,
                   n = by_difficulty { easy = 3, normal = 5, hard = 6 } }
  end
end

local function press(e)
  task.go(hammer, e)
  wait(90)
  while true do
    local first = rng.int(2, 7) -- row of the gap
    local open = by_difficulty { easy = 6, normal = 5, hard = 4, abyss = 3 }
    sound.play("charge", { from = e })
    pose.attack(e, 60)
    for row = 0, 15 do
      if row < first or row >= first + open then
        local y = LOW - STEP * row
        bullet.fire { kind = "ingot", bank = 7, x = 4, y = y, dir = 0, speed = 0, delay = 40,
                      motion = shut }
        bullet.fire { kind = "ingot", bank = 7, x = 236, y = y, dir = 180, speed = 0, delay = 40,
                      motion = shut }
      end
    end
    wait(150)
    sound.play("gear", { from = e })
    screen.shake { size = 2, over = 12 }
    rest(e, by_difficulty { easy = 180, normal = 140, hard = 120, abyss = 110 })
    e:move { x = rng.int(50, 100), y = rng.int(80, 100), over = 50, ease = "both" }
  end
end

local function curtain(e)
  wait(30)
  for k = 1, forever do
    local n = by_difficulty { easy = 15, normal = 31, hard = 34, abyss = 40 }
    local thick = k % 3 == 0 -- steam: fewer, wider bullets
    if angry(e) then n = n + 4 end
    if thick then pose.attack(e, 30) end
    pattern.ring { from = e, dy = 8, kind = thick and "steam" or "orb", dir = 137.5 * k,
                   bank = thick and 0 or 5 + k % 2, n = thick and n // 2 or n,
                   speed = by_difficulty { easy = 1, abyss = 0.85 } }
    rest(e, by_difficulty { easy = 46, normal = 24, hard = 22, abyss = 19 })
    if k % 4 == 0 then
      e:move { x = rng.int(140, 190), y = rng.int(78, 98), over = 60, ease = "both" }
    end
  end
end

-- What their bullets become when a phase is beaten.
local FOAM = { items = "foam", spark = "pop" }

boss.def("eels", { title = "Cinder and Quench", music = "furnace", warning = 120,
  epithet = "Keepers of the Fire", entrance = "bubbles", bg = "hearth",
  cast = { { name = "cinder", title = "Cinder", kind = "cinder", x = 68, y = 90,
             portrait = "cinder_cross", cut_in = "cinder_cut_in", hurt = "cinder_hurt",
             broken = "cinder_broken" },
           { name = "quench", title = "Quench", kind = "quench", x = 172, y = 90,
             portrait = "quench_cross", cut_in = "quench_cut_in", portrait_left = true, hurt = "quench_hurt",
             broken = "quench_broken" } },
  phases = {
    { talk = meeting },
    { id = "both", hp = { cinder = 380, quench = 380 }, time = 34 * 60, run = pair(sparks, bars),
      clear = FOAM, drops = { pearl = 6 } },
    { id = "furnace", spell = "Furnace Sign: Poured Glass", hp = { cinder = 760 }, time = 34 * 60,
      bonus = 20000, bonus_to = 6000, run = furnace, clear = FOAM, drops = { pearl = 8 } },
    { id = "panes", spell = "Temper Sign: Panes in Rows", hp = { quench = 700 }, time = 36 * 60,
      bonus = 20000, bonus_to = 6000, run = panes, clear = FOAM, drops = { conch = 1 } },
    { id = "crossing", spell = "Alloy Sign: Thrown Back", hp = 800, time = 36 * 60, bonus = 25000,
      bonus_to = 8000, run = crossing, clear = FOAM, drops = { pearl = 8 } },
    { id = "press", spell = "Last Sign: The Press", hp = { cinder = 420, quench = 420 },
      time = 44 * 60, bonus = 40000, bonus_to = 13000, run = pair(press, curtain), clear = FOAM,
      drops = { pearl = 8, heart = 1 } } } })

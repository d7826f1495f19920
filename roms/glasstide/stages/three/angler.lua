-- stages/three/angler.lua - the midboss, in lightless water: the Anglerlamp. Only its eyes, its
-- teeth, and the lamp that it holds out are visible.
local kinds = require "kinds"
local pose = require "pose"
local by = require "stages/three/by"
local pace = require "stages/three/pace"
local scene = require "stages/three/scene"
local fast, soon = pace.fast, pace.soon

local ROOT <const> = -42  -- y where its stalk begins, from its centre
local FIRST <const>, LAST <const> = 10 * 16 + 1, 13 * 16 + 15 -- the colours that light up and go dark

-- Its stalk is a row of beads from its brow to the swinging lamp.
local BEADS <const> = 9

local function stalk(e)
  local lamp = e:parts("lamp")[1]
  local beads = {}
  for i = 1, BEADS do beads[i] = sprite.put { sprite = "stalk", follow = e, layer = "middle" } end
  sprite.put { sprite = "lamplight", follow = lamp, dy = 2, layer = "back", blend = "light" }
  while lamp.alive do
    local tx, ty = lamp.dx, lamp.dy - 12
    for i, bead in ipairs(beads) do
      local t = i / BEADS
      local u = 1 - t
      bead.dx = 2 * u * t * (tx * 0.7) + t * t * tx
      bead.dy = u * u * ROOT + 2 * u * t * (ROOT - 46) + t * t * ty
    end
    wait(1)
  end
end

enemy.def("lantern", { sprite = "lantern", hit = { circle = 11 }, hp = 60000, spark = "crumb",
                       blink = kinds.BLINK, on_hit = kinds.chip })
enemy.def("angler", { sprite = "angler", hit = { box = { 76, 62 } }, hp = 100, score = 40000,
                      spark = "crumb", blink = kinds.BLINK, blink_soft = true, on_hit = kinds.chip,
                      on_death = kinds.huge, drops = { pearl = 10, conch = 1 }, run = stalk,
                      pictures = { attack = "angler_attack" },
                      parts = { { kind = "lantern", dx = 0, dy = 44, share = 1, tag = "lamp" } } })

-- The lamp flares: everything is visible for a moment, then fades back into the dark.
local function flare()
  palette.fade { to = "three", over = 6, first = FIRST, last = LAST }
  task.go(function()
    wait(26)
    palette.fade { to = "dark", over = 50, first = FIRST, last = LAST }
  end)
end

local function lamp_of(e) return e:parts("lamp")[1] end

local function swing(e, over)
  e:move { x = rng.int(90, 150), y = rng.int(84, 102), over = over, ease = "both" }
end

-- 1. The bait swings to and fro and sheds light that falls on both sides in arcs, like a fountain.
-- Now and then the Anglerlamp snaps at you; later the
-- bait bursts into two rings whenever it flares, which bend across each other.
local function bow(name, turn, over, speed)
  motion.def { name = name .. " left",  { wait = 8 }, { turn = -turn, over = over },
               { speed = speed, over = 40 } }
  motion.def { name = name .. " right", { wait = 8 }, { turn = turn, over = over },
               { speed = speed, over = 40 } }
end
bow("bow", 1.5, 76, 1.8)
bow("slow bow", 1.0, 114, 1)

-- Arcs of one volley nest inside each other; those of the next one lean.
local function fountain(e)
  local lamp = lamp_of(e)
  local name = by("bow", "bow", "bow", "slow bow")
  for k = 0, forever do
    local lean = 30 * angle.sin(by(9, 9, 9, 7) * k)
    for i = 1, by(2, 3, 5, 7) do
      local speed = by(0.6, 0.6, 0.6, 0.45) + by(0.5, 0.42, 0.36, 0.22) * i
      bullet.fire { from = lamp, kind = "drop", bank = 2, dir = 204 + lean, speed = speed,
                    motion = name .. " left" }
      bullet.fire { from = lamp, kind = "drop", bank = 2, dir = 336 + lean, speed = speed,
                    motion = name .. " right" }
    end
    wait(soon(39, 16, 15, 12))
  end
end

local function bait(e)
  scene.lightless()
  local lamp = lamp_of(e)
  task.go(function()
    for k = 0, forever do
      lamp.dx, lamp.dy = 54 * angle.sin(1.7 * k), 40 - 14 * angle.cos(3.4 * k)
      wait(1)
    end
  end)
  task.go(fountain, e)
  task.go(function()
    for k = 1, by(0, 0, forever, forever) do -- rings from its mouth
      wait(by(104, 58, 73, 50))
      pattern.ring { from = e, dy = 18, kind = "orb", bank = 0, dir = 7.5 * k, n = by(8, 8, 14, 26),
                     speed = by(1, 1, 1.1, 0.8) }
    end
  end)
  for k = 1, forever do
    wait(soon(162, 122, 100, 100))
    flare()
    sound.play("angler", { from = e })
    if k > 2 then
      for _, side in ipairs { "left", "right" } do
        pattern.ring { from = lamp, kind = "drop", bank = 3, n = by(5, 9, 12, 16), dir = 17 * k, speed = 0.9,
                       motion = "slow bow " .. side }
      end
    end
    pose.attack(e, 70)
    wait(24)
    pattern.fan { from = e, dy = 22, kind = "kunai", bank = 1, aim = true,
                  spread = by(0, 40, 54, 80), n = by(1, 5, 7, 11), delay = 20,
                  speed = fast(1.9, 2.2, 2.3, 1.7) }
    swing(e, 60)
  end
end

-- 2. It breathes slow pearls into the dark. When the lamp is struck, pearls in its light stop,
-- catch fire, and fly away from it.
local LIT <const> = 74 -- px that the light reaches

motion.def { name = "catch fire", { speed = 0, over = 8 }, { bank = 2 }, { wait = 26 },
             { speed = 1.7, over = 26 } }
motion.def { name = "smoulder", { speed = 0, over = 8 }, { bank = 2 }, { wait = 30 },
             { speed = 1.2, over = 40 } }

local function strike(lamp)
  local motion_name = by("smoulder", "catch fire", "catch fire", "smoulder")
  sound.play("beam", { from = lamp })
  flare()
  spark.burst { kind = "shock", from = lamp, speed = 0 }
  bullet.each("pearl", function(b)
    local dx, dy = b.x - lamp.x, b.y - lamp.y
    if dx * dx + dy * dy > LIT * LIT then return end
    b.dir, b.motion, b.tag = angle.of(dx, dy), motion_name, "fire"
  end)
  local aims = by(false, false, true, true)
  local dir = aims and 0 or rng.dir()
  for i = 1, by(1, 1, 2, 3) do
    pattern.ring { from = lamp, kind = "petal", bank = 1, n = by(8, 14, 18, 24),
                   dir = dir + 5 * i, aim = aims,
                   speed = by(1.3, 1.6, 1.8, 1.5) - 0.22 * (i - 1), delay = 20 }
  end
end

local function breathe(e)
  for k = 0, forever do
    pattern.ring { from = e, dy = 18, kind = "orb", bank = 0, tag = "pearl", n = by(13, 20, 26, 32),
                   dir = 6.5 * k, speed = by(0.95, 1.05, 1.1, 0.8), skip = { 1, 2 } }
    wait(by(27, 19, 17, 17))
  end
end

local function match(e)
  scene.lightless()
  local lamp = lamp_of(e)
  task.go(breathe, e)
  wait(60)
  for k = 1, forever do
    local side = k % 2 == 0 and 1 or -1
    lamp:move { dx = side * rng.int(30, 78), dy = rng.int(40, 84), over = 64, ease = "both" }
    wait(64)
    sound.play("charge", { from = lamp })
    for _ = 1, 6 do -- announces the strike and shows the reach of its light
      spark.burst { kind = "ping", from = lamp, n = 10, radius = LIT - 22, speed = 1.4 }
      wait(6)
    end
    pose.attack(e, 40)
    strike(lamp)
    wait(by(74, 54, 47, 46))
    swing(e, 60)
  end
end

-- 3. Teeth come out of the dark on both sides, shut except for a gap, and fall. Meanwhile the
-- Anglerlamp fires at you through the gap.
value.def("home_x")
value.def("home_y")
motion.def { name = "tooth", { go_to = { "home_x", "home_y" }, over = 84, ease = "both" },
             { wait = 30 }, { dir = 90 }, { speed = 1.5, over = 60 } }

-- One tooth, a row of n bullets, that goes from the wall to x = `tip`.
local function tooth(side, y, tip)
  local n = by(3, 3, 4, 6)
  local wall = side < 0 and 4 or 236
  for i = 0, n - 1 do
    bullet.fire { kind = i == 0 and "kunai" or "orb", bank = i == 0 and 1 or 0, x = wall, y = y,
                  dir = side < 0 and 0 or 180, speed = 0.1, delay = 44,
                  home_x = tip + side * i * by(13, 13, 12, 11), home_y = y, motion = "tooth" }
  end
end

local function jaws(k)
  local wide = by(84, 66, 56, 46)
  local middle = 120 + by(30, 40, 50, 56) * angle.sin(77 * k)
  local rows, apart = by(4, 5, 7, 8), by(52, 42, 29, 25)
  for row = 0, rows - 1 do
    local y = 116 + apart * row
    tooth(-1, y, middle - wide / 2)
    tooth(1, y + apart / 2, middle + wide / 2)
  end
end

local function teeth(e)
  scene.lightless()
  local lamp = lamp_of(e)
  lamp:move { dx = 0, dy = -58, over = 50, ease = "both" }
  task.go(function()
    wait(60)
    while true do
      pattern.fan { from = e, dy = 22, kind = "pearl", bank = 2, aim = true, n = by(1, 1, 3, 3),
                    spread = by(0, 0, 40, 46), speed = by(1.2, 1.5, 1.6, 1.2), delay = 22 }
      wait(by(151, 77, 64, 50))
    end
  end)
  task.go(function()
    for k = 0, by(-1, forever, forever, forever) do -- rain from the lamp, a curtain on abyss
      pattern.ring { from = lamp, kind = "pellet", bank = 3, n = by(5, 7, 10, 18), dir = 8.5 * k,
                     speed = by(0.9, 1.05, 1.15, 0.85) }
      wait(by(69, 66, 45, 22))
    end
  end)
  for k = 1, forever do
    flare()
    sound.play("charge", { from = e })
    pose.attack(e, 90)
    jaws(k)
    wait(44)
    e:move { x = 120 + 30 * angle.sin(77 * k), y = 88, over = 80, ease = "both" }
    wait(by(287, 206, 185, 167))
  end
end

local FOAM = { items = "foam", spark = "pop" }

boss.def("angler", { title = "Anglerlamp", kind = "angler", x = 120, y = 94, music = "lantern",
  entrance = "bubbles", bg = "lightless", hurt = "angler_hurt", broken = "angler_broken",
  phases = {
  { id = "bait", hp = 1800, time = 34 * 60, run = bait, clear = FOAM, drops = { pearl = 5 } },
  { id = "match", spell = "Lamp Sign: Struck Match", hp = 1720, time = 40 * 60, bonus = 20000,
    bonus_to = 6000, run = match, clear = FOAM, drops = { pearl = 6 } },
  { id = "teeth", spell = "Jaw Sign: Closing Teeth", hp = 1720, time = 40 * 60, bonus = 20000,
    bonus_to = 6000, run = teeth, clear = FOAM } } })

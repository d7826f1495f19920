-- stages/one/hatches.lua - the wreck of the lamp ship: its hatches open one after another, and the
-- creatures that live in the hold come out.
local habits = require "stages/one/habits"
local scene = require "stages/one/scene"
local hatches = {}

-- Each hatch: x from the deck's middle, y from its stern, and what comes out.
local LIST = {
  { -26, 516, "krill" }, { 32, 492, "krill" }, { 0, 446, "breath" }, { -38, 342, "arrow" },
  { 40, 256, "arrow" }, { -6, 210, "breath" }, { -28, 60, "krill" }, { 26, 24, "krill" },
}

local function open(e)
  sound.play("hatch", { from = e })
  for _, name in ipairs { "ajar", "half", "open" } do
    e.picture = name
    wait(8)
  end
  spark.burst { kind = "fizz", from = e, n = 10, speed = 1.2 }
end

-- Out of the hatch, to the side, and down.
local route = {}
for i, way in ipairs { -1, 1 } do
  route[i] = path.def {
    { x = 0, y = 0 }, { x = 44 * way, y = -26, over = 40, ease = "out" },
    { x = 64 * way, y = 40, over = 46, ease = "both" }, { x = -30 * way, y = 330, over = 130 } }
end
local rise = path.def {
  { x = 0, y = 0 }, { x = 0, y = -24, over = 46, ease = "out" }, { wait = 150 },
  { x = 0, y = 330, over = 100, ease = "in" } }

local function swarm(e)
  for i = 1, by_difficulty { easy = 3, normal = 6 } do
    enemy.spawn { kind = "krill", path = route[i % 2 + 1], dx = e.x, dy = e.y, run = habits.spit }
    wait(14)
  end
end

local function archer(e)
  for i = 1, by_difficulty { easy = 1, hard = 2 } do
    if i > 1 then wait(50) end
    enemy.spawn { kind = "arrow", path = rise, dx = e.x, dy = e.y, run = habits.salvo }
  end
end

-- Breath of the Hold: slow rings, each through the gaps of the last.
local function breathe(e)
  for k = 1, by_difficulty { easy = 2, normal = 5, abyss = 7 } do
    if e.y > 190 then return end
    pattern.ring { from = e, kind = "ring", bank = k % 2 == 0 and 3 or 2, dir = 9 * k,
                   n = by_difficulty { easy = 8, normal = 18, hard = 22, abyss = 27 },
                   delay = 12,
                   speed = by_difficulty { easy = 1.2, normal = 1.4, hard = 1.5, abyss = 1.15 } }
    wait(by_difficulty { easy = 34, normal = 22, abyss = 15 })
  end
end

local LETS_GO = { krill = swarm, arrow = archer, breath = breathe }

function hatches.open(hull, middle)
  scene.settle(hull, middle, LIST, "hatch", function(e, h)
    wait(44)
    open(e)
    LETS_GO[h[3]](e)
  end)
end

return hatches

-- boss.lua - a boss fight: rings of 20 to 200 bullets every few frames, so that n are live. Four in five are rotated, one in
-- five is blended, and two in five run a program. It has a boss, sparks, lasers, items, scrolling layers and rows of text.
--
-- DIP price_part omits one part of it, or makes everything blend through a table (everything).
--
-- A ring's bullets live LIFE frames, so n / LIFE bullets are fired per frame; remainders are carried over in halves.
local LIFE = 160
local RINGS = { 20, 60, 200, 40, 120, 30, 90, 160, 50, 80 }
local SPARKS, BURST = 60, 5 -- 300 alive at the end of a frame

-- The kinds in rotation: of 10, 8 are rotated, 2 blended, and 1 of each group plain.
local function kinds()
  local blend = board.dip("price_part") == "everything" and "glow" or "shine"
  local list = {}
  local function kind(name, sprite, more)
    bullet.def(name, { sprite = sprite, hit = { circle = 3 }, turns = more.turns, blend = more.blend })
    list[#list + 1] = name
  end
  kind("needle", "turn8", { turns = true })
  kind("rice", "turn12", { turns = true })
  kind("lance", "turn16", { turns = true })
  kind("spark", "turn12", { turns = true, blend = blend })
  kind("orb", "d12", {})
  kind("petal", "turn12", { turns = true })
  kind("kunai", "turn16", { turns = true })
  kind("scale", "turn8", { turns = true })
  kind("mist", "turn16", { turns = true, blend = blend })
  kind("dot", "d8", {})
  return list
end

-- Two in five rings run one of these programs; all bullets die after LIFE frames.
local function programs()
  local gone = { { wait = LIFE }, { die = true } }
  return {
    motion.def(gone), motion.def { { turn = 1.5, over = LIFE }, { die = true } }, motion.def(gone),
    motion.def { { speed = 0.3, over = 40 }, { speed = 1.1, over = 60 }, { wait = LIFE - 100 }, { die = true } },
    motion.def(gone),
  }
end

-- The speeds keep most bullets on the field for LIFE frames.
local function fire_rings(boss, n, list, moves)
  local owed, k = 0, 0
  while true do
    owed = owed + n / LIFE
    while owed >= RINGS[k % #RINGS + 1] do
      local m = RINGS[k % #RINGS + 1]
      pattern.ring { from = boss, kind = list[k % #list + 1], n = m, dir = 7 * k, speed = 0.35 + 0.08 * (k % 7),
                     bank = k % 8, motion = moves[k % #moves + 1] }
      owed, k = owed - m, k + 1
    end
    wait(1)
  end
end

local function surroundings()
  local part = board.dip("price_part")
  laser.def("ray", { strip = "ray", width = 8, hit = { share = 0.5 } })
  item.def("coin", { sprite = "d12", radius = 0, gravity = 0.00005, top = 0.001 })
  spark.def("cinder", { sprite = "d12", life = SPARKS, gravity = 0.02, drag = 0.03 })
  bg.def("sky", function()
    bg.layer(1).map, bg.layer(1).vy = "sea", 0.5
    bg.layer(2).map, bg.layer(2).vy = "clouds", 0.8
  end)
  return function(boss)
    if part ~= "no_scenery" then bg.show("sky", { over = 0 }) end
    for i = 1, part == "no_lasers" and 0 or 8 do
      laser.beam { kind = "ray", x = 40 * i - 20, y = 10, dir = 90, length = 220, warn = 0, grow = 0, hold = forever,
                   spin = 0.4, bank = i % 8 }
    end
    for i = 1, part == "no_items" and 0 or 64 do item.drop { kind = "coin", x = i % 32 * 10, y = 200 + i // 32 * 8, speed = 0 } end
    task.go(function()
      while true do
        if part ~= "no_sparks" then spark.burst { kind = "cinder", from = boss, n = BURST, speed = 2 } end
        text.put { col = 1, row = 1, text = ("%09d"):format(board.frame() * 10) }
        wait(1)
      end
    end)
  end
end

return function(n)
  local list, moves, surround = kinds(), programs(), surroundings()
  enemy.def("boss", { sprite = "d24", hit = { box = { 24, 24 } }, hp = 1000000 })
  return function()
    local boss = enemy.spawn { kind = "boss", x = 160, y = 90 }
    surround(boss)
    fire_rings(boss, n, list, moves)
  end
end

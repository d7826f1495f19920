-- together.lua - everything at once, or the part that DIP price_part selects: n bullets of the crowd, 56 curves of 64 points and
-- 8 turning beams, items all over the top, falling sparks, and three tile layers with a plane. Expired things are replaced, so
-- that their number is the same in every frame.
local part = board.dip("price_part")
local function with(what) return part == "everything" or part == "only_" .. what end

local CURVES, BEAMS, ITEMS = 56, 8, 512
local LIFE, BURST = 65, 32 -- 64 bursts, 2,048 sparks, are alive at the end of a frame

local function lasers()
  laser.def("worm", { strip = "ray", width = 8, hit = { share = 0.5 } })
  local round = { motion.def { { turn = 4, over = forever } }, motion.def { { turn = -5, over = forever } } }
  return function()
    for i = 1, CURVES do
      laser.curve { kind = "worm", x = 60 + 200 * (i % 8) / 7, y = 60 + 120 * (i // 8) / 7, dir = i * 45, speed = 2.5,
        points = 64, motion = round[i % 2 + 1], bank = i % 8 }
    end
    for i = 1, BEAMS do
      laser.beam { kind = "worm", x = 40 * i - 20, y = 20, dir = 90, length = 200, warn = 0, grow = 0, hold = forever,
        spin = 0.5, bank = i % 8 }
    end
  end
end

local function items()
  item.def("coin", { sprite = "d12", radius = 0, gravity = 0.00005, top = 0.001 })
  return function()
    for i = 1, ITEMS do item.drop { kind = "coin", x = i % 64 * 5, y = i // 64 * 8, speed = 0 } end
  end
end

local function sparks()
  spark.def("cinder", { sprite = "d12", life = LIFE, gravity = 0.02, drag = 0.03, banks = { 3, 2, 5, 1 } })
  return function()
    task.go(function()
      while true do
        spark.burst { kind = "cinder", x = 60, y = 120, to_x = 260, to_y = 120, n = BURST, dir = 270, spread = 90, speed = 1 }
        wait(1)
      end
    end)
  end
end

local function scenery()
  bg.def("coast", function()
    local sea, low, high, floor = bg.layer(1), bg.layer(2), bg.layer(3), bg.plane()
    sea.map, sea.vy = "sea", 0.5
    low.map, low.x, low.vy = "clouds", 40, 0.8
    high.map, high.vx, high.vy = "clouds", -0.25, 1.5
    for i = 1, 3 do bg.lines(i, { wave = 5, every = 64, speed = 0.5 }) end
    floor.map, floor.horizon, floor.height, floor.dir, floor.vy = "slabs", 120, 24, 270, -1.5
    floor.fog = { to = 0x3c4c88, far = 900 }
  end)
  return function() bg.show("coast", { over = 0 }) end
end

return function(n)
  local make = {
    bullets = with("bullets") and require("crowd")(n), lasers = with("lasers") and lasers(),
    items = with("items") and items(), sparks = with("sparks") and sparks(), scenery = with("scenery") and scenery(),
  }
  return function()
    for _, what in ipairs { "scenery", "bullets", "lasers", "items", "sparks" } do
      if make[what] then make[what]() end
    end
  end
end

-- prices.lua - n bullets that all do the same thing each frame, selected by DIP price, price_figure, _kind, _step or _verb, for
-- comparison with n bullets that fly straight. They creep, so that none leaves the field, and stay away from the player unless
-- the case needs them near.
local price = board.dip("price")
for _, part in ipairs { "figure", "kind", "step", "verb" } do
  local word = board.dip("price_" .. part)
  if word ~= "none" then price = word end
end

bullet.def("d8", { sprite = "d8", hit = { circle = 3 } })
if price == "value" or price == "named" or price == "valued" then value.def("curl") end

local function ever(...) return motion.def { { loop = forever, ... } } end

-- A program for each motion op, active in every frame.
local ops = {
  ever { wait = 60 },
  ever { kind = "d8", over = 1 },
  ever { bank = 3, over = 1 },
  ever({ dir = 90 }, { wait = 1 }),
  ever { aim = true, over = 60 },
  ever { turn = 1, over = 60 },
  ever { home = 1, over = 60 },
  ever({ speed = 0.02, over = 60 }, { speed = 0.01, over = 60 }),
  ever({ accel = 0.0001, over = 60 }, { accel = -0.0001, over = 60 }),
  ever { loop = 2, { wait = 1 } },
}
local drive = { loop = forever, { turn = 1, speed = 0.02, over = 60 }, { turn = 1, speed = 0.01, over = 60 } }
local fine_drive = motion.def { fine = true, drive }
local gone = motion.def { { die = true } }
local motions = {
  accel = ops[9], turn = ops[6], aim = ops[5], home = ops[7],
  drive = motion.def { drive },
  fine = motion.def { fine = true },
  fine_drive = fine_drive,
  go_to = ever({ go_to = { 100, 4 }, over = 60 }, { go_to = { 150, 12 }, over = 60 }),
  polar = motion.def { { polar = 0.001, spin = 1, over = forever } },
  orbit = motion.def { { orbit = 4, at = { 128, 8 }, spin = 1, over = forever } },
  wave = motion.def { { wave = 4, every = 60, over = forever } },
  bounce = motion.def { { bounce = forever } },
  await = motion.def { { wait_for = { near = 0 } } },
  signal = motion.def { { wait_for = { tag = "all" } } },
  path = ever { path = path.def { { x = 0, y = 0 }, { x = 1, y = 1, over = 60 }, { x = 0, y = 0, over = 60 } } },
  emit = ever({ emit = { pattern = "ring", n = 63, kind = "d8", speed = 0.001, motion = gone } }, { wait = 1 }),
}
if price == "around" then motions.around = motion.def { { orbit = 4, spin = 1, over = forever } } end
if price == "named" then motions.named = ever { turn = "curl", over = 60 } end

-- Extra options for the fired bullets.
local with = {
  delay = { delay = 1000000 }, named = { curl = 1 }, hp = { kind = "d8hp" },
}

-- Shapes of equal size for bullets around the player. The unused kind `reach` widens the range of the hit test, so that all
-- of them are close although they touch nothing.
local shapes = {
  circle = { hit = { circle = 3 } },
  box = { hit = { box = { 6, 6 } } },
  capsule = { hit = { capsule = { 4, 1 } } },
  circles = { hit = { circles = { { -2, 0, 1 }, { 0, 0, 1 }, { 2, 0, 1 } } } },
  turned_circles = { hit = { circles = { { -2, 0, 1 }, { 0, 0, 1 }, { 2, 0, 1 } } }, turns = true },
}
if shapes[price] then
  shapes[price].sprite = "d8"
  bullet.def("shape", shapes[price])
  bullet.def("reach", { sprite = "d8", hit = { circle = 40 } })
end
if price == "hp" then
  bullet.def("d8hp", { sprite = "d8", hit = { circle = 3 }, hp = 9 })
  shot.def("still", { sprite = "d8", hit = { circle = 3 } })
end

local function motion_of(i)
  if price == "mixed" then return ops[i % #ops + 1] end
  if price == "half" then return i % 2 == 0 and ops[i // 2 % #ops + 1] or nil end
  return motions[price]
end

local function fire(i)
  local b = { kind = "d8", x = i % 64 * 4, y = i // 64 % 16, dir = 7 * i, speed = 0.001, tag = "all", motion = motion_of(i) }
  for name, v in pairs(with[price] or {}) do b[name] = v end
  if shapes[price] then b.kind, b.x, b.y = "shape", 160 + 32 * angle.cos(11 * i), 120 + 32 * angle.sin(11 * i) end
  if price == "around" then b.around = player.get(1) end
  return bullet.fire(b)
end

-- One bullet that is fired and removed in the same frame.
local fires = {
  fire = function(i)
    bullet.fire { kind = "d8", x = i % 64 * 4, y = i // 64 % 16, dir = 7 * i, speed = 0.001, tag = "all", motion = gone }
  end,
  valued = function(i)
    bullet.fire { kind = "d8", x = i % 64 * 4, y = i // 64 % 16, dir = 7 * i, speed = 0.001, tag = "all", motion = gone,
                  curl = 1 }
  end,
}

local kept = { kind = "d8", speed = 0.001, tag = "all", motion = gone }
function fires.kept(i)
  kept.x, kept.y, kept.dir = i % 64 * 4, i // 64 % 16, 7 * i
  bullet.fire(kept)
end

-- A figure of 64 bullets.
local points, rows = {}, {}
for i = 1, 64 do points[i] = { i % 8, i // 8 } end
for i = 1, 8 do rows[i] = "########" end
local figures = {
  ring = {}, fan = { spread = 60 }, arc = { sweep = 180 }, stack = { speed_to = 0.002 }, line = { width = 60 },
  polygon = { sides = 4 }, star = { points = 4 }, ellipse = { speed_to = 0.002 }, rose = { petals = 5, speed_to = 0.002 },
  whip = { speed_to = 0.002, bend = 40 }, scatter = { spread = 60, speed_to = 0.002 },
  points = { list = points, n = false }, dots = { dots = table.concat(rows, "\n"), n = false },
}

local function draw(n)
  local figure = { kind = "d8", x = 128, y = 8, speed = 0.001, motion = gone, n = 64 }
  for name, v in pairs(figures[price]) do figure[name] = v or nil end
  local f = pattern[price == "dots" and "picture" or price]
  return function() for _ = 1, n // 64 do f(figure) end end
end

-- The action of each frame once n bullets are fired. It works where there are no bullets, so it finds and clears nothing. The
-- line passes them at a corner, so that its bounding box contains all of them.
local aside = { x = 300, y = 200 }
local from, to = { x = -100, y = 300 }, { x = 300, y = -10 }
local all
local verbs = {
  group = function() all.bank = 3 end,
  shift = function() all:shift(0, 0) end,
  aim_all = function() all:aim() end,
  turn_all = function() all:turn(1) end,
  value = function() all.curl = 3 end,
  each = function() bullet.each("all", function(b) b.bank = 3 end) end,
  clear_circle = function() bullet.clear { x = aside.x, y = aside.y, radius = 8 } end,
  clear_box = function() bullet.clear { x = aside.x, y = aside.y, w = 16, h = 16 } end,
  clear_line = function() bullet.clear { x = from.x, y = from.y, to_x = to.x, to_y = to.y, width = 4 } end,
  near = function() query.near { what = "bullet", x = aside.x, y = aside.y, radius = 8 } end,
  near_box = function() query.box { what = "bullet", x = aside.x, y = aside.y, w = 16, h = 16 } end,
  near_line = function() query.line { what = "bullet", x = from.x, y = from.y, to_x = to.x, to_y = to.y, width = 4 } end,
  found = function() query.box { what = "bullet", x = 128, y = 8, w = 600, h = 600 } end,
}

local function fire_all(n)
  for i = 1, n do
    local b = fire(i)
    if price == "task" then task.own(b, function() while true do wait(1) end end) end
  end
  all = bullet.group("all")
  if price == "frozen" then all.frozen = forever end
  if price == "sweep" then bullet.sweep { x = aside.x, y = aside.y, radius = 1, radius_to = 8, over = 65535 } end
  if price == "hp" then for _ = 1, 64 do shot.fire { kind = "still", x = aside.x, y = aside.y, speed = 0 } end end
end

-- The action of each frame, or nil.
local function each_frame(n)
  local one = fires[price]
  if one then return function() for i = 1, n do one(i) end end end
  if figures[price] then return draw(n) end
  fire_all(price == "emit" and n // 64 or n) -- the bullets they emit are gone in the next frame
  local p = player.get(1)
  return shapes[price] and function() p.x, p.y = 160, 120 end or verbs[price]
end

return function(n)
  return function()
    local f = each_frame(n)
    while f do f() wait(1) end
  end
end

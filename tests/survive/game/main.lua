-- main.lua - sets of bullets of which it is known whether they can be survived: some with a way (`can_...`), by
-- tests/survive/known, and some without (`cannot_...`), each for the reason that its comment gives. The ship is a
-- circle of radius 2, so 4 px wide, flies 2 px a frame, 1 with focus, and begins at (48, 112). A round bullet has a
-- radius of 3, so that no ship's middle is within 5 px of its own.
player.def("ship", { sprite = "dot", hit = { circle = 2 }, speed = 2, focus = 1, lives = 1, safe = 1 })
bullet.def("orb", { sprite = "dot", hit = { circle = 3 } })
bullet.def("still", { sprite = "dot", hit = { circle = 3 }, swept = false })
bullet.def("brick", { sprite = "dot", hit = { box = { 8, 8 } } })
bullet.def("bar", { sprite = "dot", hit = { capsule = { 24, 3 } } })
bullet.def("moon", { sprite = "dot", hit = { circle = 30 } })
bullet.def("sky", { sprite = "dot", hit = { circle = 55 } })
bullet.def("pair", { sprite = "dot", hit = { circles = { { -6, 0, 3 }, { 6, 0, 3 } } } })
laser.def("ray", { strip = "line", width = 10, hit = { share = 1 } })
enemy.def("ram", { sprite = "dot", hit = { box = { 16, 12 } }, hp = 1000000 })

local W <const> = 96

-- A wall of bullets across the field at y, that falls; `gap` px are free from x = at on.
local function wall(t)
  local function put(x)
    bullet.fire { kind = t.kind or "orb", x = x, y = t.y or -8, dir = t.dir or 90, speed = t.speed or 2 }
  end
  local half, every = t.half or 3, t.every or 4
  if not t.gap then
    for x = -10, W + 10, every do put(x) end
    return
  end
  for x = t.at - half, -20, -every do put(x) end
  for x = t.at + t.gap + half, W + 20, every do put(x) end
end

-- A ring of n bullets round (x, y) that closes; `skip` of them are not there.
local function ring(n, r, skip, speed)
  for i = skip, n - 1 do
    local a = math.rad(360 * i / n + 90 + 180 * (skip - 1) / n * -1)
    local x, y = 48 + r * math.cos(a), 100 + r * math.sin(a)
    bullet.fire { kind = "orb", x = x, y = y, dir = math.deg(a) + 180, speed = speed or 0.5 }
  end
end

-- Bullets on both sides of a lane whose left edge goes as x(y) says, for `n` rows of 4 px that fall.
local function lane(n, gap, x)
  task.go(function()
    for i = 0, n - 1 do
      for side = x(i) - 3, x(i) - 30, -6 do bullet.fire { kind = "orb", x = side, y = -8, speed = 2 } end
      for side = x(i) + gap + 3, x(i) + gap + 30, 6 do bullet.fire { kind = "orb", x = side, y = -8, speed = 2 } end
      wait(2)
    end
  end)
end

local function beams(list)
  for _, x in ipairs(list) do
    laser.beam { kind = "ray", x = x, y = -4, dir = 90, length = 200, hold = 60, warn = 30, grow = 1, fade = 4 }
  end
end

local function rams(list, speed)
  for _, x in ipairs(list) do
    enemy.spawn { kind = "ram", x = x, y = -10, run = function(e)
      while true do e.y = e.y + speed wait(1) end
    end }
  end
end

local function every(n, frames, f)
  task.go(function()
    for i = 1, n do
      f(i)
      wait(frames)
    end
  end)
end

local sets = {
  -- one pixel more, and one less, than the ship is wide
  can_gap = function() wall { at = 45.5, gap = 5 } end,
  cannot_gap = function() wall { at = 46.5, gap = 3 } end,
  -- a gap at the other end of the field: time enough, and not
  can_reach = function() wall { at = 10, gap = 8, y = -60 } end,
  cannot_reach = function() wall { at = 8, gap = 6, y = 72, speed = 3 } end,
  -- one wall after another, gaps at both ends
  can_zigzag = function() every(3, 50, function(i) wall { at = i % 2 == 1 and 20 or 70, gap = 8 } end) end,
  cannot_zigzag = function() every(3, 12, function(i) wall { at = i % 2 == 1 and 12 or 78, gap = 8 } end) end,
  -- too fast to be anywhere between two frames
  can_fast = function() wall { at = 40, gap = 16, speed = 12 } end,
  cannot_fast = function() wall { speed = 12 } end,
  -- hit where it is alone, but slow
  can_not_swept = function() wall { kind = "still", at = 44, gap = 8, speed = 1 } end,
  cannot_not_swept = function() wall { kind = "still", speed = 1 } end,
  -- boxes
  can_bricks = function() wall { kind = "brick", half = 4, every = 8, at = 45.5, gap = 5 } end,
  cannot_bricks = function() wall { kind = "brick", half = 4, every = 8, at = 46.5, gap = 3 } end,
  -- bars that lie across, and two circles to a bullet
  can_bars = function()
    for i = 0, 1 do bullet.fire { kind = "bar", x = 16 + i * 64, y = -8, dir = 90, speed = 2 } end
  end,
  cannot_bars = function()
    for x = 0, W, 6 do bullet.fire { kind = "bar", x = x, y = -20, dir = 90, speed = 2 } end
  end,
  can_pairs = function()
    for _, x in ipairs { 0, 18, 78, 96 } do wall { kind = "pair", at = x, gap = 0, every = 999 } end
  end,
  cannot_pairs = function() wall { kind = "pair", every = 5 } end,
  -- one that is large, and one that is wider than the field
  can_moon = function() bullet.fire { kind = "moon", x = 48, y = -32, speed = 2 } end,
  cannot_sky = function() bullet.fire { kind = "sky", x = 48, y = -60, speed = 2 } end,
  -- it closes all round, and with a way out
  can_ring = function() ring(40, 60, 6) end,
  cannot_ring = function() ring(60, 60, 0) end,
  -- a lane that goes aside slower, and faster, than the ship
  can_lane = function() lane(60, 10, function(i) return 43 - i * 0.5 end) end,
  cannot_lane = function() every(8, 3, function(i) wall { at = i * 10 - 2, gap = 8, speed = 2 } end) end,
  -- lasers, beside each other
  can_beams = function() beams { 10, 20, 30, 66, 76, 86 } end,
  cannot_beams = function() beams { 0, 8, 16, 24, 32, 40, 48, 56, 64, 72, 80, 88, 96 } end,
  -- enemies
  can_rams = function() rams({ 0, 16, 32, 64, 80, 96 }, 2) end,
  cannot_rams = function() rams({ 0, 14, 28, 42, 56, 70, 84, 98 }, 2) end,
  -- nothing to be feared, and all of it at once
  can_rest = function() bullet.fire { kind = "orb", x = 20, y = -8, speed = 1 } end,
  cannot_rest = function() for y = -10, 140, 6 do wall { y = y, speed = 0.25 } end end,
}

-- It goes where the ship is, so what it does cannot be foreseen.
function sets.cannot_but_reacts()
  local p = player.get(1)
  every(60, 3, function()
    for i = -2, 2 do bullet.fire { kind = "moon", x = p.x + i * 20, y = -20, dir = 90, speed = 6 } end
  end)
end

local names = {}
for name, f in pairs(sets) do
  names[#names + 1] = name
  stage.def(name, function()
    f()
    wait(180)
    stage.clear()
  end)
end
table.sort(names)

-- Harder where it should be easier.
stage.def("upside_down", function()
  for i = 1, board.difficulty() == "easy" and 30 or 2 do
    bullet.fire { kind = "orb", x = i * 3, y = -8, speed = 2 }
    wait(2)
  end
  wait(90)
  stage.clear()
end)

-- Rain between two marks.
stage.def("parts", function()
  wait(120)
  stage.mark("rain")
  for i = 1, 120 do
    bullet.fire { kind = "orb", x = 4 + i * 53 % 232, y = -8, speed = 4 }
    wait(2)
  end
  wait(90)
  stage.mark("rest")
  wait(120)
  stage.clear()
end)

table.insert(names, "upside_down")
table.insert(names, "parts")
boot.run { stages = names, players = { "ship" } }

-- players/bombs.lua - the bombs of the three crafts: the heron's undertow, the petrel's bell, the
-- tern's lamp.

local GREEN <const> = 4

-- A wave spreads from the craft, clears bullets and hurts creatures. Only the foam along its edge
-- is visible.
bomb.def("undertow", { over = 90, safe = 150, run = function(p)
  local x, y = p.x, p.y
  screen.shake { size = 3, over = 36 }
  spark.burst { kind = "shock", x = x, y = y, speed = 0 }
  bullet.sweep { x = x, y = y, radius_to = 360, over = 36, hurt = 60, by = p, spark = "glint",
                 items = "foam" }
  for radius = 10, 360, 10 do
    for k = 0, 17 do
      local a = 20 * k + 0.7 * radius
      spark.burst { kind = k % 3 == 0 and "fizz" or "pop", dir = a, speed = 1.5, spread = 0,
                    x = x + radius * angle.cos(a), y = y + radius * angle.sin(a) }
    end
    wait(1)
  end
  item.group():pull(p)
end })

-- Three strokes freeze nearby bullets, each in a wider circle. Afterwards the frozen bullets
-- break.
local STROKES <const>, APART <const> = 3, 22

local function ring(x, y, radius)
  for k = 0, 35 do
    local a = 10 * k
    spark.burst { kind = "pop", dir = a, speed = 0.6, spread = 0, x = x + radius * angle.cos(a),
                  y = y + radius * angle.sin(a) }
  end
end

bomb.def("bell", { over = 120, safe = 170, run = function(p)
  for stroke = 1, STROKES do
    local x, y, radius = p.x, p.y, 60 + 40 * stroke
    sound.play("bell_bomb", { from = p })
    screen.shake { size = 1 + stroke, over = 12 }
    ring(x, y, radius)
    ring(x, y, radius // 2)
    for _, b in ipairs(query.near { what = "bullet", x = x, y = y, radius = radius }) do
      b.frozen = STROKES * APART
    end
    for _, e in ipairs(query.near { what = "enemy", x = x, y = y, radius = radius }) do
      e:hurt(16, p)
    end
    wait(APART)
  end
  sound.play("shatter", { from = p })
  screen.shake { size = 4, over = 20 }
  spark.burst { kind = "shock", from = p, speed = 0 }
  bullet.sweep { x = p.x, y = p.y, radius_to = 200, over = 12, hurt = 24, by = p, spark = "glint",
                 items = "foam" }
  wait(20)
  item.group():pull(p)
end })

-- A broad beam ahead clears every bullet in it, and bullets near the craft, while the lamp burns.
laser.def("lamplight", { strip = "lamp_ray", width = 56, hit = { share = 0.9 },
                         damage = 5, every = 4, bank = GREEN, clearable = false, blend = "glow" })

bomb.def("lamp", { over = 130, safe = 160, run = function(p)
  sound.play("lamp_bomb", { from = p })
  local ray = laser.beam { kind = "lamplight", follow = p, dy = -12, dir = 270, length = 340,
                           warn = 0, grow = 10, hold = 104, fade = 14 }
  screen.shake { size = 2, over = 110 }
  for beat = 0, 119 do
    local half = ray and ray.alive and ray.width / 2 or 0
    if half > 4 then
      bullet.clear { from = p, dy = -12, to_x = p.x, to_y = -24, width = 2 * half, lasers = false,
                     items = beat % 2 == 0 and "foam" or nil, spark = "glint" }
    end
    bullet.clear { from = p, radius = 36, lasers = false, items = "foam", spark = "glint" }
    if beat % 3 == 0 then
      spark.burst { kind = "fizz", from = p, dx = 40 * (beat % 2) - 20, dy = -20, n = 2, dir = 270,
                    spread = 30, speed = 4 }
    end
    wait(1)
  end
  item.group():pull(p)
end })

-- players/bombs.lua - the bombs of the three crafts: the heron's undertow, the petrel's bell, the
-- tern's lamp.

local GREEN <const> = 4

-- A ring of light, and light that fills it.
local function light(x, y, radius, speed)
  spark.burst { kind = "shine", x = x, y = y, n = 8 + radius // 12, radius = radius, dir = radius,
                speed = speed }
end

-- A wave of light spreads from the craft, clears bullets and hurts creatures.
bomb.def("undertow", { over = 90, safe = 150, run = function(p)
  local x, y = p.x, p.y
  screen.shake { size = 5, over = 40 }
  screen.flash { to = 0x58c8ff, over = 44, share = 0.55 }
  bullet.sweep { x = x, y = y, radius_to = 360, over = 36, hurt = 60, by = p, spark = "glint",
                 items = "foam" }
  for radius = 10, 360, 10 do
    light(x, y, radius, 4)
    if radius % 60 == 10 then
      spark.burst { kind = "swell", x = x, y = y, n = 1 + radius // 70, radius = 0.6 * radius,
                    speed = 3 }
      spark.burst { kind = "breaker", x = x, y = y, speed = 0 }
    end
    spark.burst { kind = "fizz", x = x, y = y, n = 6, radius = radius, dir = 7 * radius, speed = 2 }
    wait(1)
  end
  item.group():pull(p)
end })

-- Three strokes freeze nearby bullets, each in a wider circle. Afterwards the frozen bullets
-- break.
local STROKES <const>, APART <const> = 3, 22

bomb.def("bell", { over = 120, safe = 170, run = function(p)
  for stroke = 1, STROKES do
    local x, y, radius = p.x, p.y, 60 + 40 * stroke
    sound.play("bell_bomb", { from = p })
    screen.shake { size = 2 + stroke, over = 14 }
    screen.flash { to = 0x9cdcff, over = 20, share = 0.2 + 0.1 * stroke }
    for part = 1, 4 do light(x, y, radius * part // 4, 1.5) end
    for _, kind in ipairs { "swell", "breaker" } do
      spark.burst { kind = kind, x = x, y = y, speed = 0 }
    end
    spark.burst { kind = "ripple", x = x, y = y, n = 5 * stroke, radius = radius // 2, speed = 2 }
    for _, b in ipairs(query.near { what = "bullet", x = x, y = y, radius = radius }) do
      b.frozen = STROKES * APART
    end
    for _, e in ipairs(query.near { what = "enemy", x = x, y = y, radius = radius }) do
      e:hurt(16, p)
    end
    wait(APART)
  end
  sound.play("shatter", { from = p })
  screen.shake { size = 6, over = 30 }
  screen.flash { to = 0xe0f4ff, over = 36, share = 0.6 }
  for radius = 40, 200, 40 do light(p.x, p.y, radius, 6) end
  spark.burst { kind = "swell", from = p, n = 7, radius = 60, speed = 3 }
  spark.burst { kind = "glint", from = p, n = 60, radius = 40, speed = 6 }
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
  screen.shake { size = 3, over = 110 }
  screen.flash { to = 0xffe8a0, over = 40, share = 0.5 }
  spark.burst { kind = "dawn", from = p, dy = -12, speed = 0 }
  for beat = 0, 119 do
    local half = ray and ray.alive and ray.width / 2 or 0
    if half > 4 then
      bullet.clear { from = p, dy = -12, to_x = p.x, to_y = -24, width = 2 * half, lasers = false,
                     items = beat % 2 == 0 and "foam" or nil, spark = "glint" }
    end
    bullet.clear { from = p, radius = 36, lasers = false, items = "foam", spark = "glint" }
    if beat % 3 == 0 then
      spark.burst { kind = "shine", from = p, dy = -16, n = 2, dir = 270, spread = 70, speed = 7 }
      spark.burst { kind = "fizz", from = p, dx = 40 * (beat % 2) - 20, dy = -20, n = 2, dir = 270,
                    spread = 30, speed = 4 }
    end
    wait(1)
  end
  item.group():pull(p)
end })

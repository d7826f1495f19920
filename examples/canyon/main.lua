-- main.lua - a stage in a field that is wider than the screen. The camera goes with the ship, and the cliffs at both
-- edges of the field come into view where the ship flies near them.
local AMBER, GOLD, RED, BLUE = 2, 3, 1, 5 -- palette banks

-- ---- the camera and the background ----

camera.follow = 0.15 -- it eases towards the ship

bg.def("canyon", function()
  local sea, clouds, cliffs = bg.layer(1), bg.layer(2), bg.layer(3)
  sea.map, sea.vy, sea.follow = "sea", 0.6, 0.35          -- far below: moves less than the field
  clouds.map, clouds.vy, clouds.follow = "clouds", 1.1, 0.7
  cliffs.map, cliffs.vy = "cliffs", 1.6                    -- moves with the field, at whose edges it is
end)

-- ---- kinds ----

spark.def("glint", { sprite = "glint", life = 16, drag = 0.06, bank = GOLD })
spark.def("crumb", { sprite = "crumb", life = 40, drag = 0.04, gravity = 0.04, banks = { 3, 2, 1 } })
spark.def("hoop",  { sprite = "hoop",  life = 12, bank = GOLD })
spark.def("shock", { sprite = "shock", life = 16, bank = AMBER })

bullet.def("orb",  { sprite = "orb",  hit = { circle = 3.5 }, cloud = "mist", vanish = "hoop" })
bullet.def("star", { sprite = "star", hit = { circle = 4 }, cloud = "mist", vanish = "hoop" })
bullet.def("rice", { sprite = "rice", hit = { capsule = { 5, 1.5 } }, turns = true, cloud = "mist", vanish = "hoop" })

local function chip(e)
  sound.play("chip", { from = e })
  spark.burst { kind = "crumb", from = e, n = 1, speed = 2 }
end

local function pop(e)
  spark.burst { kind = "shock", from = e, speed = 0 }
  spark.burst { kind = "crumb", from = e, n = 12, speed = 2.5 }
end

local function sink(e)
  pop(e)
  sound.play("burst", { from = e })
  screen.shake { size = 3, over = 24 }
  for _ = 1, 3 do
    spark.burst { kind = "shock", x = e.x + rng.number(-14, 14), y = e.y + rng.number(-26, 26), speed = 0 }
  end
  bullet.sweep { x = e.x, y = e.y, radius_to = 120, over = 20 }
end

enemy.def("drone", { sprite = "drone", hit = { circle = 11 }, hp = 4, score = 200, spark = "glint", blink = 6,
  on_hit = chip, on_death = pop })
enemy.def("turret", { sprite = "turret", hit = { circle = 12 }, hp = 12, score = 600, touch = false, spark = "glint",
  blink = 6, on_hit = chip, on_death = pop })
enemy.def("airship", { sprite = "airship", hit = { box = { 30, 66 } }, hp = 120, score = 5000, spark = "glint",
  blink = 6, on_hit = chip, on_death = sink })

-- ---- the ship ----

shot.def("dart", { sprite = "dart", hit = { box = { 6, 14 } }, turns = true, bank = BLUE })

player.def("kite", { sprite = "kite", hit = { circle = 2 }, graze = 18, speed = 4, focus = 1.8, lives = 3,
  run = function(p)
    while true do
      if pad.down("fire", p) and board.frame() % 4 == 0 then
        local wide = p.focus and 2 or 14
        for side = -1, 1, 2 do
          shot.fire { kind = "dart", from = p, dx = 5 * side, dy = -14, speed = 10 }
          shot.fire { kind = "dart", from = p, dx = 11 * side, dy = -4, dir = 270 + wide * side, speed = 9 }
        end
      end
      wait(1)
    end
  end })

on.graze(function(p, b) score.add(50, p) spark.burst { kind = "glint", from = b } end)
on.death(function(p)
  screen.shake { size = 5, over = 30 }
  spark.burst { kind = "shock", from = p, speed = 0 }
  spark.burst { kind = "crumb", from = p, n = 40, speed = 4 }
  bullet.clear { spark = "hoop" }
end)

-- ---- the stage: turrets on both cliffs, drones across the whole field, airships at the sides ----

-- A turret moves down with its cliff, 1.6 px a frame. Its barrel follows the ship, and fires where it points.
local function gun(e)
  local barrel = sprite.put { sprite = "barrel", follow = e, layer = "middle", dir = 90 }
  e:move { dx = 0, dy = 400, over = 250 }
  task.own(e, function()
    while true do
      local p = player.nearest(e.x, e.y)
      if p.alive then barrel.dir = angle.to(e, p) end
      wait(1)
    end
  end)
  wait(rng.int(30, 60))
  while e.y < 230 do
    pattern.fan { from = e, kind = "orb", bank = RED, n = 3, spread = 30, dir = barrel.dir, speed = 1.7 }
    wait(64)
  end
  wait(forever)
end

-- Gusts blow the ship and the clouds to one side and then to the other.
local function wind()
  for t = 0, forever do
    local gust = 0.8 * angle.sin(t)
    player.each(function(p) p:push(gust, 0) end)
    bg.layer(2).vx = gust
    wait(1)
  end
end

local function turret(side)
  enemy.spawn { kind = "turret", x = side < 0 and 22 or rom.field.w - 22, y = -20, run = gun }
end

-- A drone flies into the field, fires a ring, and leaves at a side.
local function drone(x, side)
  enemy.spawn { kind = "drone", x = x, y = -20, run = function(e)
    wait_for(e:move { dx = 60 * side, dy = 130, over = 60, ease = "out" })
    pattern.ring { from = e, kind = "rice", bank = 7, n = 8, aim = true, speed = 1.5 }
    e:move { dx = 500 * side, dy = -120, over = 160, ease = "in" }
    wait(forever)
  end }
end

-- An airship comes in at one side, stays, fires a spiral of stars, and leaves.
local function airship(x)
  enemy.spawn { kind = "airship", x = x, y = -50, run = function(e)
    wait_for(e:move { dx = 0, dy = 130, over = 110, ease = "out" })
    for i = 1, 40 do
      pattern.ring { from = e, kind = "star", bank = 6, n = 7, dir = 11 * i, speed = 1.4 }
      if i % 4 == 0 then
        pattern.fan { from = e, dy = 20, kind = "rice", bank = GOLD, n = 3, spread = 16, aim = true, speed = 2.6 }
      end
      wait(16)
    end
    e:move { dx = 0, dy = -240, over = 160, ease = "in" }
    wait(forever)
  end }
end

stage.def("canyon", function()
  bg.show("canyon", { over = 0 })
  local guns = task.go(function()
    while true do
      turret(-1)
      wait(75)
      turret(1)
      wait(75)
    end
  end)
  stage.at(60)
  for i = 1, 8 do
    drone(i % 2 == 0 and 100 + 12 * i or 380 - 12 * i, i % 2 == 0 and 1 or -1)
    wait(30)
  end
  stage.at(420)
  airship(120)
  stage.at(620)
  for i = 0, 5 do
    drone(60 + 20 * i, 1)
    drone(420 - 20 * i, -1)
    wait(40)
  end
  stage.mark("pair")
  stage.at(960)
  task.go(wind)
  airship(110)
  airship(370)
  stage.at(1500)
  task.stop(guns)
  stage.clear(900)
  wait(90)
end)

task.go(function() -- the canyon behind the title, where no stage shows it
  while true do
    if not game.stage and not bg.layer(1).map then bg.show("canyon", { over = 0 }) end
    wait(1)
  end
end)

boot.run { stages = { "canyon" }, players = { "kite" } }

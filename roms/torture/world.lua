-- world.lua - enemies, a boss, two stages, and a task for every corner of the API.
local swoop = path.def { { x = -10, y = 30 }, { x = 60, y = 80, over = 40, ease = "out" }, { wait = 10 },
  { x = 150, y = 60, over = 50, ease = "both" }, { x = 250, y = 20, over = 40, ease = "in" } }
local across = path.def { { x = 20, y = 20 }, { x = 200, y = 40, over = 80, ease = "linear" } }

local function ringer(e)
  wait(10)
  while true do
    pattern.ring { from = e, kind = "dot", n = by_difficulty { soft = 3, hard = 5 }, speed = 1.5, motion = "stop", tag = "ring" }
    wait(45)
  end
end

local function brief(e) wait(40) e:remove() end
enemy.def("drone", { sprite = "letter", hit = { box = { 14, 14 } }, hp = 6, score = 150, bank = 3, spark = "ping", run = ringer, drops = { coin = 2, husk = 1 },
  blink = 5, pictures = { hurt = "box", cast = "arrow" },
  on_hit = function(e, p, n) if p then score.add(n, p) end e.bank = (e.bank + 1) % 16 end,
  on_death = function(e, p) spark.burst { kind = "long", from = e, n = p and 2 or 1, dir = 90, spread = 60 } end })
enemy.def("wall", { sprite = "arrow", hit = { capsule = { 16, 4, 30 } }, hp = 100, blocks = true, touch = false, turns = true,
  pictures = { cast = "box" } })
enemy.def("globe", { sprite = "steps", hit = { circles = { { -1.5, 0, 2.5 }, { 1.5, 0.5, 2.5 } } }, hp = 3, score = 40, swept = false, run = brief, scale_hit = true })
enemy.def("shade", { sprite = "letter", hit = "none", run = brief })
enemy.def("pearl", { sprite = "steps", hit = { circle = 3 }, hp = 2, run = brief, alpha = 5, scale = 1.5 })
enemy.def("limb", { sprite = "steps", hit = { circle = 4 }, hp = 5, score = 3, spark = "ping", blocks = true, blink = 3, rate = 0.75,
  drops = { husk = 1 }, parts = { { kind = "shade", dy = 6, share = 0.3 } } })
enemy.def("crab", { sprite = "letter", hit = { box = { 16, 10 } }, hp = 30, parts = {
  { kind = "limb", dx = -14, dy = 3, share = 0.5, tag = "left" }, { kind = "limb", dx = 14, dy = 3, share = 1 / 3, hp = 3, rate = 1.5 } } })

boss.def("twin", { title = "Twin", kind = "wall", x = 112, y = 60, warning = 20, portrait = "box", music = "short", phases = {
  { talk = function(e) board.note(e.safe) wait(9) end },
  { id = "one", hp = 60, safe = 10, bonus_to = 100, time = 180, bonus = 500, drops = { heart = 1, coin = 3 }, clear = { items = "coin", spark = "ping" }, run = function(e)
      task.go(function() while true do pattern.aimed { from = e, kind = "needle", n = 3, every = 5, speed = 2, lock = true } wait(20) end end)
      pattern.spiral { from = e, kind = "dot", n = forever, arms = 2, step = 13, every = 6, speed = 1.6 }
    end },
  { id = "two", spell = "Sign of Two", survive = true, time = 90, rest = 20, bg = "still", music = "round", run = function(e)
      while true do
        e:move { x = rng.int(40, 180), y = rng.number(40, 90), over = 25, ease = rng.pick { "in", "out", "both", "linear" } }
        pattern.arc { from = e, kind = "dot", n = 7, dir = rng.dir(), sweep = 200, speed = 1.2, motion = "spin" }
        wait(30)
      end
    end },
  { id = "end", hp = 20, time = 60, last = true, run = function(e) e:hurt(30) end },
  { talk = function(e)
    board.note(e.alive)
    board.note((boss.history("twin", "two")))
    board.note(boss.now() or "talks")
  end } } })

local function ringing(e)
  for k = 1, forever do
    pattern.ring { from = e, kind = "dot", n = 5, dir = 11 * k, speed = 1.4 }
    wait(25)
  end
end

boss.def("pair", { title = "Iris and Opal", cast = {
  { name = "iris", title = "Iris", kind = "wall", x = 70, y = 40 }, { name = "opal", title = "Opal", kind = "drone", x = 150, y = 50 } },
  phases = {
    { id = "shared", hp = 20, time = 90, rest = 10, run = function(iris, opal) task.own(opal, ringing) ringing(iris) end },
    { id = "own", spell = "Both", hp = { iris = 4, opal = 6 }, time = 120, rest = 0, bonus = 90, bonus_to = 30,
      run = { iris = function(e) wait(20) e:hurt(9) end, opal = ringing } },
    { id = "any", hp = { iris = 3, opal = 4 }, down = "any", time = 60, run = function(iris, opal) wait(15) opal:hurt(4) end } } })

-- ---- one task per corner of the API; all end with the stage ----

local function bullets()
  local n = 0
  while true do
    n = n + 1
    local b = bullet.fire { kind = "dot", x = 112, y = 20, dir = 7 * n, speed = 1.5, motion = "all", bank = n % 16, tag = "b" .. n % 5 }
    local c = bullet.fire { kind = "ghost", from = b, dx = 3, dy = -2, aim = true, dir = 10, speed = -0.5, motion = "nested" }
    if n % 16 == 4 then
      local d = bullet.fire { kind = "dot", x = 90, y = 40, speed = 1, motion = "led", heat = n % 40 / 8, goal = n % 9, around = b }
      d.around = d.around
      pattern.arc { from = c, kind = "late", n = 2, sweep = 40, speed = 5, motion = "bouncing" }
      bullet.group("late").around = b
      if n % 32 == 4 then shot.fire { kind = "bolt", x = 80, y = 90, speed = 1, motion = "led", around = d, heat = 2 }.around = b end
    end
    if n % 8 == 1 then bullet.fire { kind = "dot", x = 70, y = 70, vx = 1, vy = -0.5, motion = "pulled", heat = n % 9 / 8, goal = n % 7 / 2 } end
    if n % 32 == 5 then shot.fire { kind = "bolt", x = 80, y = 90, vy = -2, motion = "pulled", heat = 2 } end
    if n % 8 == 0 then bullet.fire { kind = "dot", x = 60, y = 60, speed = 1, motion = "named", heat = n % 50 - 20, goal = n % 6 } end
    bullet.fire { kind = "late", x = 190, y = 90, aim = true, dir = n % 9, speed = 1.3, motion = n % 3 == 0 and "drift" or nil }
    pattern.fan { x = 30, y = 30, kind = "dot", n = 4, spread = 50, aim = true, speed = 2,
      each = function(a, i) a.n, a.speed_to = 2, 1 + i / 4 pattern.stack(a) end }
    local d = bullet.fire { kind = "seed", from = b, dy = 9, dir = 11 * n, speed = 1, delay = 1 + n % 40, motion = n % 2 == 0 and "all" or "drift" }
    if n % 6 == 0 then d.vx, d.kind = 0.5, n % 4 == 0 and "late" or "seed" end
    board.note(d.alive and d.delay + d.age + d.vy or 0)
    pattern.line { from = b, kind = "crate", n = 3, width = 40, dir = 90, speed = 1 }
    wait(3)
    if b.alive then
      board.note(b.x + b.y + b.dir + b.speed + b.vx + b.vy + b.age)
      board.note(b.kind .. b.bank .. (b.tag or "none"))
      if n % 7 == 0 then b.x, b.y = b.x + 1, b.y - 1 end
      if n % 5 == 0 then b.dir = 80 end
      if n % 10 == 6 then b.frozen = 4 end
      b.heat = b.heat + b.goal / 4
      if n % 11 == 0 then b.vx, b.vy = 0.5, 0.75 end
    end
    c.heat, b.goal = n, -n
    bullet.group("late").goal = n
    c.speed, c.kind, c.bank, c.tag, c.motion = 1, "dot", 5, "late", b.motion
    c:aim(15)
    c:turn(-5)
    c:shift(0.25, -3)
    if n % 3 == 0 then c:remove() elseif n % 7 == 1 then c:clear { spark = "long" } end
    wait(2)
  end
end

local function groups()
  local all = bullet.group()
  for n = 0, forever do
    local g = bullet.group("b" .. n % 5)
    g.bank, g.speed = n % 16, 1 + n % 3
    if n % 4 == 1 then g:aim(5) end
    if n % 4 == 2 then g:turn(20) end
    if n % 16 == 3 then g:remove() end
    if n % 9 == 0 then g.dir, g.tag = 45, "moved" end
    if n % 9 == 4 then bullet.group("moved").motion = "stop" end
    if n % 9 == 5 then bullet.group("moved").kind = "dot" end
    if n % 13 == 7 then g.vx = 0.25 g.vy = 1 end
    if n % 29 == 11 then bullet.group("late").x = 100 bullet.group("late").y = 50 end
    bullet.each("ring", function(b) if b.age > 60 then b:turn(1) end end)
    if n % 6 == 5 then g:shift(2, -1.5) end
    if n % 7 == 6 then g.frozen = n % 5 == 0 and forever or n % 40 end
    if n % 25 == 24 then all.frozen = 0 end
    bullet.each("b1", function(b) if b.frozen > 9 then b.frozen = 3 end end)
    if n % 17 == 8 then g:clear { x = 112, y = 60, w = 90, h = 40, spark = "ping" } end
    if n % 40 == 39 then bullet.clear { tag = "ring", spark = "ping" } end
    if n % 6 == 1 then
      local nut = bullet.fire { kind = n % 4 == 1 and "nut" or "shield", x = 30 + n * 7 % 170, y = 40, speed = 0.6, delay = n % 9, tag = "hard" }
      board.note(nut.alive and nut.hp or 0)
      if n % 5 == 2 then nut.hp = n % 3 == 0 and forever or n % 3 end
    end
    if n % 8 == 2 then
      local sower = bullet.fire { kind = "dot", x = 50 + n % 90, y = 30, speed = 1, motion = "sower", heat = 40, goal = 4 }
      if sower.alive and n % 16 == 2 then sower.motion = "hooked" end
    end
    if n % 6 == 3 then bullet.group("go"):signal() end
    if n % 31 == 7 then bullet.group("hard").hp = 2 bullet.group("hard").kind = n % 2 == 0 and "nut" or "dot" end
    if n % 12 == 2 then
      bullet.fire { kind = "veil", x = 20 + n * 11 % 180, y = 70, speed = 0.2, dir = n * 40, tag = "veil" }
    end
    if n % 10 == 3 then pattern.fan { x = 112, y = 60, kind = "saw", n = 3, spread = 100, speed = 0.4, tag = "b" .. n % 5 } end
    if n % 50 == 49 then board.note(bullet.clear { all = n % 100 == 49 }) end
    if n % 24 == 13 then
      local p = player.nearest(9, 9)
      local wave = bullet.sweep { follow = p, dy = -30, radius = 4, radius_to = 60, over = 8, tag = "moved", spark = "ping",
        hurt = n % 2, by = 1 }
      bullet.sweep { x = 30, y = 60, radius_to = 40, over = 5 }
      if n % 48 == 13 then wait(2) task.stop(wave) else wait_for(wave) end
    end
    if n % 40 == 19 then bullet.clear { x = 20, y = 20, dx = 5, to_x = 200, to_y = 190, width = 9 } end
    board.note(all.count)
    wait(5)
  end
end

local function lasers()
  for n = 0, forever do
    local p, e = player.nearest(9, 9), query.near { what = "enemy", x = 112, y = 60, radius = 300 }[1]
    local b = laser.beam { kind = n % 3 == 0 and "ray" or "bar", x = 40 + n * 13 % 150, y = 30, dir = 70 + n % 40, length = 90 + n % 120,
      hold = 20 + n % 9, warn = n % 12, grow = n % 5, fade = n % 7, spin = n % 3 - 1, tag = "beam", bank = n % 5 }
    if e then laser.beam { kind = "ray", follow = e, dx = 2, dy = 3, length = 60, hold = 30, aim = true, width = 8 } end
    if n % 5 == 2 and p.alive then
      laser.beam { kind = "lance", follow = p, dy = -9, dir = 270, length = 120, hold = 25, warn = 0, by = p }
    end
    local o = laser.bolt { kind = "ray", x = 112, y = 40, dir = 13 * n, speed = 2, length = 30, motion = "bouncing", delay = n % 4 }
    local c = laser.curve { kind = "ray", x = 112, y = 60, dir = 29 * n, speed = 3, points = 8 + n * 7 % 50, motion = "spin", tag = "worm" }
    pattern.fan { fire = n % 2 == 0 and "bolt" or "curve", kind = "ray", x = 100, y = 50, n = 2, spread = 60, speed = 2,
      [n % 2 == 0 and "length" or "points"] = 12 }
    board.note((b.state or "") .. (b.form or "") .. (b.kind or "") .. (b.tag or "") .. (b.bank or ""))
    if b.alive then
      board.note(b.x + b.y + b.dir + b.length + b.width + b.spin + b.age + b.frozen + b.dx + b.dy + (b.follow and 1 or 0))
      board.note(b.speed + b.vx + b.vy + (b.motion and 1 or 0) + (b.around and 1 or 0) + (b.by and 1 or 0))
      b.x, b.y, b.dir, b.length, b.width = b.x + 1, b.y + 2, b.dir + 3, b.length - 4, b.width + 1
      b.spin, b.bank, b.tag, b.dx, b.dy = 0.5, 3, n % 2 == 0 and "beam" or nil, 1, 1
    end
    if n % 4 == 1 then o.speed, c.speed = 3, 1.5 end
    if n % 4 == 2 then o.vx, o.vy, c.motion, c.around = 1, 2, "spin", e end
    if n % 4 == 3 then o:aim(10) c:turn(20) c:shift(3, -2) c.frozen = 4 end
    if n % 7 == 5 then c:fade() o:clear { spark = "ping", every = 8 } b:remove() end
    local all, worms = laser.group(), laser.group("worm")
    board.note(all.count)
    if n % 6 == 0 then worms.dir, worms.width, worms.spin = 100, 5, 1 worms:turn(4) worms:aim() worms:shift(1, 1) end
    if n % 6 == 1 then worms.x, worms.y, worms.speed, worms.vx, worms.vy = 100, 70, 1, 0.5, 1 end
    if n % 6 == 2 then worms.bank, worms.motion, worms.around, worms.frozen, worms.tag = 4, "spin", p, 3, "old" end
    if n % 6 == 3 then local beams = laser.group("beam") beams.length, beams.dx, beams.dy = 70, 2, 2 end
    if n % 6 == 4 then laser.group("old"):fade() laser.each("beam", function(x) if x.age > 30 then x:fade() end end) end
    if n % 11 == 9 then worms:clear { x = 112, y = 60, radius = 50, every = 20 } laser.group("old"):remove() end
    if n % 13 == 7 then board.note(laser.clear { x = 20, y = 20, to_x = 200, to_y = 190, width = 9, spark = "ping", all = true }) end
    if n % 17 == 3 then board.note(bullet.clear { tag = "beam", lasers = true, items = "husk" }) end
    if n % 17 == 12 then laser.group("worm"):clear { items = "coin", every = 30, radius = 90, from = c } c:clear { items = "husk" } end
    if n % 5 == 4 then c.motion = n % 10 == 4 and "third" or "burst" end
    if n % 8 == 7 then laser.group("go"):signal() end
    for k, found in ipairs(query.near { what = "laser", x = 112, y = 90, radius = 70, tag = n % 2 == 0 and "worm" or nil }) do
      board.note(k .. found.form .. found.x)
    end
    board.note(#query.box { what = "laser", x = 60, y = 60, w = 50, h = 80 })
    board.note(#query.line { what = "laser", x = 9, y = 9, to_x = 200, to_y = 100, width = 6 })
    wait(6)
  end
end

local function shots()
  while true do
    local near = query.near { what = "shot", x = 112, y = 112, radius = 80, tag = "volley" }
    for i, s in ipairs(near) do
      board.note(s.x + s.y + s.dir + s.speed + s.vx + s.vy + s.age + (s.by and s.by.index or 0))
      board.note(s.kind .. s.bank .. (s.tag or ""))
      if i == 1 then s:aim() s.kind = "wiper" end
      if i == 2 then s:turn(3) end
      if i == 3 then s:remove() end
      if i == 4 then s.x, s.y, s.bank = s.x, s.y - 2, 6 end
      if i == 5 then s.dir = s.dir + 1 s.speed = 4 end
      if i == 6 then s.vx = 1 s.vy = -3 end
      if i == 6 then s.around = s.around end
      if i == 7 then s.kind, s.tag, s.motion = "ball", nil, s.motion or "stop" end
    end
    wait(7)
  end
end

local function volleys()
  for n = 0, forever do
    local g = shot.group(n % 2 == 0 and "volley" or "own")
    if n % 9 == 2 then g.around = player.nearest(9, 9) end
    board.note(g.count)
    shot.each("volley", function(s) if s.age > 20 then s.tag = "own" end end)
    if n % 8 == 1 then g:aim(n % 7) g.bank = n % 16 end
    if n % 8 == 0 then g.frozen = n % 9 shot.each("own", function(s) s.frozen = s.frozen // 2 end) end
    if n % 8 == 2 then g:turn(10) g.speed = 5 end
    if n % 4 == 1 then
      shot.fire { kind = "bolt", x = 112, y = 200, speed = 2, motion = "cluster", heat = n, by = player.nearest(9, 9) }
      shot.group(n % 8 == 1 and "go" or nil):signal()
    end
    if n % 8 == 3 then g:shift(1, -2) g.dir = 265 + n % 10 end
    if n % 8 == 4 then g.vx = 0.5 g.vy = -4 end
    if n % 8 == 5 then g.x = 100 g.y = 180 g.kind = "ball" end
    if n % 8 == 6 then g.motion = "stop" g.tag = "done" end
    if n % 16 == 7 then shot.group("done"):clear { spark = "ping", from = player.nearest(9, 9), radius = 150 } end
    if n % 16 == 15 then shot.group("done"):remove() end
    local lone = query.near { what = "shot", x = 112, y = 112, radius = 200 }[1]
    board.note(#query.box { what = "bullet", from = player.nearest(5, 5), dy = -20, w = 60, h = 80, tag = "ring" })
    for _, e in ipairs(query.line { what = "enemy", x = 20, y = 200, to_x = 190, to_y = 30, width = 20 }) do
      board.note(e.x)
    end
    if lone and n % 3 == 0 then lone:shift(0, 1) end
    if lone and n % 5 == 0 then lone:clear { spark = "ping" } end
    wait(11)
  end
end

local function crowd()
  local row = enemy.group("crowd")
  for n = 0, forever do
    board.note(row.count)
    row:shift(n % 3 - 1, 0.5)
    if n % 7 == 1 then row:move { x = 60 + n % 90, y = 50, over = 30, ease = "out" } end
    if n % 7 == 2 then row.bank = n % 4 row.safe = 5 end
    if n % 7 == 4 then row.frozen = 25 end
    if n % 7 == 5 then row.picture, row.flip_x, row.hidden = n % 2 == 0 and "cast" or nil, n % 3 == 0, n % 5 == 0 end
    if n % 7 == 6 then enemy.each("crowd", function(e) e.frozen = e.frozen // 2 end) end
    if n % 7 == 3 then row.hp = 4 row:hurt(1, n % 2 + 1) end
    if n % 11 == 4 then row.x = 90 row.y = 70 end
    if n % 13 == 5 then row:kill(1) end
    if n % 13 == 8 then row.tag = "stray" end
    if n % 13 == 9 then enemy.group("stray"):remove() end
    enemy.each("stray", function(e) e:shift(1, 1) end)
    wait(10)
  end
end

-- Enemies with parts, things that orbit them, wanderers, and hit-stops.
local function bodies()
  for n = 0, forever do
    local e = enemy.spawn { kind = "crab", x = 60 + n * 31 % 100, y = 50, rate = n % 3 / 2 + 0.25 }
    local more = enemy.spawn { kind = "limb", follow = e, dx = 3, dy = -12, share = 0.125 }
    e:wander { w = 60, h = 20, every = 9, over = 7, ease = n % 2 == 0 and "in" or "both" }
    local moon = enemy.spawn { kind = "globe", from = e, tag = "moon" }
    moon:orbit { around = n % 3 == 0 and more or e, radius = 20, radius_to = 30, spin = 5, dir = 30 * n, over = 90 }
    wait(5)
    if n % 4 == 1 then enemy.group("moon"):orbit { x = 100, y = 80, spin = -3 } end
    if n % 4 == 2 then enemy.group("moon"):wander { x = 90, y = 60, w = 90, h = 50, every = 5, over = 5 } end
    if n % 8 == 3 then
      local all = enemy.group("left")
      all.rate, all.share, all.dx, all.dy = 0.5, 0.25, -20, 9
    end
    for _, part in ipairs(e:parts(n % 5 == 4 and "left" or nil)) do
      board.note(part.x + part.dx * 3 + part.dy * 5 + part.share * 7 + part.rate + part.hp + (part.follow == e and 1 or 0))
      part.dx, part.rate = part.dx + 1, part.rate + 0.0625
      if n % 3 == 1 then part:hurt(2, 1) end
      if n % 3 == 2 then part:move { dx = 0, dy = 20, over = 6 } part.share = 0.75 end
    end
    if more.alive then more.dy = more.dy - 1 end
    local move = e:move { dx = 5, dy = 2, over = 9 }
    wait_for(move)
    board.note(move.alive and 1 or 0)
    wait(4)
    if n % 9 == 4 then board.stop(n % 5 + 1) end
    if n % 3 == 0 then e:kill(1) elseif e.alive and n % 3 == 1 then e.y = -60 else e:remove() end
    moon:remove()
    wait(3)
  end
end

bg.def("still", function()
  bg.layer(1).map, bg.layer(4).map = "whole", "tiled"
  bg.plane().map, bg.plane().horizon, bg.plane().fog = "tiled", 90, { to = 0x202840, far = 300 }
end)
bg.def("storm", function()
  local front, floor = bg.layer(2), bg.plane()
  front.map, front.layer, front.blend, front.bank, front.wrap = "tiled", "front", "mist", 3, false
  for n = 0, forever do
    local l = bg.layer(1 + n % 4)
    l.x, l.y, l.vx, l.vy = l.x - 1, l.y + 0.5, n % 3 - 1, n % 5 / 4
    l.hidden, l.map = n % 9 == 3, n % 7 ~= 2 and l.map or "whole"
    if n % 10 == 1 then bg.lines(1 + n % 4, { wave = n % 9 - 4, every = 12 + n % 30, speed = 0.5 }) end
    if n % 10 == 4 then bg.lines(1 + n % 4, { n % 5, -1.5, 3 }) end
    if n % 10 == 8 then bg.lines(1 + n % 4) end
    floor.map, floor.horizon, floor.height, floor.dir = "whole", 60 + n % 50, 8 + n % 30, 3 * n
    floor.ceiling, floor.vx, floor.vy = n % 40 > 20, n % 3 - 1, 1
    if n % 60 == 20 then floor.fog = { to = n % 255, far = 100 } elseif n % 60 == 50 then floor.fog = nil end
    wait(2)
  end
end)

local function told(t)
  board.note(t.x + t.y + t.vx + t.vy + t.bank)
  board.note((t.map or "off") .. t.layer .. (t.blend or "none"))
  board.note(t.hidden)
end

local function look()
  local floor = bg.plane()
  for n = 0, forever do
    local l = bg.layer(1 + n % 4)
    told(l)
    told(floor)
    board.note(l.wrap)
    board.note(floor.horizon + floor.height + floor.dir + (floor.fog and floor.fog.far or 0))
    board.note(floor.ceiling)
    floor.x, floor.y = floor.x % 64, floor.y % 64
    floor.layer, floor.bank, floor.blend = n % 4 == 3 and "front" or "back", n % 16, n % 5 == 2 and "mist" or nil
    floor.hidden = n % 6 == 5
    wait(4)
  end
end

local function scenery()
  task.go(look)
  while true do
    bg.show("storm", { over = 20 })
    wait(200)
    bg.show("still")
    wait(90)
    bg.show(nil, { over = 7 })
    wait(10)
  end
end

local function enemies()
  for n = 0, forever do
    if n % 20 == 19 then -- fills the pool; otherwise the boss still fits
      local more = {}
      for i = 1, 26 do more[i] = enemy.spawn { kind = "wall", x = 8 * i, y = 150 } end
      wait(1)
      for i = 1, 26 do more[i]:remove() end
    end
    wait_until(function() return enemy.count() < 20 end, 30)
    enemy.spawn { kind = n % 6 == 0 and "shade" or n % 6 == 3 and "pearl" or "globe", x = 40 + n * 29 % 150, y = 200 }
    local e = enemy.spawn { kind = n % 3 == 0 and "wall" or "drone", x = 20 + n * 37 % 180, y = 20 + n % 50, tag = "crowd",
      drops = n % 5 == 2 and { husk = 2 } or nil, hp = 3 + n % 6, bank = n % 4, on_death = function() board.note(n) end }
    enemy.spawn { kind = "drone", path = n % 2 == 0 and swoop or across, mirror = n % 3 == 1, dx = n % 7, dy = n % 5 }
    e:move { x = rng.int(10, 200), y = 100, over = 50, ease = "both" }
    task.own(e, function(own, extra)
      wait(15)
      board.note(own.x + own.y + own.hp + own.age + extra)
      board.note(own.kind .. own.bank .. (own.tag or ""))
      board.note((own.picture or "") .. (own.hidden and "h" or own.flip_x and "f" or ""))
      own.flip_x, own.hidden, own.picture = not own.flip_x, n % 3 == 0, n % 4 == 1 and "cast" or nil
      own.safe = n % 2 == 0 and 20 or forever
      board.note(own.safe)
      wait(25)
      own.safe, own.hp, own.bank, own.tag = 0, own.hp + 1, 2, "old"
      if n % 4 == 0 then own:hurt(2) end
      if n % 4 == 1 then own:kill() end
      if n % 4 == 2 then path.run(own, across, true) own:remove() end
      wait(20)
      if own.alive then own.x, own.y = own.x + 5, own.y + 200 end
    end, n)
    enemy.each("crowd", function(x) x:hurt(1) end)
    board.note(enemy.count() * 100 + enemy.count("crowd"))
    wait(9)
  end
end

local function pictures()
  local put, lines = {}, {}
  for n = 0, forever do
    put[n % 26] = sprite.put { sprite = "steps", x = 8 * (n % 26), y = 100 + n % 30, bank = n % 3, screen = n % 5 == 0,
      layer = n % 3 == 0 and "back" or n % 3 == 1 and "middle" or n % 9 == 2 and "over" or nil, flip_x = n % 2 == 0 }
    local s = put[(n + 5) % 26]
    if s and s.alive then
      s.x, s.y, s.bank = s.x + 1, s.y - 1, (s.bank + 1) % 16
      s.flip_x, s.flip_y, s.hidden = not s.flip_x, s.flip_x, s.hidden == (n % 4 == 0)
      s.sprite = s.sprite == "steps" and "box" or "steps"
      s.scale, s.dir = 0.25 + n % 31 / 8, s.dir + 30
      board.note(s.flip_y)
      board.note(s.scale)
      s.layer = s.layer == "over" and "front" or "over"
      if n % 3 == 0 then s:remove() end
    end
    spark.burst { kind = n % 4 == 0 and "long" or "ping", x = 112, y = 112, n = 5, dir = n, spread = 90, speed = 3 }
    text.put { col = n % 40, row = 28, text = n, bank = n % 16, align = n % 3 == 0 and "right" or "center",
      rim = n % 4 == 1 }
    text.put { col = n % 40, row = 27, text = "é" .. utf8.char(0x5f3e, 48 + n % 10), font = n % 2 == 0 and "grid" or nil }
    lines[n % 12] = text.line { x = n % 300, y = 200, text = text.lang("écrit ") .. utf8.char(0x5f3e) .. n, width = 8 + n % 90,
      font = n % 3 == 0 and "grid" or nil, align = n % 4 == 0 and "center" or "right", bank = n % 16,
      letter = n % 5, box = n % 7 == 0, screen = n % 2 == 0, hidden = n % 11 == 0, stay = n % 13 == 0 }
    local l = lines[(n + 5) % 12]
    if l and l.alive then
      l.x, l.y, l.dx, l.dy, l.bank = l.x + 1, l.y - 1, l.dx + 0.5, l.dy - 0.5, (l.bank + 1) % 16
      if n % 6 == 0 then l.text = l.text .. "!" end
      l.hidden = l.done and not l.hidden
      if n % 3 == 0 then l:remove() end
    end
    enemy.each(nil, function(e)
      if n % 30 == 0 then text.line { follow = e, dx = -4, dy = 9.5, text = n, letter = 3 } end
      if n % 7 == 0 then e.scale, e.alpha, e.dir = 0.25 + (n + e.age) % 31 / 8, (e.alpha + 5) % 9, e.dir + 45 end
    end)
    if n % 10 == 0 then text.clear { col = 0, row = 28, w = 20, h = 1 } end
    if n % 20 == 0 then palette.set(n % 256, n * 4321 % 0x1000000) end
    if n % 30 == 7 then
      local e = enemy.spawn { kind = "shade", x = 50, y = 50, dir = n, scale = 1.5, alpha = n % 9 }
      local tied = sprite.put { sprite = n % 60 == 7 and "arrow" or "steps", follow = n % 60 == 7 and e or player.nearest(1, 1),
        dx = n % 9, dy = 3, turns = true, dir = n, scale = 0.75, alpha = n % 9 }
      tied.alpha = ((tied.alpha or 0) + 1) % 9
      if tied.alive then tied.dx, tied.dy = tied.dx + 1, tied.dy - 1 end
      spark.trail { kind = "ping", follow = e, every = 5 }
      spark.burst { kind = "ping", from = e, n = 6, radius = 9, speed = 1 }
      spark.burst { kind = "ping", from = e, n = 4, to_x = 9, to_y = 9 }
      fx.explode { from = e, size = "small" }
      fx.hit(e, player.nearest(1, 1), n % 12)
      if n == 337 then fx.collapse { from = e, size = "burst", crack = "burst", sprite = "arrow", radius = 9 } end
    end
    if n % 45 == 0 then
      local p = sprite.plate { x = n % 200, y = n % 90, w = 8 + n % 300, h = 8, bank = n % 16, front = n % 2 == 0,
        hidden = n % 11 == 0 }
      if p.alive then p.h, p.w, p.hidden = p.h + n % 60, p.w + 1, false end
    end
    if n % 50 == 5 then board.note(screen.dim { share = n % 7 / 7, over = n % 30 }) end
    if n % 40 == 0 then screen.shake { size = n % 65, over = 20, dir = n % 80 == 0 and n or nil } end
    if n % 50 == 0 then screen.flash { to = n * 999, over = 9, share = 0.7 } end
    if n % 70 == 0 then screen.letterbox { h = n % 30, over = 15 } end
    if n % 60 == 0 then palette.fade { to = 0x202040, over = 20, first = 16, last = 40 } end
    if n % 60 == 30 then palette.fade { to = "main", over = 10 } end
    if n % 50 == 25 then palette.cycle { first = 32, last = 47, every = n % 100 == 25 and 3 or 0 } end
    if n % 40 == 39 then palette.load "main" end
    wait(3)
  end
end

local function talks()
  for n = 0, forever do
    wait(70)
    talk.run(function()
      say(n % 2 == 0 and "one" or "two", "écrit " .. ("word "):rep(n % 40), { letter = n % 3, limit = 20 + n % 30 })
      say("two", "b", { face = n % 3 == 0 and "other" or nil, side = n % 5 == 0 and "left" or nil, limit = 30 })
      say(nil, "c\nd", { limit = 9, voice = n % 2 == 0 and "hit" or nil })
      board.note(choose({ "a", "b", "c" }, { title = n % 2 == 0 and "t" or nil, chosen = 1 + n % 3, limit = 40,
        p = n % 4 == 0 and 2 or nil, back = n % 3 == 0 and 1 or nil }))
      wait(5)
    end, { hold = n % 3 == 0 and "all" or n % 3 == 1 and "none" or nil, clear = n % 5 == 4, clock = n % 7 ~= 6,
           skip = n % 4 > 0 })
  end
end

local function numbers()
  for n = 0, forever do
    board.note(rng.int(1, 6) + rng.number(0, 1) + rng.dir() + (rng.chance(0.5) and 1 or 0) + rng.pick { 1, 2, 3 })
    local p = n % 2 == 0 and player.nearest(100, 100) or player.get(n % 4 // 2 + 1)
    board.note(angle.to({ x = 1, y = 2 }, p.alive and p or { x = 5, y = 6 }))
    board.note(angle.of(3, n) + angle.difference(10, n) + angle.sin(n) + angle.cos(n))
    player.each(function(q)
      board.note(q.x + q.y + q.safe)
      board.note((q.picture or "") .. (q.hidden and "h" or q.flip_x and "f" or ""))
      q.flip_x, q.hidden = n % 3 == 0, n % 5 == 0
      if q.kind == "slow" then q.picture = n % 7 < 3 and "pose" or nil end
    end)
    board.note(board.frame() + board.live "bullets")
    for _, chip in ipairs { "bullets", "shots", "enemies", "sprites", "motions", "steps", "tasks" } do
      board.note(board.refused(chip))
    end
    board.note(board.dip "coins")
    if n % 30 == 29 then board.difficulty(board.difficulty() == "soft" and "hard" or "soft") end
    save.set("count", (save.get("count", 0) + 1) % 1000)
    save.set("text" .. n % 4, rom.text "words.txt" .. n)
    if n % 40 == 0 then
      score.enter("table" .. n % 3, { name = "N" .. n % 10, score = n * 7 % 100, stage = n % 14 + 1,
        ship = n % 80 == 0 and "fast" or nil, clear = n % 120 == 0, continues = n % 16 })
      board.note(#score.rows "table0" + #score.rows("table0", "fast"))
      score.count("cancel", n % 7, n % 2 + 1)
    end
    if n % 100 == 50 then board.attract "torture" end
    if n % 100 == 75 then board.ask "settings" end
    board.note(rom.has "steps")
    if n % 4 == 0 then motion.def { { turn = n, over = 4 }, { die = true } } end
    wait(4)
  end
end

-- Owners, scopes, closing, and now and then more tasks than fit.
local function tasks()
  local closed = 0
  for n = 0, forever do
    local scope = task.scope()
    local t = task.own(scope, function()
      local mark <close> = setmetatable({}, { __close = function() closed = closed + 1 end })
      wait(forever)
      return mark
    end)
    local own = task.go(function(k) wait_until(function() return not task.alive(t) end, 20) wait(k) end, n % 3)
    wait(3)
    if n % 2 == 0 then task.stop(scope) else task.stop(t) end
    wait_for(own, t)
    task.stop(scope)
    board.note(closed)
    if n % 12 == 11 then
      local many = {}
      for i = 1, 100 do many[i] = task.go(function() wait(2) wait(forever) end) end
      wait(4)
      for i = 1, #many do task.stop(many[i]) end
    end
    wait(2)
  end
end

local function figures()
  local fires = { pattern.polygon, pattern.star, pattern.ellipse, pattern.rose, pattern.whip, pattern.scatter,
    pattern.points, pattern.picture }
  local own = { { n = 12, sides = 3 }, { n = 10, points = 5, inner = 0.4 }, { n = 9, speed_to = 0.7, tilt = 20 },
    { n = 12, petals = 3, speed_to = 0.5 }, { n = 5, speed_to = 3, bend = 50 }, { n = 7, spread = 80, speed_to = 2.5 },
    { list = { { 0, 0 }, { 5, -3 }, { 5.5, 3 } }, scale = 1.5 }, { dots = "#.#\n ##", gap = 5 } }
  for n = 1, forever do
    local a = own[n % #own + 1]
    a.x, a.y, a.kind, a.fire, a.by = 112, 90, "dot", nil, nil
    a.speed, a.dir, a.aim, a.turns = 1.5, 17 * n, n % 3 == 0, nil
    a.skip = n % 4 == 0 and { 2, n % 9 + 2 } or nil
    if n % 5 == 0 then a.kind, a.fire, a.by = "ball", "shot", player.get(1) end
    fires[n % #own + 1](a)
    wait(11)
  end
end

local function items()
  local all = item.group()
  for n = 1, forever do
    item.drop { kind = n % 40 == 3 and "heart" or n % 5 == 1 and "husk" or "coin", x = 40 + n * 13 % 150, y = 40, n = n % 4,
      dir = 270 + n, spread = n % 9 * 45, speed = n % 3, tag = n % 2 == 0 and "new" or nil }
    item.drop { kind = "coin", from = player.nearest(112, 112), dx = n % 60 - 30, dy = -25 }
    for k, i in ipairs(query.near { what = "item", x = 112, y = 112, radius = 150, tag = n % 3 == 0 and "new" or nil }) do
      board.note(i.x + i.y + i.vx + i.vy + i.age + (i.frozen == forever and 0 or i.frozen))
      board.note(i.kind .. (i.tag or ""))
      if k == 1 then i.vx, i.vy = n % 3 - 1, -1 end
      if k == 2 then i.x, i.y = i.x + 1, i.y - 3 end
      if k == 3 then i.tag, i.frozen = "old", n % 4 == 0 and forever or n % 30 end
      if k == 4 then i:pull(n % 2 + 1) end
      if k == 5 then i:remove() end
    end
    if n % 12 == 5 then all.frozen = 0 end
    if n % 9 == 4 then item.group("new"):pull() end
    if n % 11 == 7 then item.group("old").vx = 0.5 item.group("old").vy = 1 item.group("old").tag = "new" end
    if n % 17 == 9 then item.group("old").x = 90 item.group("new").y = 70 end
    if n % 13 == 6 then item.each("new", function(i) if i.age > 90 then i.tag = "old" end end) end
    if n % 23 == 22 then item.group("old"):remove() end
    if n % 19 == 8 then
      item.drop { kind = "husk", x = 20, y = 20, n = 50, spread = 360, speed = 2 }
      bullet.clear { x = 112, y = 90, radius = 60, items = "coin" }
      bullet.group("late"):clear { items = "husk", spark = "long" }
      bullet.sweep { x = 112, y = 60, radius_to = 50, over = 4, items = "coin" }
      bullet.fire { kind = "dot", x = 60, y = 60, speed = 0 }:clear { items = "husk" }
    end
    board.note(all.count)
    wait(6)
  end
end

local function noises()
  for n = 0, forever do
    local at = n % 7 == 3 and (n % 2 == 0 and "bar" or "beat") or nil
    music.play(n % 3 == 2 and "short" or "round",
      { fade = n % 4 == 1 and not at and 7 or 0, again = n % 5 == 0, back = n % 8 > 5, at = at })
    board.note(music.volume(n % 5 / 4, n % 3 * 9))
    sound.play("knock", { pan = n % 3 - 1, pitch = n % 9 - 4, volume = 0.75 })
    local p = player.get(1)
    if p.alive then sound.play("hit", { from = p }) end
    board.note(music.wait(1 + n % 3) + music.bar())
    if n % 4 == 3 then sound.stop("knock") end
    if n % 6 == 5 then music.stop { fade = n % 12 } end
    if music.name() == "round" then board.note(music.wait("turn") + #(music.marker() or "")) end
    board.note(music.beat() + music.frames(0.5))
    if n % 7 == 6 then sound.stop() end
    wait(3)
  end
end

local function cameras()
  for n = 0, forever do
    camera.follow = n % 5 == 0 and 0 or n % 5 / 4
    if n % 5 == 0 then camera.x, camera.y = n * 7 % 40, n * 3 % 20 - 2 end
    camera.limits = n % 7 == 6 and { x = 3, y = 2.5, w = 210.25, h = 216 } or nil
    bg.layer(1 + n % 4).follow = n % 9 / 4
    board.note(camera.x + camera.y * camera.w + camera.h + camera.limits.w + bg.layer(2).follow)
    wait(4)
  end
end

local corners = { items, bullets, groups, lasers, shots, volleys, enemies, crowd, bodies, pictures, numbers, tasks, figures,
  scenery, noises, cameras }

talk.def("one", { name = "One", voice = "knock", faces = { calm = "letter" } })
talk.def("two", { name = "Two", side = "right", bank = 1, faces = { calm = "box", other = "steps" } })

stage.def("first", function()
  for _, f in ipairs(corners) do task.go(f) end
  local talking = task.go(talks)
  stage.at(60)
  stage.wave { kind = "drone", n = 5, every = 12, path = swoop, mirror = true, dx = 4, dy = 6,
    run = function(e) wait(20) if e.alive then pattern.aimed { from = e, kind = "needle", n = 2, every = 4, speed = 2 } end end }
  stage.at(212)
  board.note(stage.skipping())
  task.stop(talking) -- the boss has its own dialogue, and only one can run
  stage.mark "boss"
  boss.fight "twin"
  stage.clear(120)
end)

stage.def("second", function()
  for _, f in ipairs(corners) do task.go(f) end
  task.go(talks)
  task.go(function() boss.fight("pair", { clock = true }) end)
  stage.wave { kind = "wall", n = 30, every = 3, path = across }
  stage.at(120)
  stage.clear(200)
end, { music = "short" })

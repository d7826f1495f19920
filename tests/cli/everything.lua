-- everything.lua - a script that uses all of the board, for comparing builds. What it computes goes into the hash.
game.def { registers = { rank = { start = 7, min = -3, max = 99, drain = -1, every = 9, hold = 5 } } }
option.def("bead", { sprite = "dot", run = function(o)
  while true do
    shot.fire { kind = "bolt", from = o, speed = 5.5, dir = 265 + o.index }
    o.bank = o.age % 16
    wait(7)
  end
end })
bomb.def("shock", { over = 40, run = function(p)
  bullet.sweep { follow = p, radius_to = 40.5, over = 30, hurt = 2, by = p, spark = "pop" }
  while true do
    wait(5)
    board.note(p.x + p.y)
  end
end })
on.bomb(function(p, late) game.rank = game.rank - (late and 20 or 10) end)
on.start(function() board.note(game.rank .. game.frames .. game.continues) end)
player.def("ship", { sprite = "dot", hit = { circle = 1.5 }, graze = 12, speed = 2.3, focus = 1.1, lives = 9, safe = 20,
  registers = { power = { start = 3, max = 40, show = "bar", drain = 1, every = 13, hold = 9 }, bombs = 9 },
  bomb = "shock", deathbomb = 5, options = { kind = "bead", by = "power", over = 7, levels = {
    { at = 2, wide = { { 0, 6.5 } } },
    { at = 5, wide = { { -7, 3 }, { 7, 3 } }, close = { { -3.3, 1 }, { 3.3, 1 } } } } },
  collect_line = 12, collect_full = "power",
  magnet = 9, pull = 1.7,
  run = function(p)
    while true do
      wait(4)
      if p.state == "hit" then board.note(p:bomb()) end
      p.power = p.power + 1
      if p.power % 8 == 0 then shot.fire { kind = "brush", from = p, speed = 5, by = p } end
      shot.fire { kind = "bolt", from = p, speed = 6.5, dir = 270 + 13 * rng.number(-1, 1), by = p }
    end
  end })
shot.def("bolt", { sprite = "dart", hit = { box = { 3, 5 } }, damage = 2, turns = true })
shot.def("brush", { sprite = "dot", hit = { circle = 3 }, cancels = true, pierce = 2, every = 9 })
spark.def("pop", { sprite = "dot", life = 20, gravity = 0.07, drag = 0.03 })
spark.def("fade", { sprite = "dot", life = 21, banks = { 3, 1, 4 } })
item.def("bit", { sprite = "dot", radius = 2.5, gives = { score = { 3, 777 }, power = -1 } })
item.def("chip", { sprite = "dart", radius = 1.5, gives = { power = 2, lives = 1 }, full = "power", gravity = 0.013 })
bullet.def("orb", { sprite = "dot", bank = 9, hit = { circle = 2.25 } })
bullet.def("rice", { sprite = "dart", bank = 9, hit = { box = { 4, 2 } }, turns = true, order = 2, vanish = "pop" })
bullet.def("spore", { sprite = "dart", hit = { circle = 2 }, cloud = "dot", spin = 9.1, clearable = false })
bullet.def("pin", { sprite = "dart", hit = { capsule = { 5, 1.25 } }, turns = true })
bullet.def("axe", { sprite = "dart", hit = { circles = { { -2, 0.5, 1 }, { 3, 0, 1.5 } } }, turns = true })
bullet.def("ghost", { sprite = "dot", hit = "none", graze = false })
laser.def("ray", { strip = "dart", width = 5, hit = { share = 0.7 }, vanish = "pop", head = "dot" })
laser.def("lance", { strip = "dot", width = 3, hit = { share = 1 }, damage = 1 })
motion.def { name = "bloom", { wait = 5 }, { speed = 0.1, over = 7 }, { bank = 5, aim = true }, { wait = 3 },
  { loop = 3, { turn = 11.7, over = 4 }, { accel = 0.13, over = 3 } }, { kind = "rice", home = 3.3, over = 20 },
  { speed = 4.75, over = 9 } }
motion.def { name = "spin",
  { loop = forever, { turn = 7.1, over = 6 }, { speed = 1.1, over = 4 }, { turn = -3 }, { wait = 2 } } }
motion.def { name = "burst", { wait_for = { tag = "petal", limit = 25 } },
  { emit = { pattern = "fan", n = 3, spread = 50.5, kind = "rice", speed = 1.3, motion = "spin" } },
  { path = path.def { { x = 0, y = 0 }, { x = 9.3, y = 7.1, over = 9, ease = "both" } } }, { die = true } }
enemy.def("wisp", { sprite = "dot", hit = { box = { 8, 7 } }, hp = 5, score = 170, spark = "pop",
  drops = { bit = 3, chip = 1 },
  blink = 6, pictures = { hurt = "dart", cast = "dart" },
  run = function(e)
    while true do
      wait(rng.int(3, 9))
      pattern.fan { from = e, kind = "rice", n = by_difficulty { easy = 3, hard = 7 }, spread = 71.5, aim = true,
        speed = 1.7 }
    end
  end })
enemy.def("pod", { sprite = "dot", hit = { circle = 4 }, hp = 9,
  parts = { { kind = "wisp", dx = 7, share = 0.5, tag = "arm" } } })
enemy.def("king", { sprite = "dot", hit = { circles = { { -1, 0, 3 }, { 1, 0.5, 3 } } }, score = 9000,
  spark = "pop", blocks = true })
talk.def("she", { name = "She", faces = { calm = "dart" }, side = "right" })
local loop = path.def { { x = -5, y = 10 }, { x = 30, y = 25, over = 33, ease = "out" }, { wait = 7 },
  { x = 75, y = 5, over = 41, ease = "both" } }
boss.def("king", { title = "King", kind = "king", x = 32, y = 14, phases = {
  { id = "a", hp = 60, time = 200, rest = 10, run = function(e)
      pattern.spiral { from = e, kind = "orb", n = forever, arms = 3, step = 11.3, every = 5, speed = 1.1 }
    end },
  { id = "b", spell = "Second", hp = 90, time = 150, rest = 10, bonus = 3000, run = function(e)
      while true do
        pattern.ring { from = e, kind = "orb", n = 7, dir = rng.dir(), speed = 0.9, motion = "bloom", tag = "petal" }
        pattern.fan { from = e, kind = "spore", n = 3, spread = 50, speed = 1.3, motion = "spin",
          delay = rng.int(1, 30) }
        e:move { x = rng.int(10, 50), y = rng.int(5, 30), over = 17, ease = "in" }
        wait(18)
      end
    end } } })

local counts = { graze = 0, hit = 0, death = 0, kill = 0, leave = 0, take = 0 }
for name in pairs(counts) do on[name](function() counts[name] = counts[name] + 1 end) end

local function fold(s)
  local h = 0
  for i = 1, #s do h = (h * 33 + s:byte(i)) & 0x7fffffff end
  board.note(h)
end

-- The library: sorting, patterns, text, numbers, trigonometry.
local function library(i)
  local t = {}
  for k = 1, 60 do t[k] = { k * 37 % 11 + 0.5 / k, k } end
  table.sort(t, function(a, b) return a[1] // 1 < b[1] // 1 end)
  local out = {}
  for k, v in ipairs(t) do out[k] = ("%d:%.6f:%g"):format(v[2], math.sin(v[1] * i), math.sqrt(v[1]) / 3) end
  local text = table.concat(out, ","):gsub("(%d+):(%-?)", "%2<%1>"):upper()
  fold(text .. tostring(i / 7) .. tostring(-0.0) .. (7.5 // -2) .. (7.5 % -2) .. math.atan(i, 3) ..
    utf8.char(228, 8364))
  fold(("%q %5.2f %x %s"):format("a\0b", i * 0.1, i * 7919, { } ~= nil) .. (pcall(error, "x") and 1 or 0))
  for k, v in pairs { z = 1, a = 2, [3] = 3, [-1] = 4 } do fold(k .. "=" .. v) end
end

score.rule { on = "kill", gain = { power = 1 }, points = 1.7, times = "power" }
score.rule { on = "graze", points = function(p, b) return b.speed * 10 end }
score.rule { name = "cancel", points = 3, set = { power = 3 }, most = { power = "grazes" } }
score.tally { { label = "GRAZE", value = "grazes", points = 7, stage = true } }
unlock.def("all", { when = { clear = true, score = 5 }, title = "All" })
stage.def("one", function()
  stage.at(5)
  stage.wave { kind = "wisp", n = 4, every = 9, path = loop, dy = 3.3 }
  stage.at(60)
  stage.mark("king")
  boss.fight("king")
  stage.wave { kind = "wisp", n = 3, every = 6, path = loop, mirror = true }
  stage.wave { kind = "wisp", n = 5, every = 0, path = loop, formation = "circle", gap = 7.5 }
  stage.clear(200)
end)

task.go(function()
  local petals, seen = bullet.group("petal"), save.get("seen", 0)
  wait(2) -- boot.run wipes what was there before it
  local mark = sprite.put { sprite = "dart", x = 5, y = 5, layer = "front" }
  palette.cycle { first = 17, last = 30, every = 3 }
  for i = 1, forever do
    library(i)
    bullet.fire { kind = "ghost", x = rng.number(0, 64), y = 0, speed = rng.number(0.2, 3), dir = rng.dir(),
      motion = "spin" }
    if i % 7 == 0 then
      bullet.fire { kind = i % 2 == 0 and "pin" or "axe", x = rng.number(0, 64), y = 0, speed = 2.5, aim = true }
    end
    if i % 50 == 0 then
      petals.speed, petals.bank = 0.5, 6
      bullet.each("petal", function(b) b.dir, b.tag = rng.dir(), "melt" end)
      palette.fade { to = 0x203040, over = 20, first = 0, last = 99 }
      bullet.clear { x = 32, y = 40, radius = 12, spark = "pop" }
      petals:shift(1.5, -2)
      petals:signal()
      bullet.fire { kind = "axe", x = 30, y = 5, speed = 1.5, aim = true, motion = "burst" }
      petals:clear { x = 10, y = 70, dx = 3, to_x = 60, to_y = 90, width = 7 }
      petals:clear { from = mark, radius = 9, items = "bit" }
      item.drop { kind = "chip", x = 30, y = 20, n = 5, spread = 133.7, speed = 1.9 }
      item.each(nil, function(it) if it.age > 40 then it:pull() end end)
      fold(item.group().count .. " " .. counts.take)
      shot.group():turn(3)
      bullet.sweep { x = 20, y = 70, radius_to = 30, over = 20, spark = "pop", hurt = 1 }
      enemy.group():shift(0, 1)
      enemy.each(nil, function(e)
        e.flip_x, e.hidden = not e.flip_x, i % 100 == 0
        if e.kind == "wisp" then e.picture = i % 3 == 0 and "cast" or nil end
      end)
      fold(shot.group().count .. " " .. enemy.group().count)
      seen = seen + 1
      fold(board.refused("bullets") .. " " .. tostring(pad.take("bomb", 50)))
      save.set("seen", seen)
      score.enter("all", { name = "AB" .. seen, score = i * 31, ship = "ship", stage = 2, continues = seen % 3 })
      score.count("cancel", seen, 1)
      fold(#score.rows("all", "ship") .. tostring(unlock.has("all")))
    end
    local p = player.nearest(3, 4)
    if p.alive then
      local near = query.near { what = "bullet", x = p.x, y = p.y, radius = 20 }
      near[#near + 1] = query.box { what = "enemy", from = p, w = 60, h = 80 }[1]
      near[#near + 1] = query.line { what = "bullet", from = p, to_x = 5, to_y = 8, width = 9 }[1]
      fold(#near .. " " .. angle.to(p, { x = 1, y = 2 }) .. " " .. p.x .. " " .. p.grazes .. " " .. p.score)
      mark.x, mark.y, mark.flip_x = p.x, p.y - 9.5, i % 2 == 0
    end
    if i % 40 == 20 then
      laser.beam { kind = "ray", follow = mark, dir = i, length = 60, hold = 12, warn = 9, spin = 1.7, tag = "rays" }
      laser.beam { kind = "lance", follow = p, dir = 270, length = 50, hold = 9, warn = 0 }
      laser.bolt { kind = "ray", x = 32, y = 9, aim = true, speed = 2.3, length = 14, motion = "spin" }
      pattern.fan { fire = "curve", kind = "ray", x = 32, y = 20, n = 2, spread = 50, speed = 1.7, points = 20,
        motion = "bloom" }
      laser.group("rays").width = 6.5
      laser.clear { x = 32, y = 60, radius = 9, spark = "pop", items = "bit", every = 5 }
      for _, l in ipairs(query.near { what = "laser", x = 32, y = 30, radius = 25.5 }) do
        fold("near " .. l.x .. l.y)
      end
      laser.each(nil, function(l) fold(l.state .. " " .. l.x .. " " .. l.length) if l.age > 70 then l:fade() end end)
      pattern.ellipse { x = 32, y = 20, kind = "orb", speed = 1.3, speed_to = 0.6, n = 12, tilt = 20, dir = i }
      pattern.scatter { x = 32, y = 20, kind = "orb", speed = 1.3, speed_to = 0.6, n = 12, spread = 77 }
      pattern.polygon { x = 32, y = 20, kind = "orb", speed = 1.1, n = 9, sides = 3, skip = { 2, 3 }, aim = true }
      pattern.star { x = 32, y = 20, kind = "rice", speed = 1.7, n = 20, points = 5, inner = 0.382 }
      pattern.rose { x = 32, y = 20, kind = "orb", speed = 1.9, speed_to = 0.3, n = 21, petals = 4 }
      pattern.whip { x = 32, y = 60, kind = "bolt", fire = "shot", speed = 3, speed_to = 5, n = 4, bend = 33,
        aim = true }
      pattern.points { x = 32, y = 20, kind = "orb", speed = 1, list = { { 1, 2 }, { -3.3, 4 } }, turns = true,
        dir = i }
      pattern.picture { x = 32, y = 20, kind = "orb", speed = 1, dots = ".#\n###", gap = 3.5 }
    end
    if i % 90 == 45 then
      local e = enemy.spawn { kind = "wisp", x = 20, y = 10 }
      sprite.put { sprite = "dart", follow = e, dx = 2.5, dy = 1 }
      spark.trail { kind = "fade", follow = e, every = 3, over = 60 }
      spark.burst { kind = "fade", x = 30, y = 30, n = 7, radius = 5.5, dir = i, speed = 2 }
      spark.burst { kind = "fade", x = 30, y = 30, to_x = 9, to_y = 50.5, n = 5 }
      screen.shake { size = 3, over = 30, dir = i }
      screen.flash { over = 12, share = 0.5 }
      screen.letterbox { h = i % 4, over = 9 }
    end
    if i % 200 == 150 then
      local before = screen.dim { share = 0.3, over = 9 }
      local p = sprite.plate { x = 4, y = 40.5, w = 50, h = 20, bank = 2 }
      p.w, mark.layer = p.w + i % 9, "over"
      task.go(function()
        talk.run(function()
          say("she", "Now and then, and now.", { limit = 20 })
          fold("chosen " .. choose({ "one", "two" }, { limit = 25 }))
        end, { clock = true, clear = false })
        p:remove()
        screen.dim { share = before }
      end)
    end
    if i % 70 == 20 then
      local e = enemy.spawn { kind = "pod", x = 30, y = 20, rate = 0.75 }
      local more = enemy.spawn { kind = "wisp", follow = e, dx = 5, dy = 9.5, share = 1 / 3 }
      e:wander { w = 30, h = 9, every = 12, over = 9, ease = "in" }
      enemy.spawn { kind = "wisp", from = e }:orbit { around = e, radius_to = 9, spin = 7.5, dir = i, over = 40 }
      more:move { dx = -5, dy = 3, over = 30 }
      for _, part in ipairs(e:parts("arm")) do part.dx, part.rate = part.dx + more.share, 0.5 end
      fold(#e:parts() .. more.follow.kind)
      if i == 90 then board.stop(3) end
    end
    spark.burst { kind = "pop", x = 20, y = 30, n = 3, speed = 1.5 }
    text.put { col = 0, row = 7, text = text.lang("%d %d %d"):format(counts.graze, counts.hit, counts.kill) }
    if i == 9 then
      local l = text.line { x = 4, y = 9, text = text.lang("en garde"), letter = 3, width = 40, box = true }
      wait_until(function() return l.done end)
      l.text, l.x, l.dx, l.bank, l.hidden = l.text:upper(), l.x + 1, l.dx - 1, 3, not l.alive
      text.line { follow = l.alive and player.get(1), dx = -9, dy = 8, text = l.y + l.dy }
      l:remove()
    end
    wait(1)
  end
end)
task.go(function()
  music.play("tide", { fade = 20 })
  board.note(music.volume(0.5, 10))
  while music.wait("drop") < 40 do
    sound.play("hit", { volume = 0.5, pan = -0.5, pitch = 3 })
    board.note(music.bar() + music.beat() + music.frames(2) + #(music.marker() or "") + #(music.name() or ""))
    if music.wait(3) % 2 == 0 then sound.stop("hit") end
  end
  sound.stop()
  music.stop { fade = 60 }
end)
boot.run { stages = { "one" }, players = { "ship" } }

-- main.lua - from the title through two stages and a boss to the score table, with two ships, and on the way as much of the
-- board and of @std as there is. What a core version adds belongs here before it is frozen; see tests/demos/README.md.
option.def("bead", { sprite = "dot", bank = 3, run = function(o)
  while true do
    if pad.down("fire", o.by) then shot.fire { kind = "needle", from = o, dir = o.focus and 270 or 262 + 5 * o.index, speed = 5, by = o.by } end
    wait(9)
  end
end })
bomb.def("burst", { over = 50, safe = 60, run = function(p)
  bullet.sweep { follow = p, radius_to = 90, over = 30, items = "gem", hurt = 3, by = p }
  laser.beam { kind = "torch", follow = p, dir = 270, length = 150, hold = 30, warn = 0 }
  screen.shake { size = 4, over = 20 }
  wait(12)
  board.stop(3)
end })
game.def { registers = { rank = { start = 2, max = 9, drain = -1, every = 90, show = "number" } } }
local styles = {
  quick = { kind = "bead", by = "power", levels = { { at = 1, wide = { { -9, 4 }, { 9, 4 } }, close = { { -4, -6 }, { 4, -6 } } }, { at = 3, wide = { { -12, 4 }, { 0, 12 }, { 12, 4 } } } } },
  slow = { kind = "bead", by = "power", style = "orbit", radius = 14, close = 8, spin = 5, levels = { { at = 2, n = 1 }, { at = 4, n = 4 } } } }
local function ship(name, speed, bolt)
  player.def(name, { sprite = "dart", hit = { circle = 1.5 }, graze = 12, speed = speed, focus = speed / 2, lives = 3, safe = 60,
    registers = { power = { start = 1, max = 9, show = "bar" }, bombs = { start = 2, show = "icons" },
      chain = { drain = forever, hold = 40 }, best = 0, heat = { max = 60, drain = 1, every = 2, hold = 5 } },
    options = styles[name], bomb = "burst", deathbomb = 9, collect_line = 40, collect_full = "power",
    run = function(p)
      while true do
        if pad.down("fire", p) then
          for i = -1, 1 do shot.fire { kind = bolt, from = p, dx = 4 * i, speed = 6.5, dir = 270 + (p.focus and 2 or 13) * i, by = p } end
        end
        if pad.repeated("special", p) then shot.fire { kind = bolt, from = p, aim = true, speed = 3, motion = "spin" } end
        wait(4)
      end
    end })
end
shot.def("bolt", { sprite = "dart", hit = { box = { 3, 5 } }, damage = 2, turns = true })
shot.def("needle", { sprite = "dart", hit = { box = { 3, 3 } }, damage = 1, turns = true, pierce = 2, every = 5 })
shot.def("ball", { sprite = "dot", hit = { circle = 3 }, damage = 3 })
item.def("gem", { sprite = "dot", radius = 6, bank = 2, gives = { score = { 10, 90 }, power = 1 }, full = "power" })
item.def("heart", { sprite = "dot", radius = 6, bank = 6, gives = { lives = 1 }, gravity = 0.01 })
laser.def("torch", { strip = "dart", width = 6, hit = { share = 1 }, damage = 1, every = 6 })
laser.def("ray", { strip = "dart", width = 4, hit = { share = 0.5 }, graze = 7 })
ship("quick", 3.3, "bolt")
ship("slow", 2.1, "ball")
spark.def("pop", { sprite = "dot", life = 20, gravity = 0.07, drag = 0.03 })
bullet.def("orb", { sprite = "dot", hit = { circle = 2.25 } })
bullet.def("rice", { sprite = "dart", hit = { box = { 4, 2 } }, turns = true })
bullet.def("ghost", { sprite = "dot", hit = "none", graze = false })
motion.def { name = "bloom", { wait = 5 }, { speed = 0.1, over = 7 }, { bank = 5, aim = true }, { wait = 3 },
  { loop = 3, { turn = 11.7, over = 4 }, { accel = 0.13, over = 3 } }, { kind = "rice", home = 3.3, over = 20 }, { speed = 2.75, over = 9 } }
value.def("turning", { start = 1.5 })
value.def("rage", { of = "enemy" })
bullet.def("pin", { sprite = "dart", hit = { capsule = { 5, 1.5 } }, turns = true, cloud = "dot", order = 3 })
bullet.def("nut", { sprite = "dot", hit = { circles = { { -2, 0, 2 }, { 2, 0, 2 } } }, hp = 3, score = 40, vanish = "pop" })
shot.def("brush", { sprite = "dot", hit = { circle = 4 }, cancels = true })
motion.def { name = "lead", { go_to = { 76, 60 }, over = 40, ease = "both" }, { turn = "turning", over = 30 }, { wave = 6, every = 20, over = 40 } }
motion.def { name = "walls", { bounce = 3, walls = "left right", over = 200, { bank = 5 } } }
motion.def { name = "moon", { orbit = 20, spin = 4, over = 90 }, { polar = 1, spin = 2, over = forever } }
motion.def { name = "spin", { loop = forever, { turn = 7.1, over = 6 }, { speed = 1.1, over = 4 }, { turn = -3 }, { wait = 2 } } }
bullet.meet("star", "melt", { clear = "second", spark = "pop" })
motion.def { name = "seed", { wait = 20 }, { emit = { pattern = "fan", kind = "orb", n = 3, spread = 90, speed = 1 } }, { wait_for = { near = 40, limit = 60 } }, { turn = 3, over = 30 } }
motion.def { name = "arc", fine = true, { speed = 0.7 }, { turn = 0.9, over = 200 } }

local function volley(e)
  while true do
    wait(rng.int(20, 40))
    pattern.fan { from = e, kind = "rice", n = by_difficulty { easy = 2, hard = 3 }, spread = 71.5, aim = true, speed = 1.3 }
    pattern.stack { from = e, kind = "orb", n = 3, dir = 90, speed = 0.9, speed_to = 1.4 }
    pattern.star { from = e, kind = "pin", n = 10, points = 5, speed = 1.5, delay = 20, turning = rng.number(-3, 3), motion = "lead", tag = "star" }
    pattern.ring { from = e, fire = "curve", kind = "ray", n = 2, dir = 90, speed = 1.2, points = 40, motion = "lead" }
    laser.bolt { kind = "ray", from = e, aim = true, speed = 2, length = 14 }
    bullet.fire { from = e, kind = "orb", dir = 80, speed = 1, motion = "seed" }
    pattern.scatter { from = e, kind = "nut", n = 3, spread = 60, speed = 0.8, speed_to = 1.2, motion = "walls" }
    pattern.ring { from = e, kind = "orb", n = 4, speed = 0, around = e, motion = "moon", skip = { 2, 2 } }
    shot.fire { kind = "brush", x = 76, y = 140, speed = 3 }
    bullet.group("star").frozen = 8
    e.rage = e.rage + 1
    if e.rage % 3 == 2 then bullet.sweep { from = e, radius_to = 30, over = 6, tag = "star", spark = "pop" } end
    board.note(#query.box { what = "bullet", x = 76, y = 70, w = 60, h = 60 } + enemy.group().count)
  end
end
enemy.def("wisp", { drops = { gem = 2 }, blink = 4, sprite = "dot", hit = { box = { 8, 7 } }, hp = 5, score = 170, spark = "pop", run = volley })
enemy.def("eye", { sprite = "dot", hit = { circle = 4 }, hp = 14, score = 400, spark = "pop", on_hit = function(e) spark.burst { kind = "pop", from = e, n = 1, speed = 2 } end,
  on_death = function(e) pattern.ring { from = e, kind = "orb", n = 5, aim = true, speed = 1.1 } end, run = volley })
enemy.def("king", { sprite = "dot", hit = { box = { 8, 8 } }, hp = 10, score = 9000, spark = "pop" })

enemy.def("pod", { sprite = "dot", hit = { circle = 3 }, hp = 6, score = 60, run = function(e)
  e:orbit { around = e.follow, radius = 12, spin = 3, over = 90 }
  wait(100)
  e:wander { w = 60, h = 30, every = 30, over = 20 }
  pattern.ring { from = e, kind = "orb", n = 3, speed = 1 }
end })
enemy.def("raft", { sprite = "dart", hit = { box = { 8, 4 } }, hp = 40, rate = 0.75, score = 700, spark = "pop", parts = {
  { kind = "pod", dx = -10, share = 0.5 }, { kind = "pod", dx = 10, dy = 2, share = 1 } }, run = volley })

score.rule { on = "kill", gain = { chain = 1 }, most = { best = "chain" }, points = 10, times = "chain" }
score.rule { on = "graze", points = 5, gain = { heat = 6 } }
score.rule { on = "death", set = { chain = 0 } }
score.tally { { label = "BEST CHAIN", value = "best", points = 30 }, { label = "CLEAR", value = function() return 1 end, points = 500, last = true } }
unlock.def("calm", { when = { clear = true }, title = "Calm", hint = "Clear it" })
talk.def("ana", { name = "Ana", faces = { calm = "dart" } })
talk.def("king", { name = "King", faces = { calm = "dot" }, side = "right", bank = 4 })

local loop = path.def { { x = -5, y = 20 }, { x = 60, y = 45, over = 53, ease = "out" }, { wait = 17 }, { x = 155, y = 15, over = 61, ease = "both" } }
local dive = path.def { { x = 30, y = -6 }, { x = 40, y = 60, over = 70, ease = "both" }, { x = 20, y = 150, over = 90, ease = "in" } }

boss.def("twins", { title = "Two", portrait = "dart", cast = { { name = "left", title = "L", kind = "king", x = 40, y = 30 },
    { name = "right", title = "R", kind = "eye", x = 104, y = 30 } }, phases = {
  { id = "one", hp = { left = 30, right = 40 }, time = 260, rest = 10, safe = 20, armour = 20, run = {
      left = function(e) while true do pattern.fan { from = e, kind = "rice", n = 3, spread = 40, aim = true, speed = 1.4 } wait(20) end end,
      right = function(e) e:wander { w = 30, h = 20, every = 25, over = 20 } while true do pattern.ring { from = e, kind = "orb", n = 6, speed = 1 } wait(25) end end } },
  { id = "two", spell = "Both", hp = 50, time = 260, rest = 10, bonus = 900, bonus_to = 300, down = "any", run = function(l, r)
      while true do pattern.line { from = l, kind = "pin", n = 4, width = 40, dir = 90, speed = 1.2 } pattern.arc { from = r, kind = "orb", n = 4, sweep = 90, speed = 1 } wait(25) end
    end } } })
boss.def("king", { title = "King", kind = "king", x = 72, y = 34, warning = 40, portrait = "dot", phases = {
  { talk = function()
      say("ana", "You again.")
      say("king", "Choose.")
      if choose { "GO", "STAY" } == 1 then say("ana", "Go.", { letter = 0, limit = 30 }) end
    end },
  { id = "a", bg = "hall", drops = { heart = 1 }, clear = { items = "gem" }, hp = 60, time = 300, rest = 10, run = function(e)
      task.go(function() pattern.spiral { from = e, kind = "orb", n = forever, arms = 2, step = 11.3, every = 9, speed = 0.9 } end)
      laser.beam { kind = "ray", follow = e, dir = 60, length = 120, hold = 100, spin = 0.5 }
      wait(60)
      enemy.spawn { kind = "wisp", x = 30, y = 20, run = function(w) -- all of it the phase's, and goes with it
          sprite.put { sprite = "dart", x = w.x, y = w.y, layer = "middle" }
          wait(30)
          enemy.spawn { kind = "eye", from = w, dx = 50 }
          volley(w)
        end }
      enemy.spawn { kind = "eye", x = 110, y = 40, stay = true, run = function(w) w:move { x = 40, y = 20, over = 77, ease = "out" } end }
      sprite.put { sprite = "dart", x = 100, y = 12, layer = "back", stay = true }
    end },
  { id = "b", spell = "Second", hp = 90, time = 400, rest = 10, bonus = 3000, run = function(e)
      while true do
        pattern.ring { from = e, kind = "orb", n = 7, dir = rng.dir(), speed = 0.9, motion = "bloom", tag = "petal" }
        e:move { x = rng.int(30, 110), y = rng.int(25, 50), over = 37, ease = "in" }
        bullet.fire { kind = "rice", from = e, dir = rng.number(60, 120), speed = 170 } -- leaves in the frame in which it touches
        wait(48)
      end
    end } } })

local counts = { graze = 0, hit = 0, death = 0, kill = 0, leave = 0, extend = 0 }
for name in pairs(counts) do on[name](function() counts[name] = counts[name] + 1 end) end
on.phase(function(e, id, won)
  board.note(id)
  board.note(won)
  if e.alive then spark.burst { kind = "pop", from = e, n = 3, speed = 1 } end
end)
on.stage(function(name, state) board.note(name .. state) end)
on.game_over(function() board.note("over") end)
on.start(function() board.note(game.rank) end)
on.bomb(function(p, late) board.note(late) game.rank = game.rank - 1 board.note(p.state) end)
on.continue(function(p) p.safe = 100 board.note(game.continues) end)

bg.def("field", function() bg.layer(1).map, bg.layer(1).vy = "ground", 0.7 bg.lines(1, { wave = 3, every = 40, speed = 0.5 }) end)
bg.def("hall", function() local g = bg.plane() g.map, g.horizon, g.height, g.vy = "ground", 40, 20, -1 end)

stage.def("one", function()
  bg.show("field")
  talk.run(function() say("ana", "One more time, then, and no further than the gate.") end, { hold = "all" })
  text.line { x = 20, y = 100, text = "Words, one by one", letter = 3, width = 60, box = true }
  stage.at(30) stage.wave { kind = "wisp", n = 4, every = 19, path = loop, dy = 3.3 }
  stage.at(120)
  stage.mark("middle")
  stage.wave { kind = "eye", n = 3, every = 0, path = dive, formation = "v", gap = 9 }
  enemy.spawn { kind = "raft", x = 70, y = 30 }
  stage.clear(300)
  boss.fight("twins")
end)
stage.def("two", function()
  stage.at(20) stage.wave { kind = "wisp", n = 3, every = 16, path = loop, mirror = true }
  stage.mark("king")
  boss.fight("king")
  wait(30)
end)

local function fold(s)
  local h = 0
  for i = 1, #s do h = (h * 33 + s:byte(i)) & 0x7fffffff end
  board.note(h)
end
local function library(i)
  local t, out = {}, {}
  for k = 1, 12 do t[k] = { k * 37 % 11 + 0.5 / k, k } end
  table.sort(t, function(a, b) return a[1] < b[1] end)
  for k, v in ipairs(t) do out[k] = ("%d:%.6f:%g"):format(v[2], math.sin(v[1] * i), math.sqrt(v[1]) / 3) end
  fold(table.concat(out, ","):gsub("(%d+):(%-?)", "%2<%1>"):upper() .. tostring(i / 7) .. math.atan(i, 3))
  for k, v in pairs { z = 1, a = 2, [3] = 3, [-1] = 4 } do fold(k .. "=" .. v) end
end

task.go(function()
  local petals, seen = bullet.group("petal"), save.get("seen", 0)
  wait(2) -- boot.run wipes what was there before it
  local mark
  palette.cycle { first = 17, last = 30, every = 3 }
  for i = 1, forever do
    library(i)
    if i % 8 == 0 then bullet.fire { kind = "ghost", x = rng.number(0, 140), y = 0, speed = rng.number(0.6, 3), dir = rng.dir(), motion = i % 16 == 0 and "spin" or "arc" } end
    if i % 100 == 0 then
      petals.speed, petals.bank = 0.5, 6
      bullet.each("petal", function(b) b.dir, b.tag = rng.dir(), "melt" end)
      palette.fade { to = 0x203040, over = 20, first = 200, last = 250 }
      seen = seen + 1
      save.set("seen", seen)
    end
    local p = player.nearest(3, 4)
    if p.alive then
      if not mark or not mark.alive then mark = sprite.put { sprite = "dart", x = 5, y = 5, layer = "front" } end
      mark.x, mark.y, mark.flip_x = p.x, p.y - 9.5, i % 2 == 0
      local near = query.near { what = "bullet", x = p.x, y = p.y, radius = 20 }
      fold(#near .. " " .. angle.to(p, { x = 1, y = 2 }) .. " " .. p.x .. " " .. p.grazes .. " " .. p.score)
    end
    board.note(counts.graze + counts.kill * 1000)
    wait(1)
  end
end)
boot.run { stages = { "one", "two" }, players = { "quick", "slow" }, continues = 1,
  difficulties = { easy = "Easy words" }, ships = { quick = { text = "Quick words" } }, staff = { { "WHO", "Whole" } } }

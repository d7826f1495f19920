-- kinds.lua - the kinds and their motion programs: every key of a motion step, immediate and over time.
spark.def("ping", { sprite = "steps", life = 30, gravity = 0.1, drag = 0.05, bank = 2 })
fx.def("burst", { shake = 3, flash = 0.2, chain = 3, sparks = { { kind = { "ping", "ping" }, n = 2, speed = 2 } } })
spark.def("long", { sprite = "box", life = 400, banks = { 1, 7, 3 } })

item.def("coin", { sprite = "steps", radius = 6, gives = { score = { 5, 500 }, power = 2, bombs = -1 }, full = "power",
  on_take = function(p, i) board.note(i.x + i.y + i.age + p.power + (i.alive and 9 or 0)) end })
item.def("heart", { sprite = "letter", radius = 20, gives = { lives = 1 }, gravity = 0.01, top = 0.5, magnet = false, bank = 3 })
item.def("husk", { sprite = "box", radius = 9, gravity = 0, bank = 1 })

bullet.def("dot", { sprite = "steps", hit = { circle = 3 } })
bullet.def("crate", { sprite = "box", hit = { box = { 10, 14 } }, bank = 4, vanish = "ping", order = -3 })
bullet.def("ghost", { sprite = "letter", hit = "none", graze = false })
bullet.def("needle", { sprite = "arrow", hit = { capsule = { 14, 2 } }, turns = true, bank = 1 })
bullet.def("saw", { sprite = "arrow", hit = { circle = 4 }, spin = -7.5, order = 9, clearable = false, vanish = "long", scale = 1.5 })

bullet.def("seed", { sprite = "arrow", hit = { circle = 4 }, turns = true, cloud = "steps" })
bullet.def("late", { sprite = "steps", hit = { circles = { { -1.5, 0.5, 2.5 }, { 2.5, 0, 1.5 } } }, bank = 6, swept = false,
  scale = 0.75, scale_hit = true })

laser.def("ray", { strip = "steps", width = 6, hit = { share = 0.5 }, head = "arrow", tail = "letter", vanish = "ping" })
laser.def("bar", { strip = "letter", width = 9, hit = "none", clearable = false, graze = 0, bank = 2 })
laser.def("lance", { strip = "box", width = 5, hit = { share = 1 }, damage = 1, every = 6 })

bullet.def("nut", { sprite = "box", hit = { box = { 12, 12 } }, hp = 5, score = 30, spark = "ping", cloud = "steps", drops = { coin = 2 },
  on_death = function(b, p) board.note(b.x + b.y + b.hp + (p and p.index or 0) + (b.alive and 9 or 0)) end })
bullet.def("shield", { sprite = "letter", hit = { circle = 6 }, hp = forever, clearable = false, bank = 2 })

bullet.def("veil", { sprite = "letter", hit = { circle = 8 }, harmless = true,
  vanish = "ping", bank = 3 })
bullet.meet("ring", "veil", { clear = "first", spark = "long" })
bullet.meet("b1", "b2", { clear = "both", all = true,
  on_meet = function(a, b) board.note(a.x * 3 + b.y) end })
bullet.meet("moved", "moved", {
  on_meet = function(a, b) a.bank, b.tag = (a.bank + 3) % 16, "hard" end })
bullet.meet("hard", "b0", { clear = "second",
  on_meet = function(a, b) if a.age % 5 == 0 then b:remove() end end })

shot.def("bolt", { sprite = "box", hit = { box = { 8, 16 } }, damage = 2, turns = true })
shot.def("ball", { sprite = "steps", hit = { capsule = { 3, 2.5 } }, bank = 5, swept = false, pierce = forever, every = 4,
  scale = 1.25, scale_hit = true })
shot.def("wiper", { sprite = "steps", hit = { circle = 2 }, cancels = true, order = 2, pierce = 3 })
shot.def("flash", { sprite = "letter", hit = "none" })

value.def("heat", { start = 1.5 })
value.def("goal")
value.def("heat", { of = "shot", start = -2 })
value.def("mood", { of = "enemy" })

motion.def { name = "all",
  { wait = 3 },
  { kind = "needle", bank = 7 }, { dir = 100 }, { aim = true }, { turn = 30 }, { speed = 1 }, { accel = 0.25 },
  { kind = "crate", bank = 3, turn = 2, speed = 2.5, over = 9 },
  { aim = true, accel = 0.05, over = 6 },
  { home = 4, over = 20 },
  { loop = 3, { wait = 2 }, { loop = 2, { turn = -20 }, { turn = 10, over = 2 } } },
  { accel = -0.1, over = 12 },
  { wait = 20 }, { die = true } }
motion.def { name = "named", { wait = "goal" }, { turn = "heat", bank = "goal", over = "goal" }, { dir = "heat", speed = "heat" },
  { home = "heat", accel = "goal", over = 3 }, { speed = "goal", over = 5 } }
motion.def { name = "led", { go_to = { "goal", 60 }, over = 9, ease = "both" }, { go_to = { 90, "heat" }, speed = "goal" },
  { polar = "heat", spin = 7, at = { "goal", 20 }, over = 20 }, { polar = 1, spin = "goal", over = 12, kind = "dot" },
  { wave = "goal", every = "goal", phase = "heat", over = 25, bank = 4 }, { orbit = 20, radius_to = "heat", spin = -9, over = 15 },
  { orbit = "goal", at = { 100, 100 }, spin = 4, over = 30 }, { wave = 9, every = 7, over = forever } }
motion.def { name = "pulled", { ax = "heat", ay = 0.03, limit = 3, over = 14 }, { vx = 1, vy = "goal", over = 9, bank = 6 }, { ay = -0.5 },
  { turn = "heat", turn_to = -4, over = 8 }, { vx = -1.5, vy = 0.25 }, { ax = 0.01, over = forever } }
motion.def { name = "bouncing", { bounce = 2, walls = "left right bottom", { bank = 5 }, { turn = 3, over = 4 } }, { bounce = forever, walls = "top", over = 90 } }
motion.def { name = "spin", { loop = forever, { turn = 3, over = 10 }, { bank = 9 }, { turn = -3, over = 10 }, { bank = 1 } } }
motion.def { name = "nested", { loop = 2, { loop = 2, { loop = 2, { loop = 2, { wait = 1 }, { accel = 0.02 } } } } }, { wait = forever } }
motion.def { name = "stop", { speed = 0, over = 15 }, { wait = 10 }, { aim = true, turn = 5, speed = 3 } }
motion.def { name = "drift", fine = true, { kind = "late", speed = 0.4, over = 40 }, { turn = 0.001, over = 30 },
  { accel = 0.00001, over = 50 }, { aim = true } }

-- ---- programs that fire, wait and follow ----

motion.def { name = "third", { wait_for = { tag = "go", limit = 20 } }, { emit = { kind = "ghost", speed = "heat", tag = "late", delay = "goal" } },
  { die = true } }
motion.def { name = "burst", { wait_for = { near = 60, limit = "goal" } },
  { emit = { pattern = "ring", n = 3, skip = { 2, 2 }, kind = "dot", speed = 1.25, bank = "goal", motion = "third", heat = "goal" } },
  { emit = { pattern = "line", n = "goal", width = 30, kind = "seed", speed = 1, aim = true, delay = 4, tag = "ring" } }, { die = true } }
motion.def { name = "sower", { loop = forever, { wait_for = { y = "heat", limit = 9 } }, { wait = 2 }, { turn = 20 },
  { emit = { pattern = "fan", n = 2, spread = "heat", kind = "dot", speed = 2, motion = "burst", goal = 3 } },
  { wait_for = { x = 112, limit = 9 } }, { emit = { pattern = "arc", n = 2, sweep = 90, dir = 10, kind = "needle", speed = 1.5 } },
  { emit = { pattern = "stack", n = 3, speed_to = 2, kind = "dot", speed = 1, tag = "b1" } } } }
motion.def { name = "cluster", { wait_for = { tag = "go", limit = 12 } }, { emit = { fire = "shot", pattern = "fan", n = 3, spread = 30,
  kind = "ball", speed = 4, heat = "heat", tag = "volley" } }, { die = true } }
local hook = path.def { { x = 9, y = 9 }, { x = 40, y = 20.5, over = 12, ease = "both" }, { wait = 4 }, { x = 30, y = 90, over = 20 } }
motion.def { name = "hooked", { path = hook, mirror = true, kind = "late" }, { path = hook, bank = 3 } }

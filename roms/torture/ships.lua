-- ships.lua - two ships. Their tasks shoot, read the pads and set every property of a player.
local function shoot(p, kind)
  if pad.down("fire", p) then
    for i = -1, 1 do shot.fire { kind = kind, from = p, dx = 6 * i, dir = 270 + 8 * i, speed = 6, tag = "volley" } end
  end
  if pad.pressed("fire", p) then shot.fire { kind = "flash", from = p, dy = -8, speed = 4 } end
  if pad.released("fire", p) then shot.fire { kind = kind, x = p.x, y = p.y, aim = true, speed = 2, by = p, motion = "spin" } end
end

local function fly(kind)
  return function(p)
    while true do
      shoot(p, kind)
      if p.kind == "slow" and p.grazes % 5 == 2 and p.state == "fly" then board.note(p:bomb()) end
      if pad.repeated("special", p) then p.x, p.y = p.x + p.index, p.y - 1 end
      if pad.pressed("special", p) then p:push(-p.index, -1) p:shift(-1, 1) end
      if p.grazes % 9 == 4 then task.go(function() p.speed_scale, p.focus = 1.25, p.focus wait(p.index) end) end
      if p.grazes % 11 == 6 then p.focus = nil end
      if p.focus and p.safe == 0 and p.lives < 2 and p.grazes % 7 == 3 then p.lives = math.min(9, p.lives + 1) end
      board.note(p.score + p.lives + p.power)
      board.note(p.kind)
      board.note(pad.take("bomb", 2, p))
      wait(2)
    end
  end
end

bomb.def("burst", { over = 40, run = function(p)
  bullet.clear { spark = "ping" }
  sprite.put { sprite = "steps", follow = p }
  task.go(function() while true do wait(7) board.note(p.bombs) end end)
  wait(forever)
end })
bomb.def("shove", { over = 25, safe = 5, cost = 2, run = function(p)
  bullet.sweep { follow = p, radius_to = 90, over = 30, hurt = 3, by = p, spark = "ping" }
end })

-- Fires, and reads its own properties.
option.def("bead", { sprite = "steps", bank = 3, layer = "middle", run = function(o)
  local n = 0
  while true do
    n = n + 1
    if pad.down("fire", o.by) then shot.fire { kind = "bolt", from = o, dir = o.focus and 270 or 250 + 9 * o.index, speed = 5 } end
    o.bank, o.hidden = (o.bank + 1) % 16, not o.hidden
    board.note(o.x + o.y + o.age)
    board.note(o.kind .. o.index)
    if n == 5 then sprite.put { sprite = "box", follow = o, dy = 4 } end
    wait(11)
  end
end })
option.def("moon", { sprite = "arrow", layer = "front", turns = true, run = function(o)
  while true do wait(40) board.note(o.dir) o.dir = o.dir + 90 end
end })

player.def("fast", { sprite = "letter", hit = { circle = 2 }, graze = 18, speed = 5, focus = 2.5, lives = 3, safe = 60,
  registers = { power = { max = 30, drain = 1, every = 50, hold = 30 }, bombs = { start = 1, max = 2, drain = -1, every = 400 } },
  bomb = "burst", deathbomb = 2, options = { kind = "bead", by = "power", over = 5, levels = {
    { at = 1, wide = { { 0, 16 } } },
    { at = 3, wide = { { -16, 4 }, { 16, 4 } }, close = { { -6, -9 }, { 6, -9 } } },
    { at = 8, wide = { { -16, 4 }, { 16, 4 }, { -28, 9 }, { 28, 9 } } } } }, magnet = 30, collect_line = 60, collect_full = "power", run = fly "bolt" })
player.def("long", { sprite = "box", hit = { circle = 3 }, lives = 2, registers = { bombs = 1, power = { max = 4 } }, bomb = "burst",
  run = fly "ball", options = { kind = "bead", style = "trail", apart = 6, levels = { { n = 4 } } } })
player.def("slow", { sprite = "arrow", hit = { circle = 3 }, speed = 3, registers = { bombs = { start = 3, max = 5, show = "icons" },
  power = { start = 1, max = 99, show = "bar" }, chain = { drain = forever, hold = 40 } }, pull = 2.5, run = fly "ball",
  bomb = "shove", bomb_focus = "burst", deathbomb = 4,
  options = { kind = "moon", by = "power", style = "orbit", radius = 25, close = 9, spin = 7, levels = { { n = 2 }, { at = 5, n = 5 } } },
  pictures = { left = "box", right = "letter", pose = "steps" } })

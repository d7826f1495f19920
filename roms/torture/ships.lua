-- ships.lua - two ships. Their tasks shoot, read the pads and write every property a player has.
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
      if pad.pressed("bomb", p) and p.bombs > 0 then
        p.bombs = p.bombs - 1
        p.safe = 40
        bullet.clear { spark = "ping" }
      end
      if pad.repeated("special", p) then p.x, p.y = p.x + p.index, p.y - 1 end
      if p.focus and p.safe == 0 and p.lives < 2 and p.grazes % 7 == 3 then p.lives = math.min(9, p.lives + 1) end
      board.note(p.score + p.lives + p.power)
      board.note(p.kind)
      board.note(pad.take("bomb", 2, p))
      wait(2)
    end
  end
end

player.def("fast", { sprite = "letter", hit = { circle = 2 }, graze = 18, speed = 5, focus = 2.5, lives = 4, safe = 60,
  registers = { power = { max = 30 }, bombs = 2 }, magnet = 30, collect_line = 60, collect_full = "power", run = fly "bolt" })
player.def("slow", { sprite = "arrow", hit = { circle = 3 }, speed = 3, registers = { bombs = { start = 3, max = 5, show = "icons" },
  power = { start = 1, max = 99, show = "bar" } }, pull = 2.5, run = fly "ball",
  pictures = { left = "box", right = "letter", pose = "steps" } })

-- main.lua - something of every chip a script reaches without the shell: bullets and their programs, shots, enemies,
-- sprites, sparks, text, colours, saves, tasks, random numbers, and both pads.
bullet.def("orb", { sprite = "dot", hit = { circle = 2.25 } })
bullet.def("rice", { sprite = "dart", hit = { box = { 4, 2 } }, turns = true })
shot.def("bolt", { sprite = "dart", hit = { box = { 3, 5 } }, damage = 2, turns = true })
spark.def("pop", { sprite = "dot", life = 20, gravity = 0.07, drag = 0.03 })
motion.def { name = "bloom", { wait = 5 }, { speed = 0.1, over = 7 }, { bank = 5 }, { loop = 3, { turn = 11.7, over = 4 }, { accel = 0.13, over = 3 } },
  { kind = "rice", home = 3.3, over = 20 }, { speed = 2.75, over = 9 } }
motion.def { name = "arc", fine = true, { speed = 0.7 }, { turn = 0.9, over = 200 } }
enemy.def("wisp", { sprite = "dot", hit = { box = { 9, 7 } }, hp = 5, score = 170, spark = "pop" })

local kills = save.get("kills", 0)
on.kill(function()
  kills = kills + 1
  save.set("kills", kills)
end)

task.go(function() -- wisps come, fly across, and fire
  while true do
    local e = enemy.spawn { kind = "wisp", x = rng.int(8, 56), y = -4 }
    e:move { x = rng.int(8, 56), y = 70, over = rng.int(60, 140), ease = "both" }
    task.go(function()
      while e.alive do
        wait(rng.int(5, 15))
        for i = 1, e.alive and 6 or 0 do
          bullet.fire { kind = "orb", x = e.x, y = e.y, dir = i * 60 + rng.number(0, 9), speed = 1.1, bank = i, motion = i % 2 == 0 and "bloom" or "arc" }
        end
      end
    end)
    wait(rng.int(20, 50))
  end
end)

local at = { 20, 44 }
for p = 1, 2 do -- a cursor a pad
  local s
  task.go(function()
    while true do
      at[p] = at[p] + (pad.down("right", p) and 1 or 0) - (pad.down("left", p) and 1 or 0)
      if not s or not s.alive then s = sprite.put { sprite = "dot", x = at[p], y = 56, bank = p } end
      s.x = at[p]
      if pad.pressed("fire", p) or pad.repeated("fire", p) then shot.fire { kind = "bolt", x = at[p], y = 54, speed = 6.5, dir = 270 + rng.number(-5, 5) } end
      if pad.pressed("bomb", p) then
        bullet.clear { x = at[p], y = 40, radius = 30, spark = "pop" }
        palette.set(16 * p + 1, rng.int(0, 0xffffff))
      end
      if pad.released("focus", p) then board.note(at[p]) end
      wait(1)
    end
  end)
end

task.go(function()
  while true do
    text.put { col = 0, row = 0, text = ("%4d %d"):format(board.live("bullets"), kills) }
    wait(30)
  end
end)

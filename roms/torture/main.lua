-- main.lua - declares the kinds and handlers, and starts the shell. Select on player 2's pad resets the board.
require "kinds"
require "ships"
require "world"

game.def { registers = { rank = { start = 40, min = -5, max = 60, drain = 1, every = 33, hold = 20 } } }

local seen = 0 -- number of handler calls

on.graze(function(p, b)
  seen = seen + p.grazes
  score.add(10, p)
  if b.alive then b.bank = (b.bank + 1) % 16 end
  spark.burst { kind = "ping", from = p, n = 2, speed = 2 }
end)
on.hit(function(p, by)
  if rng.chance(0.25) then p.safe = 10 end
  bullet.fire { kind = "dot", from = by, dir = 270, speed = 3, tag = "revenge" } -- first moves next frame
end)
on.death(function(p)
  bullet.clear { x = p.x, y = p.y, radius = 50, spark = "ping" }
  task.go(function(lives) wait(2) seen = seen + lives end, p.lives)
end)
on.game_over(function() seen = seen + 1000 end)
on.bomb(function(p, late) seen = seen + p.index + (late and 7 or 3) end)
on.continue(function(p) seen = seen + p.score + game.continues end)
on.start(function() seen = game.rank task.go(function() while true do wait(50) game.rank = game.rank + 2 end end) end)
on.kill(function(_, p)
  if not (p and p.alive) then return end
  p.power = p.power + 1
  if p.kind == "slow" then p.chain = p.chain + 1 end
  game.rank = game.rank - 1
  board.note((game.stage or "none") .. game.rank .. " " .. game.frames)
end)
on.take(function(p, i) board.note(i.kind .. p.index) if i.kind == "husk" then i:remove() item.group("old"):remove() end end)
on.leave(function(e) seen = seen + (e.alive and 1 or 2) end)
on.extend(function(p) p.lives = math.min(p.lives, 9) end)
on.phase(function(e, id, won) board.note(id) board.note(won) if e.alive then e:hurt(1) end end)
on.stage(function(name, state) board.note(name .. state) end)

score.rule { on = "kill", gain = { power = 1 }, points = 10, times = "power" }
score.rule { on = "graze", kind = "dot", points = function(p) return p.grazes end, most = { bombs = "power" } }
score.rule { on = "death", set = { power = 0 } }
score.rule { name = "cancel", points = 3, times = "bombs" }
score.tally { { label = "Graze", value = "grazes", points = 7, stage = true },
  { label = "Power", value = function(p) return (p.power or 0) > 3 end, points = 99 } }
unlock.def("once", { when = { clear = "first" }, hint = "clear it once" })
unlock.def("often", { when = function(run) return run.scores[1] % 3 == 0 end })

task.go(function()
  while true do
    wait(1)
    board.note(unlock.has "once" and "once" or "never")
    board.note(seen)
    if pad.pressed("select", 2) then board.reset() end
  end
end)

boot.run { stages = { "first", "second" }, players = { "fast", "slow", "long" }, demo = "torture", continues = 2,
  music = { title = "round", results = "short", clear = "short", over = "round", scores = "short", room = true } }

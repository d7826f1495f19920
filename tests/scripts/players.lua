-- Registers of a ship and of the run, and what a hit ends. tests/machine/test_players.c has what buttons do.
--board: items=16 lasers=16 options=32
game.def {
  registers = {
    rank = { start = 50, min = -10, max = 100, drain = 1, every = 60 },
    luck = 3, power = 50, glow = { max = 9 }, full = { max = 1 },
    blaze = { max = 2 }, -- the first in byte order
  },
}
player.def('ship', {
  sprite = 'dot', hit = { circle = 2 }, collect_full = 'blaze', magnet = 0, safe = 0,
  registers = { a = { start = 1, max = 3 }, power = 1, full = { max = 2 } },
})
item.def('gem', { sprite = 'dot', radius = 9, gives = { glow = 7, power = 3 } })
item.def('ember', { sprite = 'dot', radius = 9, gives = { score = 10, blaze = 1, luck = 1 }, full = 'blaze' })
item.def('chip', { sprite = 'dot', radius = 9, gives = { score = 10, full = 1 }, full = 'full' })
bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })
shot.def('ball', { sprite = 'dot', hit = { circle = 1 } })
laser.def('lance', { strip = 'dot', width = 4, hit = { share = 1 }, damage = 1 })
laser.def('ray', { strip = 'dot', width = 4, hit = 'none' })
bomb.def('wave', { over = 30, cost = 0, safe = 40, run = function(p) print('bomb', p.index) end })
for name, window in pairs { saved = 6, lost = 0 } do
  player.def(name, { sprite = 'dot', hit = { circle = 2 }, safe = 0, bomb = 'wave', deathbomb = window })
end
local mark, near, far -- of an option
option.def('bead', {
  sprite = 'dot',
  run = function(o)
    laser.beam { kind = 'lance', follow = o, dir = 270, length = 50, hold = forever }
    mark = sprite.put { sprite = 'dot', follow = o, dy = 9 }
    near = shot.fire { kind = 'ball', from = o, speed = 0 }
    far = shot.fire { kind = 'ball', x = 9, y = 9, speed = 0, by = o.by }
  end,
})
player.def('host', {
  sprite = 'dot', hit = { circle = 2 }, registers = { n = 0 },
  options = { kind = 'bead', by = 'n', over = 0, levels = { { at = 1, wide = { { 20, 0 } } } } },
})
local function started() end -- a case's own
player.def('tank', {
  sprite = 'dot', hit = { circle = 2 },
  registers = {
    a = { start = 10, min = 3, max = 20, drain = 2, every = 5, hold = 7 },
    b = { start = 5, drain = forever, hold = 3 },
    c = { max = 9, drain = -1, every = 2, hold = 4 },
  },
})
on.start(function() started('start', game.rank, game.frames) end)
local sys = string.sys
local function start(kind)
  local scope = sys.scope()
  sys.join(1, kind or 'ship')
  sys.start(scope)
  return player.get(1), scope
end
local function beam(kind, p)
  return laser.beam { kind = kind, follow = p, dir = 270, length = 90, hold = forever, warn = 0, grow = 2, fade = 9 }
end
local function bolt(p) return laser.bolt { kind = 'lance', from = p, speed = 9, length = 9 } end
local function ball(p) return shot.fire { kind = 'ball', from = p, speed = 0 } end

--case: registers drain to their minimum, maximum or start; a change against the drain holds it
sys.join(1, 'tank')
local p = player.get(1)
local function row(name, frames)
  local seen = {}
  for i = 1, frames do
    seen[i] = p[name]
    wait(1)
  end
  print(table.concat(seen, ' '))
end
task.go(row, 'a', 40)
task.go(row, 'b', 40)
task.go(row, 'c', 40)
wait(12)
p.a, p.b, p.c = 99, 8, 2
wait(20)
p.a, p.b, p.c = -50, 1, 99
wait(9)
--> 10 10 10 10 10 8 8 8 8 8 6 6 20 20 20 20 20 20 20 18 18 18 18 18 16 16 16 16 16 14 14 14 3 3 3 3 3 3 3 3
--> 5 5 5 5 5 5 5 5 5 5 5 5 8 8 8 5 5 5 5 5 5 5 5 5 5 5 5 5 5 5 5 5 1 5 5 5 5 5 5 5
--> 0 0 1 1 2 2 3 3 4 4 5 5 2 2 2 2 3 3 4 4 5 5 6 6 7 7 8 8 9 9 9 9 9 9 9 9 9 9 9 9

--case: a run's registers start again with it, and its tasks end with it
started = function(...)
  print(...)
  task.go(function()
    wait(1)
    print('scope')
    wait(1)
    print('never')
  end)
end
local p, scope = start()
game.rank, game.luck, p.a = 999, game.luck - 9, 9
wait(2)
print(game.rank, game.luck, p.a, game.frames)
task.stop(scope)
sys.leave(1)
wait(1)
p = start()
print(game.rank, p.a)
--> start 50 0
--> scope
--> 100 0 3 2
--> start 50 0
--> 50 1

--case: an item gives a register of the ship that takes it, or one of the run
local p = start()
for _ = 1, 2 do item.drop { kind = 'gem', from = p } end
wait(2)
print(game.glow, game.power, p.power)
--> 9 50 7

--case: at a register's max an item gives points alone, and all come to a ship that says so
local p = start()
item.drop { kind = 'ember', x = p.x, y = 40, speed = 0 }
local far
item.each(nil, function(i) far = i end)
for _ = 1, 3 do
  item.drop { kind = 'ember', from = p }
  item.drop { kind = 'chip', from = p }
  wait(2)
  print(game.blaze, game.luck, p.full, p.score, far.vy > 3)
end
--> 1 4 1 20 false
--> 2 5 2 40 true
--> 2 5 2 60 true

--case: an option's beams and sprites go with it, and its shots are its player's
sys.join(2, 'host')
local p = player.get(2)
p.n = 1
wait(3)
p.x = 50
wait(1)
laser.each(nil, function(l) print(l.x - p.x, l.y - p.y) end)
print(mark.x - p.x, mark.y - p.y, near.by.index, far.by.index)
p.n = 0
wait(20)
print(board.live 'options', board.live 'sprites', board.live 'lasers')
--> 20.0 0.0
--> 20.0 9.0 2 2
--> 0 0 0

--each: a hit ends the beams of that ship alone; while it waits for a bomb it fires nothing
sys.join(1, 'saved')
sys.join(2, 'saved')
local p = player.get(1)
local mine, far, other, evil = beam('lance', p), bolt(p), beam('lance', player.get(2)), beam('ray', p)
wait(5)
bullet.fire { kind = 'orb', from = p, speed = 0 }
wait(1)
bullet.group():remove()
wait(1)
print(p.state, mine.state, far.state, other.state, evil.state)
print(ball(p).alive, beam('lance', p).alive, bolt(p).alive, beam('ray', p).alive)
print(p:bomb(), p.state, ball(p).alive, beam('lance', p).alive)
wait(8)
print(mine.alive)
--> hit fade on on on
--> false false false true
--> true fly true true
--> bomb 1
--> false

sys.join(1, 'lost')
local p = player.get(1)
local mine = beam('lance', p)
wait(5)
bullet.fire { kind = 'orb', from = p, speed = 0 }
wait(1)
bullet.group():remove()
wait(1)
print(p.state, mine.state, beam('lance', p).alive)
--> fly fade true

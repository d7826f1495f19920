-- What a game may rely on within a frame: when things first move, in which order tasks get their turns and how they
-- end, and in which order handlers are called. The cases print a log of words, in which "/" begins a frame.
bullet.def('dot', { sprite = 'dot', hit = { circle = 2 } })
bullet.def('air', { sprite = 'dot', hit = 'none' })
shot.def('bolt', { sprite = 'dot', hit = { box = { 4, 4 } } })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 20, lives = 1, safe = 0 })
local sys = string.sys
local log, frame = {}, nil
local function say(...)
  frame = frame or board.frame()
  for _ = frame, board.frame() - 1 do log[#log + 1] = '/' end
  frame = board.frame()
  for _, word in ipairs { ... } do log[#log + 1] = tostring(word) end
end
local function told(frames) -- what was said in these frames
  wait(frames)
  print(table.concat(log, ' '))
end
local handler = {} -- a case's own, by event
for event, add in pairs(on) do
  add(function(...) if handler[event] then handler[event](...) end end)
end
on.kill(function() if handler.kill then say('second') end end)
enemy.def('foe', { sprite = 'dot', hit = { box = { 8, 8 } }, touch = false, score = 100 })
local function foe(x, on_death) return enemy.spawn { kind = 'foe', x = x or 50, y = 50, on_death = on_death } end
local function fire(kind, x, y, speed) return bullet.fire { kind = kind, x = x, y = y, dir = 0, speed = speed or 0 } end
local function closing(name) return setmetatable({}, { __close = function() say(name) end }) end
local function join(i, x)
  sys.join(i, 'ship')
  local p = player.get(i)
  p.x, p.y, p.safe = x, 200, 0
  return p
end

--each: what a task starts moves in the same frame, also in an on_death that it causes
local b = fire('air', 50, 50, 2)
local e = foe(10)
e:move { x = 14, y = 50, over = 2 }
local c
foe(50, function() c = fire('air', 50, 50, 2) end):kill()
for _ = 1, 4 do
  print(b.x, c.x, e.x)
  wait(1)
end
--> 50.0 50.0 10.0
--> 52.0 52.0 12.0
--> 54.0 54.0 14.0
--> 56.0 56.0 14.0

--case: what a handler starts first moves in the next frame
local b, c, s, e
handler.kill = function()
  b = fire('air', 50, 50, 2)
  c = bullet.fire { kind = 'air', x = 50, y = 50, dir = 0, speed = 2, motion = motion.def { { speed = 4, over = 2 } } }
  s = shot.fire { kind = 'bolt', x = 50, y = 150, dir = 0, speed = 3 }
  e = foe(50)
  e:move { x = 90, y = 50, over = 4 }
end
foe():kill()
wait(1)
for _ = 1, 3 do
  print(b.x, c.x, s.x, e.x)
  wait(1)
end
--> 50.0 50.0 50.0 50.0
--> 52.0 53.0 53.0 60.0
--> 54.0 57.0 56.0 70.0

--each: tasks get their turns in the order of starting
task.go(function()
  say('a')
  task.go(function()
    say('c')
    task.go(say, 'd')
    wait(1)
    say('g')
  end)
  wait(1)
  say('e')
end)
task.go(function()
  say('b')
  wait(1)
  say('f')
end)
told(2)
--> a b c d / e f g

handler.kill = function() task.go(say, 'new') end
foe():kill()
wait(1)
say('old')
task.go(say, 'newer')
told(2)
--> second / old new newer

--each: waiting
say(0)
wait(0)
say(0)
wait(1)
say(1)
wait(3.0)
say(4)
told(0)
--> 0 0 / 1 / / / 4

local n = 0
wait_until(function()
  say('?')
  n = n + 1
  return n == 3
end)
say('yes')
say(wait_until(function() return true end, 0), wait_until(function() return false end, 0))
say(wait_until(function() return false end, 2))
told(0)
--> ? / ? / ? yes true false / / false

local b = fire('air', 50, 50)
local t = task.go(function()
  wait(2)
  b:remove()
  say('removed')
  wait(1)
  say('end')
end)
wait_for(b, t)
say('both')
wait_for()
wait_for(b)
say('at once')
told(0)
--> removed / end / both at once

--case: a task's function gets all arguments, behind its owner
local e = foe()
task.go(function(...) print(select('#', ...), (...)) end, 'x', nil, nil)
task.own(e, function(owner, n) print(owner == e, n) end, 7)
wait(1)
--> 3 x
--> true 7

--each: an owner's end closes its tasks
local e = foe()
local t = task.own(e, function()
  local _ <close> = closing('closed')
  while true do
    say('turn')
    wait(1)
  end
end)
wait(1)
e:remove()
say(t.alive)
told(2)
--> turn / false closed

local e = foe()
task.own(e, function()
  task.go(function() -- has the caller's owner
    local _ <close> = closing('inner')
    wait(forever)
  end)
end)
wait(1)
e:kill()
told(2)
--> inner

local t = task.go(function()
  wait(1)
  say('owner ends')
end)
task.own(t, function()
  local _ <close> = closing('closed')
  wait(forever)
end)
told(3)
--> owner ends closed

local owner, tasks = task.scope(), {}
local scope = owner
for _, name in ipairs { 'a', 'b', 'c' } do
  owner = task.own(owner, function()
    local _ <close> = closing(name)
    wait(forever)
  end)
  tasks[#tasks + 1] = owner
end
wait(1)
task.stop(scope)
say(scope.alive, tasks[1].alive, tasks[3].alive)
told(2)
--> false false false a b c

local e = foe()
e:remove()
print(task.own(e, print, 'never').alive)
--> false

--each: task.stop runs closings and nothing else
local me
me = task.go(function()
  local _ <close> = closing('a')
  wait(1)
  pcall(function()
    local _ <close> = closing('b')
    task.stop(me)
    say('never')
  end)
  say('never')
end)
wait(2)
say(me.alive)
told(1)
--> b a / false

local function run(name)
  local _ <close> = closing('close ' .. name)
  while true do
    say(name)
    wait(1)
  end
end
local old, young = task.go(run, 'old'), nil
task.go(function()
  wait(1)
  task.stop(old)
  task.stop(young)
  say('stop')
end)
young = task.go(run, 'young')
told(4)
--> old young / old stop close young / close old

local t = task.go(say, 'never')
task.stop(t)
task.stop(t)
say(t.alive)
told(2)
--> false

--each: where a script cannot wait
task.go(function() foe():kill() end)
handler.kill = function() wait(1) end
--! wait: only a task can wait; start one with task.go

foe()
enemy.each(nil, function() wait(1) end)
--! wait: cannot wait inside a callback from C (bullet.each, table.sort, string.gsub, <close> and the like)

--load: while scripts load
wait(1)
--! wait: only a task can wait; start one with task.go
by_difficulty { normal = 1 }
--! by_difficulty: no difficulty is chosen while scripts load; call this function during the game
undeclared = 1
--! undeclared global "undeclared" (scripts cannot create globals; write "local undeclared")

--case: a frozen board gives turns to one scope alone, and nothing moves
local b = fire('air', 50, 50, 2)
local scope = task.scope()
local e = foe()
task.own(e, function()
  local _ <close> = closing('closed')
  wait(forever)
end)
task.go(function()
  wait(3)
  say('three')
end)
task.go(function()
  while true do
    say(b.x)
    wait(1)
  end
end)
task.own(scope, function()
  wait(1)
  local frame_before, clock = board.frame(), sys.clock()
  e:remove()
  for _ = 1, 2 do
    say('menu')
    wait(1)
  end
  say(board.frame() - frame_before, sys.clock() - clock)
  sys.freeze()
  say('on')
  task.stop(scope)
end)
wait(1)
sys.freeze(scope)
told(4)
--> 50.0 / menu / closed menu / 2 0 on / 54.0 / 56.0 / three 58.0

--case: events are told in a fixed order, those of tasks before those of hits
local one, two = join(1, 60), join(2, 120)
one.x, one.y = 60, 200 -- it stood aside for the other
local function tell(event) return function(p) say(event .. p.index) end end
for _, event in ipairs { 'graze', 'hit', 'death' } do handler[event] = tell(event) end
handler.game_over = function() say('over') end
handler.kill = function(_, p) say('kill' .. (p and p.index or 0)) end
handler.leave = function() say('leave') end
handler.phase = function(_, id, won) say('phase', id, won) end
handler.stage = function(n, s) say('stage', n, s) end
one.lives, two.lives = 0, 0
sys.emit('stage', 's', 'start')
sys.emit('phase', 1, 'p', true)
foe(200):kill()
foe(10):move { x = -200, y = 50, over = 1 }
fire('dot', 120, 200)
fire('dot', 60, 215)
fire('dot', 60, 200)
foe(150)
shot.fire { kind = 'bolt', x = 150, y = 50, speed = 0, by = two }
wait(1)
say(one.alive)
bullet.clear()
told(1)
--> stage s start phase p true kill2 second graze1 hit1 hit2 leave death1 death2 kill2 second over / false

--case: on.hit may save; on.death sees the lives that are left, and may give some
local p = join(1, 60)
p.lives = 1
local saved = false
handler.hit = function(q)
  say('hit')
  if not saved then q.safe = 1 end
  saved = true
end
handler.death = function(q)
  say('death' .. q.lives)
  if q.lives < 0 then q.lives = 1 end
end
for _ = 1, 4 do
  local b = fire('dot', p.x, p.y)
  wait(1)
  b:remove()
end
told(0)
--> hit / hit death0 / hit death-1 / hit death0

--case: events that a handler causes are handled in the same frame, after the others
local a, b = foe(10), foe(20)
handler.kill = function(e)
  say(e == a and 'a' or 'b', e.x) -- the killed can be read
  if e == a then b:kill() end
end
handler.stage = function() say('stage') end
a:kill()
sys.emit('stage', 1, 2)
told(1)
--> a 10.0 second stage b 20.0 second

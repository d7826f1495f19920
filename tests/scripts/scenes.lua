-- What a boss's phase spawned and put despawns with it, however it ends, and nothing else does: without score, spark
-- or event. The cases print a log of words, and FRAME:IMPS/WHELPS/GUESTS/SPRITES whenever one of these has changed.
bullet.def('dot', { sprite = 'dot', hit = 'none' })
shot.def('bolt', { sprite = 'dot', hit = { box = { 4, 4 } } })
spark.def('bang', { sprite = 'dot', life = 9 })
player.def('ship', { sprite = 'dot', hit = { circle = 1 } })
local foe = { sprite = 'dot', hit = { box = { 8, 8 } }, touch = false, score = 100, spark = 'bang', hp = 5 }
for _, name in ipairs { 'queen', 'imp', 'whelp', 'guest' } do enemy.def(name, foe) end
local sys, log, handler, phase = string.sys, {}, {}, {}
local function say(...)
  for _, word in ipairs { ... } do log[#log + 1] = tostring(word) end
end
on.kill(function(e)
  say('kill ' .. e.kind)
  if handler.kill then handler.kill(e) end
end)
on.leave(function(e) say('leave ' .. e.kind) end)
on.phase(function(_, id, won) say(id .. (won and ' won' or ' lost')) end)
local function define_boss(name, rest, bonus)
  local first = { id = 'one', hp = 10, time = 5, rest = rest, bonus = bonus, run = function(e) phase.one(e) end }
  local second = { id = 'two', hp = 10, time = 5, run = function(e) phase.two(e) end }
  boss.def(name, { title = 'B', kind = 'queen', x = 50, y = 40, phases = { first, second } })
end
define_boss('b', 3)
define_boss('quick', 0, 7)
local way = path.def { { x = 9, y = 9 }, { wait = 100 } }
stage.def('s', function()
  local fight = task.go(boss.fight, 'b')
  wait(30)
  task.stop(fight)
  wait(1)
  stage.at(10)
  say('at ' .. board.frame())
end)
task.go(function() -- writes at the beginning of a frame what was at the end of the last
  local seen = '0/0/0/0'
  while true do
    wait(1)
    local imps, whelps, guests = enemy.count 'imp', enemy.count 'whelp', enemy.count 'guest'
    local now = ('%d/%d/%d/%d'):format(imps, whelps, guests, board.live 'sprites')
    if now ~= seen then say(board.frame() - 1 .. ':' .. now) end
    seen = now
  end
end)
sys.join(1, 'ship')
local function told(frames)
  wait(frames)
  print(table.concat(log, ' '))
end
local function spawn(kind, more)
  local a = { kind = kind, tag = kind, x = 50, y = 50 }
  for k, v in pairs(more or {}) do a[k] = v end
  return enemy.spawn(a)
end
local function put(stay) return sprite.put { sprite = 'dot', x = 9, y = 9, stay = stay } end
local function fire()
  while true do
    bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }
    wait(1)
  end
end
local function brood() -- an imp that spawns a whelp that puts a sprite and fires, and a sprite
  local function whelp()
    put()
    fire()
  end
  local function imp()
    spawn('whelp', { run = whelp })
    wait(forever)
  end
  spawn('imp', { run = imp })
  put()
end
local function guests() -- one that stays and spawns another, which puts a sprite; and a sprite that stays
  local function run()
    spawn('guest', { run = function() put() end })
    wait(forever)
  end
  spawn('guest', { stay = true, run = run })
  put(true)
end
local function result() say(player.get(1).score, board.live 'sparks', board.live 'bullets') end
local function fight(one, two, name)
  phase.one, phase.two = one, two or function() end
  return task.go(function()
    boss.fight(name or 'b')
    say('over')
  end)
end

--each: a phase ends
fight(brood, result) -- its time is up
told(140)
--> 61:1/1/0/2 one lost 66:0/0/0/0 0 0 0 two lost over

fight(function(e)
  brood()
  wait(2)
  e.hp = 0
end, result, 'quick')
told(140)
--> 61:1/1/0/2 7 0 0 one won 64:0/0/0/0 two lost over

fight(function(e)
  brood()
  guests()
  wait(2)
  e:kill()
end)
told(75)
--> 61:1/1/2/4 kill queen one lost 64:0/0/2/2 over

--each: a fight is cut short
local t = fight(function()
  brood()
  guests()
end)
wait(62)
task.stop(t)
wait(2)
say(enemy.count())
result()
told(0)
--> 61:1/1/2/4 63:0/0/2/2 2 0 0 2

stage.play('s', sys.scope()) -- the stage's clock continues
phase.one = brood
told(75)
--> at 41

--case: a move that the phase began ends with it
fight(function(e) e:move { x = 150, y = 40, over = 10 } end, function(e)
  say(e.x)
  wait(1)
  say(e.x)
end, 'quick')
told(80)
--> 100.0 one lost 100.0 two lost

--case: tasks and scopes of a phase, and those of its sprites and bullets
fight(function()
  task.go(function()
    wait(1)
    spawn('imp')
  end)
  task.own(task.scope(), function()
    spawn('imp')
    task.own(task.scope(), function() spawn('imp') end)
  end)
  task.own(put(), function() spawn('whelp') end)
  task.own(bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }, function()
    spawn('whelp')
    task.go(spawn, 'whelp')
  end)
end)
told(75)
--> 61:2/3/0/1 62:3/3/0/1 one lost 66:0/0/0/0 two lost

--case: what others own stays
local mate = spawn('guest')
brood()
fight(function(e)
  for _, owner in ipairs { player.get(1), mate, e } do
    task.own(owner, function()
      spawn('guest')
      wait(forever)
    end)
  end
end)
told(75)
--> 1:1/1/1/2 61:1/1/4/2 one lost two lost

--case: a wave
fight(function()
  local function wave(kind, stay)
    local function run() spawn(kind) end
    stage.wave { kind = 'queen', n = 9, every = 3, path = way, stay = stay, run = run }
  end
  wave('imp')
  wave('guest', true)
end)
told(75)
--> 61:1/0/1/0 64:2/0/2/0 one lost 66:0/0/2/0 two lost

--case: on_death is in its enemy's phase
fight(function()
  local function split()
    spawn('whelp')
    put()
    task.go(function()
      wait(1)
      spawn('whelp')
      fire()
    end)
  end
  local function guest() spawn('guest') end
  local function hit(x) shot.fire { kind = 'bolt', x = x, y = 50, speed = 0 } end
  spawn('imp', { on_death = split }):kill()
  spawn('imp', { hp = 1, x = 100, on_death = split })
  hit(100)
  spawn('imp', { hp = 1, x = 150, stay = true, on_death = guest })
  hit(150)
  wait(2)
  spawn('imp', { stay = true, on_death = guest }):kill()
end)
told(75)
--> kill imp kill imp kill imp 61:0/2/1/2 62:0/3/1/2 kill imp 63:0/4/2/2 one lost 66:0/0/2/0 two lost

--case: a task that an on_death outside the phase starts stays, whoever kills
fight(function()
  local function late()
    wait(40)
    say('late')
  end
  local guest = spawn('guest', { stay = true, on_death = function() task.go(late) end })
  wait(1)
  guest:kill()
end)
told(140)
--> 61:0/0/1/0 kill guest 62:0/0/0/0 one lost two lost late over

--case: what handlers spawn belongs to no phase
handler.kill = function(e)
  if e.kind ~= 'imp' then return end
  spawn('guest')
  task.go(spawn, 'guest')
end
fight(function() spawn('imp'):kill() end)
told(75)
--> kill imp 61:0/0/1/0 62:0/0/2/0 one lost two lost

--each: an error on its way out of on_death, caught by the phase, by another on_death, in a __close
local function bad()
  spawn('whelp')
  error('x', 0)
end
local function kill_bad()
  local g = spawn('guest', { stay = true, on_death = bad })
  say(pcall(g.kill, g))
  spawn('imp')
end
fight(function()
  kill_bad()
  pcall(function()
    wait(1)
    spawn('guest', { stay = true, on_death = bad }):kill()
  end)
  spawn('imp')
end)
told(75)
--> false x kill guest 61:1/1/0/0 kill guest 62:2/2/0/0 one lost 66:0/2/0/0 two lost

fight(function()
  local imp = spawn('imp', { on_death = function() error('x', 0) end })
  local function on_death()
    pcall(imp.kill, imp)
    spawn('guest')
  end
  spawn('guest', { stay = true, on_death = on_death }):kill()
  spawn('imp')
end)
told(75)
--> kill guest kill imp 61:1/0/1/0 one lost 66:0/0/1/0 two lost

local function close()
  local g = spawn('guest', { stay = true, on_death = function() error('x', 0) end })
  say(pcall(g.kill, g))
  spawn('imp')
end
fight(function()
  local t = task.go(function()
    local _ <close> = setmetatable({}, { __close = close })
    wait(forever)
  end)
  wait(1)
  task.stop(t)
end)
told(75)
--> false x kill guest 62:1/0/0/0 one lost 66:0/0/0/0 two lost

--case: an enemy that dies in the phase's last frame calls on.kill and scores
local imp
task.go(function()
  wait_until(function() return imp end)
  wait(4)
  imp:kill()
end)
fight(function() imp = spawn('imp', { on_death = function() spawn('whelp') end }) end, result)
told(75)
--> 61:1/0/0/0 kill imp one lost 66:0/0/0/0 100 12 0 two lost

--case: nothing comes into a phase that is over
local function farewell()
  brood()
  task.go(brood)
  spawn('guest', { stay = true })
end
fight(function()
  local _ <close> = setmetatable({}, { __close = farewell })
  wait(forever)
end)
told(75)
--> one lost 66:0/0/1/0 two lost

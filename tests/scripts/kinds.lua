-- What a clear takes and leaves, by the kinds of bullets.
spark.def('ping', { sprite = 'dot', life = 300 })
spark.def('pong', { sprite = 'wink', life = 300 })
bullet.def('plain', { sprite = 'dot', hit = { circle = 4 } })
bullet.def('gone', { sprite = 'dot', hit = { circle = 4 }, vanish = 'ping', cloud = 'wink' })
bullet.def('fixed', { sprite = 'dot', hit = { circle = 4 }, clearable = false, vanish = 'ping', cloud = 'wink' })
enemy.def('foe', { sprite = 'dot', hit = { circle = 4 } })
boss.def('one', { title = 'One', kind = 'foe', x = 50, y = 50, phases = { {
  id = 'a', hp = 10, time = 60, rest = 40,
  run = function()
    bullet.fire { kind = 'fixed', x = 9, y = 9, speed = 0 }
    wait(20)
    print('in the phase', bullet.clear())
    wait(forever)
  end,
} } })
local function fire(kind, x, delay)
  return bullet.fire { kind = kind, x = x, y = 50, speed = 0, tag = kind, delay = delay }
end
local shown = 0
local function clear(t)
  local n = bullet.clear(t)
  print(n, 'bullets', board.live 'sparks' - shown, 'sparks')
  shown = board.live 'sparks'
  bullet.group():remove()
end
local function fill()
  for x = 10, 50, 10 do
    fire('plain', x)
    fire('gone', x)
    fire('fixed', x)
  end
end

--case: bullets that are clearable, or all; the spark of the clear, or those of the kinds
for _, arguments in ipairs { {}, { spark = 'pong' }, { all = true }, { all = true, spark = 'pong' }, { tag = 'fixed' },
  { tag = 'fixed', all = true }, { x = 10, y = 50, radius = 12 } } do
  fill()
  clear(arguments)
end
print(bullet.group().count, 'left by remove')
--> 10 bullets 5 sparks
--> 10 bullets 10 sparks
--> 15 bullets 10 sparks
--> 15 bullets 15 sparks
--> 0 bullets 0 sparks
--> 5 bullets 5 sparks
--> 4 bullets 2 sparks
--> 0 left by remove

--case: a bullet is cleared as the kind that it is now
fire('fixed', 10).kind = 'plain'
clear()
fire('plain', 10).kind = 'fixed'
clear()
--> 1 bullets 0 sparks
--> 0 bullets 0 sparks

--case: a delayed bullet is cleared as its kind says, not as its cloud
for _, kind in ipairs { 'fixed', 'gone', 'plain' } do
  fire(kind, 10, 30)
  wait(5)
  clear()
end
--> 0 bullets 0 sparks
--> 1 bullets 1 sparks
--> 1 bullets 0 sparks

--case: the end of a phase clears all
boss.fight 'one'
print('after it', bullet.group().count)
--> in the phase 0
--> after it 0

--load: arguments
bullet.def('a', { sprite = 'dot', hit = 'none', spin = 3 })
--! bullet.def: spin: sprite "dot" has no rotations (add `rotations` to it in rom.lua)

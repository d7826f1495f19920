-- Enemies that cannot be hurt for some frames.
enemy.def('foe', { sprite = 'dot', hit = { box = { 8, 8 } }, hp = 100, touch = false })
shot.def('bolt', { sprite = 'dot', hit = { box = { 8, 8 } } })

--case: `safe` counts the frames, this one included
local e = enemy.spawn { kind = 'foe', x = 50, y = 50 }
local function shoot()
  shot.fire { kind = 'bolt', x = 50, y = 50, speed = 0 }
  wait(1)
  return e.hp
end
print(shoot())
e.safe = 2
print(shoot(), shoot(), shoot())
e.safe = forever
print(shoot(), shoot(), e.safe == forever)
e.safe = 0
print(shoot())
--> 99
--> 99 99 98
--> 98 98 true
--> 97

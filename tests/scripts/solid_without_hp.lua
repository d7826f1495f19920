-- Shots that cancel bullets on a board without hp of bullets.
bullet.def('plain', { sprite = 'dot', hit = { circle = 4 } })
bullet.def('fixed', { sprite = 'dot', hit = { circle = 4 }, clearable = false })
shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })
shot.def('eraser', { sprite = 'dot', hit = { circle = 3 }, cancels = true })
local function fire(kind, delay) return bullet.fire { kind = kind, x = 50, y = 100, speed = 0, delay = delay } end
local function shoot(kind) return shot.fire { kind = kind, x = 50, y = 150, speed = 10 } end

--each: one bullet for one shot
fire('plain')
fire('plain')
fire('plain')
shoot 'eraser'
local s = shoot 'eraser'
wait(10)
print(bullet.group().count, s.alive)
--> 1 false
fire('fixed')
local s = shoot 'eraser'
wait(10)
print(bullet.group().count, s.alive)
--> 1 true
fire('plain', 40)
local s = shoot 'eraser'
wait(10)
print(bullet.group().count, s.alive)
--> 1 true
fire('plain')
local s = shoot 'bolt'
wait(10)
print(bullet.group().count, s.alive)
--> 1 true

--load: what requires hp
bullet.def('a', { sprite = 'dot', hit = 'none', score = 3 })
--! bullet.def: score: requires `hp`

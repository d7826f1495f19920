-- Shots that hit bullets: those that have hp, and those that a shot cancels.
--board: hp
spark.def('ping', { sprite = 'dot', life = 300, drag = 1 })
spark.def('pong', { sprite = 'wink', life = 300 })
shot.def('bolt', { sprite = 'dot', hit = { circle = 3 }, damage = 2 })
shot.def('eraser', { sprite = 'dot', hit = { circle = 3 }, damage = 2, cancels = true })
bullet.def('plain', { sprite = 'dot', hit = { circle = 4 }, vanish = 'pong' })
bullet.def('fixed', { sprite = 'dot', hit = { circle = 4 }, clearable = false })
bullet.def('wall', { sprite = 'dot', hit = { circle = 4 }, hp = forever })
bullet.def('crate', {
    sprite = 'dot',
    hit = { circle = 4 },
    hp = 5,
    score = 70,
    spark = 'ping',
    cloud = 'dot',
    vanish = 'pong',
    on_death = function(b, p)
        assert(not b.alive and b.kind == 'crate' and b.hp == 0 and b.x == 50)
        print('destroyed by', p and p.index)
    end,
})
enemy.def('foe', { sprite = 'dot', hit = { circle = 4 }, hp = 5 })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 3 })
string.sys.join(1, 'ship')
local p = player.get(1)
local function fire(kind, y, delay) return bullet.fire { kind = kind, x = 50, y = y, speed = 0, delay = delay } end
local function shoot(kind, by) return shot.fire { kind = kind, x = 50, y = 150, speed = 10, by = by } end
local function shots() return #query.near { what = 'shot', x = 50, y = 90, radius = 999 } end

--case: a shot takes hp and is used up
local b, s = fire('crate', 100), shoot 'bolt'
wait(10)
print(b.hp, s.alive)
--> 3 false

--case: the last hp destroys, scores for the shot's player and leaves sparks
fire('crate', 100)
for i = 1, 3 do
    shoot('bolt', p)
    wait(1)
end
wait(10)
print(p.score, board.live 'sparks')
--> destroyed by 1
--> 70 12

--case: a shot of nobody scores for nobody, and the next one flies on
fire('crate', 100)
for i = 1, 3 do shoot 'bolt' end
local s = shoot 'bolt'
wait(10)
print(p.score, s.alive)
--> destroyed by nil
--> 0 true

--case: endless hp
local b = fire('wall', 100)
for i = 1, 9 do shoot 'bolt' end
wait(10)
print(b.alive, b.hp == forever, shots())
--> true true 0

--case: hp written, and changed by a change of kind
local b = fire('plain', 100)
shoot 'bolt'
wait(10)
print(b.alive, b.hp, shots())
b.hp = 2
wait(10)
shot.fire { kind = 'bolt', x = 50, y = 100, speed = 0 }
wait(1)
print(b.alive)
local c = fire('plain', 100)
c.kind = 'crate'
print(c.hp)
bullet.group().hp = 1
print(c.hp)
c.hp = forever
c.kind = 'plain'
print(c.hp)
--> true 0 1
--> false
--> 5
--> 1
--> 0

--case: clearing is not destroying
fire('crate', 100)
fire('wall', 30)
print(bullet.clear())
wait(1)
print(board.live 'sparks')
--> 2
--> 1

--each: the nearest is hit, bullet or enemy
local a, b = fire('crate', 60), fire('crate', 90)
shoot 'bolt'
wait(12)
print(a.hp, b.hp)
--> 5 3
local b, e = fire('crate', 100), enemy.spawn { kind = 'foe', x = 50, y = 80 }
shoot 'bolt'
wait(12)
print(b.hp, e.hp)
--> 3 5
local b, e = fire('crate', 80), enemy.spawn { kind = 'foe', x = 50, y = 100 }
shoot 'bolt'
wait(12)
print(b.hp, e.hp)
--> 5 3

--case: a delayed bullet lets shots pass
local b = fire('crate', 100, 40)
shoot 'bolt'
shoot 'eraser'
wait(20)
print(b.hp, shots())
wait(20)
shoot 'bolt'
wait(10)
print(b.hp)
--> 5 2
--> 3

--each: a bullet that leaves the field can be hit; its sparks are outside, too
local b = bullet.fire { kind = 'crate', x = 50, y = 360, speed = 60, dir = 90 }
b.hp = 2
shot.fire { kind = 'bolt', x = 50, y = 375, speed = 0 }
wait(1)
print(b.alive, shots())
wait(9)
print(board.live 'sparks')
--> destroyed by nil
--> false 0
--> 0
fire('crate', -55).hp = 2
shot.fire { kind = 'bolt', x = 50, y = -40, speed = 60 }
wait(10)
print(shots(), board.live 'sparks')
--> destroyed by nil
--> 0 12

--each: a shot that cancels takes one bullet without hp
fire('plain', 100)
fire('plain', 100)
shoot 'eraser'
wait(10)
print(bullet.group().count, shots(), board.live 'sparks')
--> 1 0 1
local b = fire('fixed', 100)
shoot 'eraser'
wait(10)
print(b.alive, shots())
--> true 1
local b = fire('crate', 100)
shoot 'eraser'
wait(10)
print(b.hp, shots())
--> 3 0

-- Numbers that a game declares for its bullets, shots and enemies.
--board: bullet_values=4 shot_values=4 enemy_values=1 motions=512
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })
enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })
value.def('heat', { start = 2.5 })
value.def('goal')
value.def('heat', { of = 'shot', start = -1 })
value.def('anger', { of = 'enemy' })
for _, of in ipairs { 'bullet', 'shot' } do
    value.def('a', { of = of })
    value.def('len', { of = of })
end
local function spec(t)
    t.kind, t.x, t.y, t.speed = 'dot', 50, 50, 0
    return t
end
local function fire(t) return bullet.fire(spec(t)) end
local function shoot() return shot.fire { kind = 'bolt', x = 9, y = 9, speed = 0 } end

--case: values of one thing
local b, c = fire {}, fire { goal = 7, heat = -32768 }
print(b.heat, b.goal, c.heat, c.goal)
b.heat = 1 / 65536
print(b.heat == 1 / 65536, c.heat, shoot().heat)
print(enemy.spawn({ kind = 'foe', x = 9, y = 9, anger = 32767 }).anger)
--> 2.5 0.0 -32768.0 7.0
--> true -32768.0 -1.0
--> 32767.0

--case: a group is written
local b, c, s = fire {}, fire { tag = 't' }, shoot()
bullet.group('t').goal = 3
print(b.goal, c.goal)
bullet.group().goal = 4
shot.group().heat = 6
print(b.goal, c.goal, s.heat)
--> 0.0 3.0
--> 4.0 4.0 6.0

--case: patterns take values, and `each` sees them
local sum = 0
pattern.ring(spec { n = 5, heat = 9, tag = 'r' })
pattern.ring(spec { n = 2, tag = 'r', each = function(a, i)
    a.goal = i
    bullet.fire(a)
end })
bullet.each('r', function(d) sum = sum + d.heat + 100 * d.goal end)
print(sum)
--> 350.0

--case: what has despawned has none, and the next in its slot starts anew
local b = fire { heat = 7 }
b:remove()
b.heat = 3
print(b.heat, fire({}).heat)
--> nil 2.5

--each: declarations
value.def('late')
--! value.def: can only be called while scripts load

--load: names
value.def('speed')
--! value.def: "speed" is already a property or a method of a bullet, or an argument of bullet.fire or a pattern
value.def('remove')
--! value.def: "remove" is already a property or a method of a bullet, or an argument of bullet.fire or a pattern
value.def('sweep')
--! value.def: "sweep" is already a property or a method of a bullet, or an argument of bullet.fire or a pattern
value.def('hp', { of = 'enemy' })
--! value.def: "hp" is already a property or a method of an enemy, or an argument of enemy.spawn
value.def('heat')
--! value.def: "heat" is already declared
value.def('1st')
--! value.def: name: expected a word of letters, digits and _, got "1st"

--load: numbers and columns
value.def('b', { of = 'sprite' })
--! value.def: of: expected "bullet", "shot" or "enemy", got "sprite"
value.def('b', { start = 32768 })
--! value.def: start: expected a number from -32768 to 32767, got 32768
value.def('b')
--! value.def: "b": too many values (at most 4 for a bullet)
value.def('b', { of = 'enemy' })
--! value.def: "b": too few value columns; set `values = { enemy = 2 }` in `board` in rom.lua

--each: use
bullet.fire(spec { heat = 1e9 })
--! bullet.fire: heat: expected a number from -32768 to 32767, got 1000000000.0
bullet.fire(spec { heet = 1 })
--! bullet.fire: unknown argument "heet" (did you mean "heat"?)
fire({}).heat = 'x'
--! bullet: heat: expected a number from -32768 to 32767, got "x"
print(fire({}).heet)
--! a bullet has no property "heet" (did you mean "heat"?)
print(bullet.group().heat)
--! group: heat cannot be read from a group (only `count` can)
print(shoot().goal)
--! a shot has no property "goal"

--each: names of values in motions
motion.def { { wait = 1 }, { speed = 'haet' } }
--! motion.def: step 2: speed: unknown value "haet" (did you mean "heat"?)
motion.def { { aim = 'heat' } }
--! motion.def: step 1: aim: expected true or false, got "heat"
motion.def { { dir = 'heat', over = 3 } }
--! motion.def: step 1: `dir` takes effect immediately; with `over`, use `turn`, `aim` or `home`

--case: one motion serves all bullets; a value below 1 is one frame, a thing without the value has 0
local function way() return motion.def { { speed = 'goal', over = 'goal' }, { wait = forever } } end
for i = 1, 40 do fire { goal = i / 8, motion = way(), tag = 't' .. i } end
local s = shot.fire { kind = 'bolt', x = 50, y = 50, speed = 3, motion = way() }
print(board.live 'motions')
wait(1)
print(s.speed)
for i = 1, 12 do
    bullet.each('t' .. i, function(b) assert(b.speed == i / 8) end)
end
--> 1
--> 0.0

--case: a motion with names does what one with their numbers does, in every frame
local shapes = {
    function(a, b, n) return { { turn = a, over = n }, { speed = b } } end,
    function(a, b, n) return { { speed = b, over = n }, { accel = b, over = n } } end,
    function(a, b, n) return { { dir = a, bank = n }, { wait = n }, { turn = a, speed = b } } end,
    function(a, b, n)
        return { { aim = true, home = a, over = n }, { turn = b, accel = b, speed = b, over = n } }
    end,
    function(a, b, n) return { { loop = 3, { wait = n }, { turn = a, over = n } }, { die = true } } end,
    function(a, b, n) return { fine = true, { speed = b, turn = a, over = n }, { accel = b } } end,
}
local columns = { 'x', 'y', 'dir', 'speed', 'vx', 'vy', 'bank' }
local function number(most) return math.floor(rng.number(-most, most) * 65536) / 65536 end
local function pair(i, run)
    local a, b, n = number(run % 5 == 0 and 32767 or 180), number(6), rng.int(1, 15)
    a = i == 4 and math.abs(number(180)) or a
    local launch = run % 2 == 0 and bullet.fire or shot.fire
    local t = { kind = run % 2 == 0 and 'dot' or 'bolt', x = 120, y = 150, dir = 30, speed = 1 }
    t.motion = motion.def(shapes[i](a, b, n))
    local one = launch(t)
    t.motion, t.a, t.heat, t.len = motion.def(shapes[i]('a', 'heat', 'len')), a, b, n + run % 3 / 4
    local two = launch(t)
    for frame = 1, 20 do
        wait(1)
        assert(one.alive == two.alive, i)
        for _, p in ipairs(one.alive and columns or {}) do
            assert(one[p] == two[p], ('%d %d %s: %.9f %.9f'):format(i, frame, p, one[p], two[p]))
        end
        if frame < n and i <= 2 then -- what becomes of a value in the middle of a step does not matter to that step
            two.a = frame == n - 1 and a or frame
        end
    end
    one:remove()
    two:remove()
end
for run = 1, 18 do
    local pairs_of_run = {}
    for i = 1, #shapes do pairs_of_run[i] = task.go(pair, i, run) end
    wait_for(table.unpack(pairs_of_run))
end
print(board.live('bullets'), board.live('shots'))
--> 0 0

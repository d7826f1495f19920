-- Names that do not exist and arguments in the wrong form: what the fault suggests.
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 }, cloud = 'dot' })
bullet.def('rice', { sprite = 'dot', hit = { circle = 3 } })
enemy.def('fly', { sprite = 'dot', hit = 'none', hp = 9, pictures = { hurt = 'dot' } })
local function fire() return bullet.fire { kind = 'dot', x = 9, y = 9, speed = 1 } end
local function spawn() return enemy.spawn { kind = 'fly', x = 9, y = 9 } end

--each: globals, and locals with a similar name
print(bulet)
--! undeclared global "bulet" (did you mean "bullet"?)
print(optn)
--! undeclared global "optn" (did you mean "on"?)
print(test)
--! undeclared global "test" (test is reserved for a later version)
local counter = 1
print(conter, counter)
--! undeclared global "conter" (did you mean "counter"?)
count = 0
--! undeclared global "count" (scripts cannot create globals; write "local count")
board.test = print
board.test('reserved globals are free as fields')
print(text.test)
--> reserved globals are free as fields
--> nil

--each: functions
bullet.fier {}
--! attempt to call a nil value (field 'fier') (did you mean bullet.fire or shot.fire?)
bullet.dfe() -- too many are called def
--! attempt to call a nil value (field 'dfe')
talk.sya()
--! attempt to call a nil value (field 'sya') (did you mean say?)

--each: properties
sprite.put({ sprite = 'dot', x = 1, y = 2 }).z = 4
--! a sprite has no property "z"
fire().rotation = 3
--! a bullet has no property "rotation" (did you mean "dir"?)
spawn().kill = print
--! enemy: kill is a method; call it with a colon, thing:kill(...)

--each: kinds, next to the clouds and pictures of others, which have no name
bullet.fire { kind = 'ricee', x = 1, y = 1, speed = 1 }
--! bullet.fire: unknown bullet kind "ricee" (did you mean "rice"?)
enemy.spawn { kind = 'flyy', x = 1, y = 1 }
--! enemy.spawn: unknown enemy kind "flyy" (did you mean "fly"?)

--each: words of rom.lua and of the engine
board.difficulty('esay')
--! board.difficulty: unknown difficulty "esay" (in rom.lua: normal)
board.live('bulets')
--! board.live: unknown pool "bulets" (did you mean "bullets"?)
palette.load('dusk')
--! palette.load: unknown palette "dusk" (in rom.lua: main, other)
board.ask('setings')
--! board.ask: what: expected settings, replays, practice, keys or quit, got "setings"

--load: words that one kind of thing does not take
spark.def('a', { sprite = 'dot', life = 9, layer = 'back' })
--! spark.def: layer: expected middle or front, got "back"

--each: arguments that are called otherwise elsewhere
bullet.fire { kind = 'dot', x = 1, y = 1, speed = 1, angle = 3 }
--! bullet.fire: unknown argument "angle" (did you mean "dir"?)
motion.def { { angle = 3 } }
--! motion.def: step 1: unknown argument "angle" (did you mean "dir"?)

--each: patterns take the arguments of fire, and their place is their own
pattern.ring { kind = 'dot', x = 9, y = 9, speed = 1, n = 3, delay = 3, sped = 1 }
--! pattern.ring: unknown argument "sped" (did you mean "speed"?)
pattern.ring { n = 3, kind = 'dot', speed = 1, from = nil }
--! pattern.ring: place: expected `x` and `y`, or `from` (a thing), got neither
pattern.star { n = 10, points = 5, kind = 'dot', speed = 1, x = 1, from = spawn() }
--! pattern.star: place: expected either `x` and `y`, or `from`
pattern.whip { n = 3, speed_to = 2, bend = 9, kind = 'dot', x = 1, y = 1, each = print }
--! pattern.whip: speed: expected a number of px/frame, got nil

--each: a table of named arguments, and how many others
sprite.put('dot', 10, 20)
--! sprite.put: expected a table of named arguments (sprite.put { ... }), got 3 arguments
spawn():move(9, 9, 30)
--! enemy:move: expected a table of named arguments (enemy:move { ... }), got 3 arguments
spawn():move({}, 9)
--! enemy:move: expected at most 1 argument, got 2
board.frame(3)
--! board.frame: expected no arguments, got 1

--each: lists
hud.banner('GO', 60)
--! hud.banner: lines: expected a list of strings such as { "GO" }
menu.choose { 'a', 'b' }
--! menu.choose: items: expected a list of strings, as in { items = { "Yes", "No" }, row = 12 }
choose('a', 'b')
--! choose: list: expected a list of strings, as in choose { "Yes", "No" }
say('Hello')
--! say: expected a speaker and a text; for no speaker, write say(nil, "Hello")

--each: colons
bullet.group().clear(7)
--! group:clear: call it on a thing with a colon, as in thing:name()
bullet.group().clear(spawn())
--! group:clear: self: expected group, got an enemy (call it with a colon)

--each: only what has despawned has a hint about it
local b = fire()
b:remove()
print(b.x .. '')
--! attempt to concatenate a nil value (field 'x') (x is nil once the thing has despawned; check `alive` first)
local b = fire()
local t = {}
b:remove()
local x = b.x
print(x, t.x .. '')
--! attempt to concatenate a nil value (field 'x')

--each: wait_for names the argument
wait_for(fire(), 5)
--! wait_for: argument 2: expected a task, a movement or a thing, got number
wait_for(bullet.group())
--! wait_for: argument 1: expected a task, a movement or a thing, got number

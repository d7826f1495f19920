-- Explosions: how many sparks, shakes and stops a size makes, hits by damage, the death of a boss; what fx refuses.
--board: sparks=512
spark.def('ping', { sprite = 'dot', life = 300 })
spark.def('pong', { life = 300 })
enemy.def('foe', { sprite = 'dot', hit = { circle = 4 }, hp = 90, on_hit = fx.hit })
player.def('ship', { sprite = 'dot', hit = { circle = 2 } })
fx.def('bare', {})
fx.def('both', { sparks = { { kind = { 'ping', 'pong' }, n = 3, speed = 1 }, { kind = 'ping', radius = 9, n = 2 } } })
fx.def('row', { sparks = { { kind = 'ping' } }, chain = 3, chain_size = 'both', chain_radius = 40 })
fx.def('loud', { shake = 3, flash = 0.5, flash_to = 0xff0000, stop = 4 })
fx.def('mild', { shake = 1, flash = 0.5, stop = 2 })
local function foe() return enemy.spawn { kind = 'foe', x = 60, y = 40 } end
local function sparks() return board.live 'sparks' end

--case: the sizes that every game has
for _, size in ipairs { 'small', 'medium', 'large', 'hit', 'bare' } do
  local before = sparks()
  fx.explode { x = 60, y = 40, size = size }
  print(size, sparks() - before)
end
--> small 25
--> medium 46
--> large 96
--> hit 3
--> bare 0

--case: medium is the default; a place, a thing, a distance
local before, e = sparks(), foe()
fx.explode { x = 60, y = 40 }
fx.explode { from = e, dx = 5, dy = -16383, size = 'both' }
print(sparks() - before)
--> 51

--case: a thing that has despawned has no place
local e = foe()
e:remove()
fx.explode { from = e }
print(sparks(), fx.collapse { from = e }.alive)
wait(1)
print(sparks())
--> 0 false
--> 0

--case: a chain, one explosion every 4 frames, which does not chain again
local t = board.frame()
fx.explode { x = 60, y = 40, size = 'row' }
for _ = 1, 4 do
  print(board.frame() - t, sparks())
  wait(4)
end
--> 0 1
--> 4 1
--> 8 6
--> 12 11

--case: hits by damage, at most five bursts
local e = foe()
for _, damage in ipairs { 1, 2, 3, 4, 8, 1000 } do
  local before = sparks()
  fx.hit(e, nil, damage)
  print(damage, sparks() - before)
end
e:hurt(4, player.get(1))
wait(1)
--> 1 3
--> 2 6
--> 3 6
--> 4 9
--> 8 15
--> 1000 15

--case: the longest hit-stop of a frame counts
local t = board.frame()
fx.explode { x = 60, y = 40, size = 'loud' }
fx.explode { x = 60, y = 40, size = 'mild' }
wait(1)
print(board.frame() - t)
--> 5

--case: the death of a boss
local t, put = board.frame(), board.live 'sprites'
local death = fx.collapse { x = 60, y = 40, over = 60, sprite = 'dot', bank = 2, radius = 20 }
wait(1)
print(board.live 'sprites' - put, sparks() > 0)
wait_for(death)
print(board.frame() - t, board.live 'sprites' - put)
--> 1 true
--> 73 0

--case: a stopped death takes its picture along
local put = board.live 'sprites'
local death = fx.collapse { x = 60, y = 40, sprite = 'dot' }
wait(20)
task.stop(death)
wait(1)
print(board.live 'sprites' - put)
--> 0

--each: arguments
fx.explode { size = 'small' }
--! fx.explode: place: expected `x` and `y`, or `from` (a thing)
fx.explode { x = 1, size = 'small' }
--! fx.explode: place: expected `x` and `y`, or `from` (a thing)
fx.explode { x = 1, y = 1, from = foe() }
--! fx.explode: place: expected `x` and `y`, or `from` (a thing)
fx.explode { x = 1, y = 1, size = 'meduim' }
--! fx.explode: unknown size "meduim" (did you mean "medium"?)
fx.explode { x = 1, y = 1, kind = 'small' }
--! fx.explode: unknown argument "kind" (arguments: x, y, from, dx, dy, size)
fx.collapse { x = 1, y = 1, crack = 'smal' }
--! fx.collapse: unknown size "smal" (did you mean "small"?)
fx.collapse { x = 1, y = 1, over = 601 }
--! fx.collapse: over: expected a whole number from 1 to 600 frames, got 601
fx.hit(player.get(1))
--! fx.hit: e: expected an enemy, got a player
fx.def('late', {})
--! fx.def: can only be called while scripts load

--load: declarations
fx.def('a', { sparks = { { n = 2 } } })
--! fx.def sparks: kind: expected a name, got nil
fx.def('a', { sparks = { { kind = { 'ping', 'pnog' } } } })
--! fx.def sparks: unknown spark kind "pnog" (did you mean "pong"?)
fx.def('a', { sparks = { { kind = 'ping', n = 257 } } })
--! fx.def sparks: n: expected a whole number from 0 to 256 sparks, got 257
fx.def('a', { sparks = { 'ping' } })
--! fx.def sparks: expected a table of named arguments, got "ping"
fx.def('a', { chain = 33 })
--! fx.def: chain: expected a whole number from 0 to 32 explosions, got 33
fx.def('a', { chain = 2, chain_size = 'a' })
--! fx.def: unknown size "a" (known: hit, small, medium, large, bare, both, row, loud, mild)
fx.def('a', { sound = 'none' })
--! fx.def: unknown sound "none" (declare it in rom.lua)
spark.def('ping', { life = 4 })
--! spark.def: spark kind "ping" is already declared

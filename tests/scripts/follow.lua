-- Sprites that follow an entity, and trails of sparks. test_follow.c has where sparks start.
bullet.def('b', { sprite = 'dot', hit = { circle = 3 } })
enemy.def('e', { sprite = 'dot', hit = { circle = 4 }, hp = 9 })
player.def('p', { sprite = 'dot', hit = { circle = 2 } })
spark.def('k', { sprite = 'dot', life = 12, bank = 3 })
local function foe() return enemy.spawn { kind = 'e', x = 50, y = 60 } end

--case: a sprite moves with an enemy, and ends in the frame in which that dies
local e = foe()
local s = sprite.put { sprite = 'arrow', follow = e, dx = 10, dy = -5 }
print(s.x, s.y, s.dx, s.dy)
e:move { x = 90, y = 60, over = 4 }
wait(1)
print(s.x, s.y)
s.dx, s.dy = 1, 2
wait(3)
print(s.x, s.y, bullet.fire { kind = 'b', from = s, speed = 0 }.x)
e:kill()
print(s.alive)
wait(1)
print(s.alive, s.dx, board.live 'sprites')
--> 60.0 55.0 10.0 -5.0
--> 70.0 55.0
--> 91.0 62.0 91.0
--> true
--> false nil 0

--case: with a player who leaves the game, and not at all with a dead bullet
string.sys.join(1, 'p')
local p = player.get(1)
p.x, p.y = 30, 40
local s = sprite.put { sprite = 'dot', follow = p, dy = 9 }
wait(1)
print(s.x, s.y)
string.sys.leave(1)
wait(1)
print(s.alive)
local b = bullet.fire { kind = 'b', x = 9, y = 9, speed = 2, dir = 0 }
b:remove()
print(sprite.put { sprite = 'dot', follow = b }.alive)
--> 30.0 49.0
--> false
--> false

--case: a sprite that a scene puts on a player ends with the scene
string.sys.join(1, 'p')
local scene = string.sys.scene(string.sys.scope())
task.own(scene, function()
  sprite.put { sprite = 'dot', follow = player.get(1) }
  wait(forever)
end)
wait(2)
print(board.live 'sprites')
task.stop(scene)
wait(1)
print(board.live 'sprites')
--> 1
--> 0

--case: a trail leaves a spark every few frames, until its entity ends
local e = foe()
spark.trail { kind = 'k', follow = e, every = 3 }
for _, frames in ipairs { 1, 3, 3, 3, 3, 12 } do -- each spark lives 12 frames
  wait(frames)
  print(board.live 'sparks')
end
e:remove()
wait(20)
print(board.live 'sparks')
--> 1
--> 2
--> 3
--> 4
--> 4
--> 4
--> 0

--each: arguments
sprite.put { sprite = 'dot', x = 1 }
--! sprite.put: place: expected `x` and `y`, or `follow` (a thing), got only one of `x` and `y`
sprite.put { sprite = 'dot', x = 1, y = 2, follow = player.get(1) }
--! sprite.put: place: expected `x` and `y`, or `follow` (a thing), got both
sprite.put { sprite = 'dot', x = 1, y = 2, dx = 3 }
--! sprite.put: dx, dy: require `follow`
sprite.put { sprite = 'dot', follow = player.get(1), screen = true }
--! sprite.put: `screen` cannot be combined with `follow`
sprite.put { sprite = 'dot', x = 1, y = 2 }.dx = 3
--! sprite: dx: the sprite follows nothing; set `x` and `y` instead
sprite.put { sprite = 'dot', follow = foe() }.y = 3
--! sprite: y: the sprite follows a thing; set `dx` and `dy` instead
spark.burst { kind = 'k', x = 1, y = 2, to_x = 3 }
--! spark.burst: shape: expected `radius`, or `to_x` and `to_y`, or neither
spark.burst { kind = 'k', x = 1, y = 2, to_x = 3, to_y = 4, radius = 4 }
--! spark.burst: shape: expected `radius`, or `to_x` and `to_y`, or neither
spark.trail { kind = 'k', every = 2 }
--! spark.trail: follow: expected a thing with a position, got nil

--load: arguments
spark.def('q', { sprite = 'dot', life = 5, banks = {} })
--! spark.def: banks: expected a list of 1 to 8 banks
spark.def('q', { sprite = 'dot', life = 5, banks = { 1, 16 } })
--! spark.def: banks: expected a whole number from 0 to 15, got 16
spark.def('q', { sprite = 'dot', life = 5, bank = 1, banks = { 1, 2 } })
--! spark.def: expected either `bank` or `banks`, got both

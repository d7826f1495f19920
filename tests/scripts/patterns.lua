-- What patterns refuse. tests/machine/test_patterns.c checks where each puts its bullets.
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9 })
local function ring(more)
  local a = { kind = 'dot', x = 9, y = 9, speed = 1, n = 3 }
  for k, v in pairs(more) do a[k] = v end
  return a
end

--load: skip
pattern.ring(ring { skip = 3 })
--! pattern.ring: skip: expected { first, last }, whole numbers from -65535 to 65535, got 3
pattern.ring(ring { skip = { 3 } })
--! pattern.ring: skip: expected { first, last }, whole numbers from -65535 to 65535, got nil as the last
pattern.ring(ring { skip = { 1, 2, 3 } })
--! pattern.ring: skip: expected { first, last }, whole numbers from -65535 to 65535, got 3 values
pattern.ring(ring { skip = { 1, 65536 } })
--! pattern.ring: skip: expected { first, last }, whole numbers from -65535 to 65535, got 65536 as the last
pattern.ring(ring { skip = { 5, 2 } })
--! pattern.ring: skip: first 5 is greater than last 2 (did you mean { 2, 5 }?)

--load: arguments of all patterns
pattern.ring(ring { skp = { 1, 2 } })
--! pattern.ring: unknown argument "skp" (did you mean "skip"?)
pattern.ring(ring { accel = 1 })
--! pattern.ring: unknown argument "accel" (it is a step of a motion: motion = motion.def { { accel = ... } })
pattern.ring(ring { motion = {} })
--! pattern.ring: motion: expected a motion (motion.def { ... }) or a motion name, got a table
pattern.ring(ring { motion = 3 })
--! pattern.ring: motion: expected a motion or a motion name, got 3
pattern.ring(ring { fire = 'bomb' })
--! pattern.ring: fire: expected bullet, shot, bolt, curve or beam, got "bomb"
pattern.ring(ring { fire = 'shot' })
--! pattern.ring: unknown shot kind "dot" (found bullet kind "dot")
pattern.ring(ring { by = player.get(1) })
--! pattern.ring: `by` requires a shot (did you forget `fire = "shot"`?)
pattern.line { kind = 'dot', speed = 1, n = 3, width = 9, aim = true }
--! pattern.line: place: expected `x` and `y`, or `from` (a thing), got neither

--load: arguments of one pattern
pattern.polygon(ring { n = 12, sides = 5 })
--! pattern.polygon: n: expected a multiple of 5 (the sides), got 12 (did you mean 10?)
pattern.polygon(ring { n = 1, sides = 5 })
--! pattern.polygon: n: expected a multiple of 5 (the sides), got 1 (did you mean 5?)
pattern.star(ring { n = 15, points = 5 })
--! pattern.star: n: expected a multiple of 10 (the sides), got 15 (did you mean 20?)
pattern.points { kind = 'dot', x = 9, y = 9, speed = 1, list = { { 1, 2 }, { x = 3, y = 4 } } }
--! pattern.points: point 2: expected { x, y } in px
pattern.picture { kind = 'dot', x = 9, y = 9, speed = 1, dots = '. .' }
--! pattern.picture: dots: expected at least one character other than "." and space
pattern.picture { kind = 'dot', x = 9, y = 9, speed = 1, dots = 'x\tx' }
--! pattern.picture: dots: expected rows of ASCII characters, got byte 9

--each: a thing in place of arguments
local e = enemy.spawn { kind = 'foe', x = 9, y = 9 }
pattern.ring(e)
--! pattern.ring: expected a table of named arguments, got an enemy

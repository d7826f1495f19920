-- What a game says to a setting of rom.lua that it has not got.
--load: the board has no piercing
shot.def('bolt', { sprite = 'dot', hit = { circle = 2 }, pierce = 1 })
--! shot.def: pierce: piercing is disabled; add `pierce = true` to `board` in rom.lua
shot.def('bolt', { sprite = 'dot', hit = { circle = 2 }, pierce = 0 })
print('fine')
--> fine

--load: the board has no parts of enemies
enemy.def('foe', { sprite = 'dot', hit = 'none', rate = 1 })
--! enemy.def: rate: disabled; add `bodies = true` to `board` in rom.lua
enemy.def('foe', { sprite = 'dot', hit = 'none' })
enemy.spawn({ kind = 'foe', x = 1, y = 1 }).rate = 1
--! enemy: rate is disabled; add `bodies = true` to `board` in rom.lua
enemy.def('foe', { sprite = 'dot', hit = 'none' })
enemy.spawn({ kind = 'foe', x = 1, y = 1 }):wander { w = 9, h = 9, every = 20, over = 10 }
--! enemy:wander: wander: disabled; add `bodies = true` to `board` in rom.lua

--load: the board has no transforms
enemy.def('foe', { sprite = 'dot', hit = 'none', alpha = 8 })
--! enemy.def: alpha: transforms are disabled; add `transforms = true` to `board` in rom.lua
bullet.def('b', { sprite = 'dot', hit = 'none', scale = 2 })
--! bullet.def: scale: transforms are disabled; add `transforms = true` to `board` in rom.lua
shot.def('s', { sprite = 'dot', hit = 'none', scale_hit = true })
--! shot.def: scale_hit: transforms are disabled; add `transforms = true` to `board` in rom.lua
enemy.def('foe', { sprite = 'dot', hit = 'none' })
enemy.spawn { kind = 'foe', x = 1, y = 1, dir = 0 }
--! enemy.spawn: dir: transforms are disabled; add `transforms = true` to `board` in rom.lua
enemy.def('foe', { sprite = 'dot', hit = 'none' })
print(enemy.spawn({ kind = 'foe', x = 1, y = 1 }).scale)
--! enemy: scale is disabled; add `transforms = true` to `board` in rom.lua
sprite.put { sprite = 'dot', x = 1, y = 1, turns = true }
--! sprite.put: turns: transforms are disabled; add `transforms = true` to `board` in rom.lua
sprite.put({ sprite = 'dot', x = 1, y = 1 }).alpha = 3
--! sprite: alpha is disabled; add `transforms = true` to `board` in rom.lua

--load: the board has no backgrounds, nothing for BulletML
bg.layer(1).x = 3
--! bg: backgrounds are disabled; add `maps = { ... }` in rom.lua
bullet.ml { name = 'doc' }
--! bullet.ml: BulletML is disabled; add `bulletml = 1024` to `board` in rom.lua

--load: the game has no blends
sprite.put { sprite = 'dot', x = 1, y = 1, blend = 'glow' }
--! sprite.put: unknown blend "glow" (in rom.lua: none)

--load: the board has no armour
enemy.def('e', { sprite = 'dot', hit = 'none' })
local function run() end
local phases = { { id = 'a', hp = 1, time = 1, armour = 9, run = run } }
boss.def('b', { title = 'B', kind = 'e', x = 5, y = 5, phases = phases })
--! boss.def: armour: disabled; add `bodies = true` to `board` in rom.lua

--each: the board has no lasers
laser.group()
--! laser: lasers are disabled; add `lasers = 64` to `board` in rom.lua
pattern.ring { fire = 'curve', n = 3 }
--! pattern.ring: fire: lasers are disabled; add `lasers = 64` to `board` in rom.lua

--board: lasers=8
--load: the board has lasers, but no curves
laser.def('ray', { strip = 'dot', width = 4, hit = 'none' })
laser.curve { kind = 'ray', x = 9, y = 9, speed = 1 }
--! laser.curve: curved lasers are disabled; add `curve_points = 2048` to `board` in rom.lua
pattern.ring { fire = 'curve', kind = 'ray', x = 9, y = 9, speed = 1, n = 3 }
--! pattern.ring: fire: curved lasers are disabled; add `curve_points = 2048` to `board` in rom.lua
--board: lasers=0

--load: the board has no pairs of bullets
bullet.meet('a', 'b', { clear = 'both' })
--! bullet.meet: disabled; add `meet = true` to `board` in rom.lua

--each: bullets have no `around`
motion.def { { orbit = 1, over = 4 } }
--! motion.def: step 1: `orbit` requires `at = { x, y }`; to orbit a thing, add `around = true` to `board` in rom.lua

--each: the board has no lines of text, and cells of one font
text.put { col = 2, row = 3, text = 'A', font = 'tiny' }
--! text.put: font: fonts in text cells are disabled; add `wide = true` to `board` in rom.lua
text.line { x = 1, y = 1, text = 'A' }
--! text.line: text lines are disabled; add `lines = 32` to `board` in rom.lua

--load: nothing can be frozen
bullet.group().frozen = 3
--! group: frozen is disabled; add `frozen = true` to `board` in rom.lua
enemy.def('foe', { sprite = 'dot', hit = 'none' })
print(enemy.spawn { kind = 'foe', x = 1, y = 1 }.frozen)
--! enemy: frozen is disabled; add `frozen = true` to `board` in rom.lua

--load: the board has no items
print(item)
--! item: items are disabled; add `items = 512` to `board` in rom.lua
on.take(print)
--! on.take: items are disabled; add `items = 512` to `board` in rom.lua
query.near { what = 'item', x = 9, y = 9, radius = 3 }
--! query.near: what: items are disabled; add `items = 512` to `board` in rom.lua
bullet.def('b', { sprite = 'dot', hit = 'none' })
bullet.clear { items = 'gem' }
--! bullet.clear: items: items are disabled; add `items = 512` to `board` in rom.lua
enemy.def('e', { sprite = 'dot', hit = 'none', drops = { gem = 3 } })
--! enemy.def: drops: items are disabled; add `items = 512` to `board` in rom.lua
player.def('p', { sprite = 'dot', hit = { circle = 2 }, magnet = 3 })
--! player.def: magnet: items are disabled; add `items = 512` to `board` in rom.lua

--load: the board has no hp of bullets
bullet.def('a', { sprite = 'dot', hit = 'none', hp = 3 })
--! bullet.def: hp: bullet hp is disabled; add `hp = true` to `board` in rom.lua
bullet.def('a', { sprite = 'dot', hit = 'none' })
print(bullet.fire({ kind = 'a', x = 9, y = 9, speed = 1 }).hp)
--! bullet: hp: bullet hp is disabled; add `hp = true` to `board` in rom.lua

--load: the game has no sound
sound.play('x')
--! sound: sound is disabled; add `sounds = { ... }` or `music = { ... }` in rom.lua

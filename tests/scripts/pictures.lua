-- Pictures of enemies and players: names, and what a script reads of them. test_looks.c has what is drawn.
enemy.def('e', { sprite = 'dot', hit = { circle = 4 }, hp = 99, bank = 2,
  pictures = { cast = 'arrow', hurt = 'wink', aim = 'dot' } })
enemy.def('plain', { sprite = 'dot', hit = { circles = { { -4, 0, 2 }, { 4, 0, 2 } } } })
enemy.def('brief', { sprite = 'arrow', hit = 'none', pictures = { cast = 'dot' } })
player.def('first', { sprite = 'dot', hit = { circle = 2 } })
player.def('p', { sprite = 'arrow', hit = { circle = 2 }, pictures = { right = 'dot', left = 'wink', win = 'wink' },
  registers = { n = 1 } })
player.def('half', { sprite = 'arrow', hit = { circle = 2 }, pictures = { left = 'wink' } })
local function foe(kind) return enemy.spawn { kind = kind, x = 50, y = 50 } end

--case: kinds are found by their names, whatever pictures are between them
print(table.concat(string.sys.kinds 'enemy', ' '))
print(table.concat(string.sys.kinds 'player', ' '))
string.sys.join(1, 'half')
string.sys.join(2, 'p')
print(player.get(1).kind, player.get(2).n, foe('plain').kind)
--> e plain brief
--> first p half
--> half 1 plain

--case: properties
local e = foe 'e'
print(e.picture, e.flip_x, e.hidden, e.bank)
e.picture, e.flip_x, e.hidden, e.bank = 'cast', true, true, 9
print(e.picture, e.flip_x, e.hidden, e.bank)
enemy.group().picture = 'aim'
print(e.picture)
e.picture = nil
print(e.picture, e.hidden)
e:remove()
e.picture = 'cast'
print(e.picture)
string.sys.join(1, 'p')
local p = player.get(1)
print(p.picture, p.flip_x, p.hidden)
p.picture, p.flip_x, p.hidden = 'win', true, true
print(p.picture, p.flip_x, p.hidden)
--> nil false false 2
--> cast true true 9
--> aim
--> nil true
--> nil
--> nil false false
--> win true true

--each: arguments
foe('e').picture = 'csat'
--! enemy: its kind has no picture "csat" (did you mean "cast"?)
foe('e').picture = 'zzzzzzz'
--! enemy: its kind has no picture "zzzzzzz"
foe('plain').picture = 'cast'
--! enemy: its kind has no pictures (add `pictures` to its enemy.def)

--load: arguments
enemy.def('x', { sprite = 'dot', hit = 'none', pictures = { cast = 'dott' } })
--! enemy.def: unknown sprite "dott" (did you mean "dot"?)
enemy.def('x', { sprite = 'dot', hit = 'none', pictures = { cast = 3 } })
--! enemy.def: pictures.cast: expected a sprite name, got 3
enemy.def('x', { sprite = 'dot', hit = 'none', pictures = { 'dot' } })
--! enemy.def: pictures: expected { NAME = sprite }, such as { hurt = "moth_hurt" }, got a list
local many = {}
for i = 1, 7 do many['n' .. i] = 'dot' end
enemy.def('x', { sprite = 'dot', hit = 'none', pictures = many })
--! enemy.def: pictures: too many (at most 7)
for i = 1, 30 do player.def('q' .. i, { sprite = 'dot', hit = { circle = 1 }, pictures = { a = 'dot', b = 'dot' } }) end
--! player.def: too many kinds (at most 128; each picture of a kind counts as one)

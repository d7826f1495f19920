-- Lines of text: properties, letters that come one by one, and ends. test_lines.c has what is drawn.
--board: lines=8 wide_text
bullet.def('dot', { sprite = 'dot', hit = 'none' })
enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 5 })
local kept, lost
boss.def('iris', { title = 'Iris', kind = 'foe', x = 60, y = 60, phases = {
  { id = 'a', hp = 10, time = 20, run = function()
    lost = text.line { x = 1, y = 1, text = 'lost' }
    kept = text.line { x = 1, y = 1, text = 'kept', stay = true }
  end },
  { id = 'b', hp = 10, time = 20, run = function() print(lost.alive, kept.alive) end },
} })

--case: properties
local l = text.line { x = 3.5, y = -7, text = 'été', bank = 4 }
print(l.x, l.y, l.dx, l.dy, l.bank, l.text, l.done, l.hidden)
l.text, l.x, l.dy, l.hidden, l.bank = '\233', 9, 2.25, true, 15
print(l.x, l.dy, l.bank, l.text, l.hidden)
l.text = ('弾'):rep(240)
print(#l.text)
l.text = ''
print(#l.text, l.done)
l:remove()
l.text = 'x'
print(l.alive, l.text)
print(text.line { x = 0, y = 0, text = 12 }.text)
--> 3.5 -7.0 0.0 0.0 4 été true false
--> 9.0 2.25 15 é true
--> 720
--> 0 true
--> false nil
--> 12

--case: letters come one by one, and again for another text
local l = text.line { x = 0, y = 0, text = 'abcd', letter = 3 }
wait(11)
print(l.done)
wait(1)
print(l.done)
l.text = 'ab'
wait(5)
print(l.done)
wait(1)
print(l.done)
--> false
--> true
--> false
--> true

--case: a line that follows an entity ends with it; one that was put next to it stays
local b = bullet.fire { kind = 'dot', x = 50, y = 50, dir = 0, speed = 2 }
local l = text.line { follow = b, dx = 3, dy = -4.5, text = 'x' }
print(l.x, l.y, l.dx, l.dy)
wait(5)
l.x = 7
print(l.x == b.x, l.dx)
b:remove()
wait(1)
print(l.alive, text.line { follow = b, text = 'x' }.alive, text.line { from = b, text = 'x' }.alive)
local e = enemy.spawn { kind = 'foe', x = 9, y = 9 }
l = text.line { follow = e, text = 'x' }
local k = text.line { from = e, dx = 2, text = 'x' }
e:kill()
wait(1)
print(l.alive, k.alive, k.x, k.dx)
--> 50.0 50.0 3.0 -4.5
--> true 3.0
--> false false false
--> false true 11.0 0.0

--case: the end of a phase removes its lines, but for those that stay
boss.fight 'iris'
--> false true

--each: arguments
text.line { x = 1, y = 1, text = ('x'):rep(241) }
--! text.line: text: expected at most 240 characters, got 241
text.line { x = 1, y = 1, text = 0/0 }
--! text.line: text: expected a finite number
text.line { x = 1, y = 1, text = {} }
--! text.line: text: expected a string or a number, got a table
text.line { x = 1, y = 1, text = 'a', font = 'tinny' }
--! text.line: unknown font "tinny" (did you mean "tiny"?)
local s = sprite.put { sprite = 'dot', x = 1, y = 1 }
text.line { follow = s, x = 1, text = 'a' }
--! text.line: `follow` cannot be combined with `x`, `y` or `from`
local s = sprite.put { sprite = 'dot', x = 1, y = 1 }
text.line { follow = s, screen = true, text = 'a' }
--! text.line: `screen` cannot be combined with `follow`

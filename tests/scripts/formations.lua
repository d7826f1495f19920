-- stage.wave: where the enemies of a formation are, after ten frames of a path that leads down from (100, 50).
enemy.def('foe', { sprite = 'dot', hit = 'none' })
local down = path.def { { x = 100, y = 50 }, { x = 100, y = 150, over = 100 } }
local function wave(t)
  t.kind, t.path, t.every = 'foe', down, 0
  stage.wave(t)
  wait(10)
  local places = {}
  enemy.each(nil, function(e) places[#places + 1] = ('%.2f %.2f'):format(e.x, e.y) end)
  print(table.concat(places, ', '))
end

--case: formations
wave { n = 5, formation = 'v', gap = 10 }
enemy.group():remove()
wave { n = 3, formation = 'line', gap = 10 }
enemy.group():remove()
wave { n = 2, formation = 'column' }
enemy.group():remove()
wave { n = 4, formation = 'circle', gap = 10 }
enemy.group():remove()
wave { n = 1, formation = 'circle' }
enemy.group():remove()
wave { n = 2, formation = { { 1, 2 }, { 3, 4.5 } }, dx = 5, dy = 1 }
enemy.group():remove()
wave { n = 1, formation = { { 20, 2 } }, mirror = true }
--> 100.00 60.00, 90.00 50.00, 110.00 50.00, 80.00 40.00, 120.00 40.00
--> 90.00 60.00, 100.00 60.00, 110.00 60.00
--> 100.00 60.00, 100.00 36.00
--> 100.00 67.07, 92.93 60.00, 100.00 52.93, 107.07 60.00
--> 100.00 60.00
--> 101.00 62.00, 108.00 65.50
--> 120.00 62.00

--each: arguments
stage.wave { kind = 'foe', path = down, every = 0, n = 1, formation = 'vee' }
--! stage.wave: unknown formation "vee" (known: circle, column, line, v)
stage.wave { kind = 'foe', path = down, every = 0, n = 2, formation = { { 1, 2 } } }
--! stage.wave: formation: expected 2 positions (`n`), got 1
stage.wave { kind = 'foe', path = down, every = 0, n = 1, formation = { 1 } }
--! stage.wave: formation: entry 1: expected { x, y }

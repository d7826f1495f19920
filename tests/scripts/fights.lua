-- Two fights with bosses: one after the other, and not at the same time.
enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9 })
enemy.def('thin', { sprite = 'dot', hit = { circle = 9 }, hp = 1, on_death = function() error('burst') end })
local function def(name, kind, time, run)
    local phase = { id = 'a', hp = 9, time = time, rest = 0, run = run }
    boss.def(name, { title = name, kind = kind, x = 50, y = 50, phases = { phase } })
end
def('queen', 'foe', 40, function() wait(forever) end)
def('king', 'foe', 9, function() wait(forever) end)
def('thin', 'thin', 9, function(e) e.hp = 0 end)

--each: at the same time, another one or the same one
task.go(boss.fight, 'queen')
wait(70)
boss.fight 'king'
--! boss.fight: boss "king": "queen" is still fighting; for two bosses at once, declare one with `cast = { .. }`
task.go(boss.fight, 'queen')
wait(1)
boss.fight 'queen'
--! boss.fight: boss "queen": "queen" is still fighting; for two bosses at once, declare one with `cast = { .. }`

--case: one after the other
print(boss.fight 'queen', boss.fight 'king')
--> false false

--each: after one whose task was stopped, in the same frame and later
local t = task.go(boss.fight, 'queen')
wait(70)
task.stop(t)
print(boss.fight 'king')
--> false
local t = task.go(boss.fight, 'queen')
wait(70)
task.stop(t)
wait(1)
print(boss.fight 'king')
--> false

--case: after one that an error ended
print((pcall(boss.fight, 'thin')))
print(boss.fight 'king')
--> false
--> false

--each: a task of the library that fails names the line that started it
task.go(boss.fight, 'quen')
--! boss.fight: unknown boss "quen" (did you mean "queen"?)
task.go(pattern.ring, { n = 3 })
--! pattern.ring: kind: expected a name, got nil

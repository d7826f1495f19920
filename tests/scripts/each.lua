-- Loops over things, tags, and `each` of patterns.
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9 })
local function fire(x, tag) return bullet.fire { kind = 'dot', x = x, y = 9, speed = 0, tag = tag } end

--case: a tag names some, none names all
fire(1, 't')
fire(2, 't')
fire(3)
local all, some = 0, 0
bullet.each(nil, function(b) all = all + b.x end)
bullet.each('t', function(b) some = some + b.x end)
print(all, some)
print(bullet.group().count, bullet.group('t').count)
print(bullet.clear { tag = 't' }, bullet.clear { tag = nil })
enemy.spawn { kind = 'foe', x = 9, y = 9 }
enemy.spawn { kind = 'foe', x = 9, y = 9, tag = 't' }
print(enemy.count(), enemy.count(nil), enemy.count('t'))
--> 6.0 3.0
--> 3 2
--> 2 1
--> 2 2 1

--each: functions that C calls cannot wait
fire(1)
bullet.each(nil, function() wait(1) end)
--! wait: cannot wait inside a callback from C (bullet.each, table.sort, string.gsub, <close> and the like)
table.sort({ 2, 1 }, function() wait(1) end)
--! wait: cannot wait inside a callback from C (bullet.each, table.sort, string.gsub, <close> and the like)
bullet.each(function() end)
--! bullet.each: tag: expected a string, got a function

--case: `each` of a pattern may wait
local patterns = {
    ring = {},
    fan = { spread = 30 },
    arc = { sweep = 30 },
    stack = { speed_to = 2 },
    line = { width = 30 },
    spiral = { step = 9, every = 1 },
    aimed = { every = 1 },
}
for _, name in ipairs { 'ring', 'fan', 'arc', 'stack', 'line', 'spiral', 'aimed' } do
    local t, from, sum = patterns[name], board.frame(), 0
    t.n, t.kind, t.x, t.y, t.speed = 3, 'dot', 50, 50, 1
    function t.each(a, i)
        sum = sum + i
        wait(10)
        bullet.fire(a)
    end
    pattern[name](t)
    assert(sum == 6 and bullet.group().count == 3 and board.frame() - from >= 30, name)
    bullet.group():remove()
end

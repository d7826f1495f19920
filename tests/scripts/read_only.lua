-- Writes to what is read-only beyond the properties that test_told.c tries, and reads of groups.
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
local function fire() return bullet.fire { kind = 'dot', x = 9, y = 9, speed = 1 } end

--each: alive
local b = fire()
b:remove()
b.alive = true
--! bullet: alive is read-only
task.scope().alive = false
--! task: alive is read-only
bullet.group('t').alive = false
--! a group has no property "alive"
fire().alve = false
--! a bullet has no property "alve" (did you mean "alive"?)

--each: rom
rom.title = 'x'
--! rom.title is read-only
rom.field.w = 3
--! rom.field.w is read-only

--case: groups
print(bullet.group('t').age)
--! group: age cannot be read from a group (only `count` can)

-- Things and names that are not what they seem: forged handles, things that have despawned, functions made when read.
bullet.def('dot', { sprite = 'dot', hit = 'none' })
shot.def('bolt', { sprite = 'dot', hit = 'none' })
enemy.def('foe', { sprite = 'dot', hit = { box = { 8, 8 } }, hp = 9 })
player.def('ship', { sprite = 'dot', hit = { circle = 2 } })
local sys = string.sys
local function forged(kind, generation, slot) return 1 << 62 | generation << 32 | kind << 24 | slot end
local motion_kind, player_kind = motion.def { { wait = 1 } } >> 24 & 255, player.get(1) >> 24 & 255
local function dying(on_death) return enemy.spawn { kind = 'foe', x = 90, y = 9, on_death = on_death } end

--each: forged handles
bullet.fire { kind = 'dot', x = 1, y = 1, speed = 1, motion = forged(motion_kind, 1, 30000) }
--! bullet.fire: motion: expected a motion from motion.def, got a motion
print(forged(player_kind, 1, 77).score)
shot.fire { kind = 'bolt', x = 40, y = 20, speed = 0, by = forged(player_kind, 1, 200) }
wait(3)
--> nil
print((5).x)
--! attempt to index a number value (it is not a thing)
local n = 5.5
n.x = 1
--! attempt to index a number value (it is not a thing)

--case: a player who has left has no pad and no score
sys.join(1, 'ship')
local p = player.get(1)
sys.leave(1)
local nobody = player.nearest(1, 1)
print(p.alive, p.score, pad.down('fire', p), nobody.alive, nobody.score)
score.add(50, p)
dying():kill(p)
sys.join(1, 'ship')
print(player.get(1).score)
--> false 0 false false nil
--> 0

--each: strings with zero bytes
score.enter('\0', { name = 'A', score = 1 })
--! score.enter: table: expected a string without \0, got ""
score.enter('t', { name = '\0', score = 1 })
--! score.enter: name: expected a string without \0, got ""
save.set('\0a', 1)
--! save.set: key: expected a string without \0, got ""
save.set('k', 'a\0b')
print(save.get('k') == 'a\0b')
--> true

--case: an enemy dies once, whatever its on_death does
local e = dying(function(e)
  e:kill()
  e:hurt(5)
  print('dies', e.alive, e.hp, e.y)
end)
e:kill()
print(e.alive)
dying(function(e)
  print('dies')
  e:remove()
end):hurt(1000)
--> dies false 0 9.0
--> false
--> dies

--case: functions are made when they are read, which scripts cannot tell
local near, names = query.near, {}
print(near == query.near, query.box ~= near, query.none, query[1], getmetatable(query))
for name, f in pairs(query) do
  assert(query[name] == f and type(f) == 'function')
  names[#names + 1] = name
end
table.sort(names)
print(table.concat(names, ' '))
query.own = 7
print(query.own, rng.own)
local e = dying()
print(e.kill == e.kill, e.hurt ~= e.kill, enemy.group().kill ~= e.kill)
--> true true nil nil false
--> box line near
--> 7 nil
--> true true true

-- Frames in which as much happens as ever can: the list of events has space for it.
--board: lasers=2000 items=4096 bullets=0
player.def('ship', { sprite = 'dot', hit = { circle = 3 }, graze = 16 })
item.def('heart', { sprite = 'dot', radius = 5, gives = { lives = 1, score = 1 } })
laser.def('ray', { strip = 'dot', width = 10, hit = { share = 0.5 } })
string.sys.join(1, 'ship')
string.sys.join(2, 'ship')
local a, b = player.get(1), player.get(2)

--case: every laser grazes both players
a.x, b.x = 120, 140
b.y = a.y
for _ = 1, 2000 do laser.beam { kind = 'ray', x = 130, y = 10, length = 310, hold = forever, warn = 0 } end
wait(1)
print(a.grazes, b.grazes)
--> 2000 2000

--case: every item is taken, and each gives a life
item.drop { kind = 'heart', from = a, n = 4096, speed = 0 }
wait(1)
print(item.group().count, a.lives, a.score)
--> 0 99 4096

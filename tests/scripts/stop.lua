-- board.stop: the field stands for some frames, which count only as frames.
enemy.def('foe', { sprite = 'dot', hit = 'none' })

--case: nothing moves or ages while the board is stopped
local e, start = enemy.spawn { kind = 'foe', x = 100, y = 100 }, board.frame()
e:move { x = 200, y = 100, over = 50 }
wait(1)
print(e.x, e.age)
board.stop(10)
wait(1)
print(e.x, e.age, board.frame() - start)
wait(1)
print(e.x, board.frame() - start)
--> 102.0 1
--> 104.0 2 12
--> 106.0 13

--case: of several stops the longest counts
local start = board.frame()
board.stop(3)
board.stop(9)
board.stop(4)
wait(1)
print(board.frame() - start)
--> 10

--load: it is for a run
board.stop(3)
--! board.stop: cannot be called while scripts load

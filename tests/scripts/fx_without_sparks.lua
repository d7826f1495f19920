-- Explosions in a game without sparks.
--board: sparks=0
enemy.def('foe', { sprite = 'dot', hit = { circle = 4 }, hp = 90, on_hit = fx.hit })
fx.def('own', { shake = 3, stop = 4 })

--case: they shake and stop the game
local t = board.frame()
enemy.spawn { kind = 'foe', x = 60, y = 40 }:hurt(4)
fx.explode { x = 60, y = 40, size = 'own' }
wait(1)
print(board.frame() - t)
wait_for(fx.collapse { x = 60, y = 40 })
print(board.frame() - t)
--> 5
--> 138

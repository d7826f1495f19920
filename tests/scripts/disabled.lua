-- What a game says to a setting of rom.lua that it has not got.
--load: the board has no piercing
shot.def('bolt', { sprite = 'dot', hit = { circle = 2 }, pierce = 1 })
--! shot.def: pierce: piercing is disabled; add `pierce = true` to `board` in rom.lua
shot.def('bolt', { sprite = 'dot', hit = { circle = 2 }, pierce = 0 })
print('fine')
--> fine

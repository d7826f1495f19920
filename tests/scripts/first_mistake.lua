-- Of many mistakes in one table, the fault names the first in order of their names. Lua's order differs between runs.
--board: items=8 lasers=8
player.def('ship', { sprite = 'dot', hit = { circle = 2 } })
local function twenty(t)
    for c in ('tsrqponmlkabcdefghij'):gmatch '.' do t['z' .. c] = 1 end
    return t
end

--load: unknown arguments
motion.def { twenty {} }
--! motion.def: step 1: unknown argument "za"
motion.def { twenty { [true] = 1, [print] = 1 } }
--! motion.def: step 1: expected named arguments ({ name = value }), got key true
motion.def { { wait_for = twenty {} } }
--! motion.def: step 1: wait_for: unknown argument "za" (arguments: x, y, near, tag, limit)
bullet.def('x', twenty {})
--! bullet.def: unknown argument "za"
bullet.def('x', { sprite = 'dot', hit = 'none', ['bank\0'] = 3 })
--! bullet.def: unknown argument "bank" (did you mean "bank"?)

--load: tables in arguments
laser.def('x', { strip = 'dot', width = 1, hit = twenty {} })
--! laser.def: hit: expected { share = s }, s from 0 to 1, or "none", got a table with key "za"
player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { zc = {}, za = -1, zb = -1, ze = '', zf = '' } })
--! player.def: registers.za: expected a whole number from 0 to 2147483647, got -1
enemy.def('x', { sprite = 'dot', hit = 'none', pictures = { ze = 1, zd = 1, zc = 1, zb = 1, za = 1 } })
--! enemy.def: pictures.za: expected a sprite name, got 1
enemy.def('x', { sprite = 'dot', hit = 'none', drops = twenty {} })
--! enemy.def: drops: expected at most 18 names, got 20
item.def('x', { sprite = 'dot', radius = 1, gives = { ze = '', zd = '', zc = '', zb = '', za = '' } })
--! item.def: gives.za: expected a whole number from -2147483647 to 2147483647, got ""
score.rule { name = 'x', gain = { ze = '', zd = '', zc = '', zb = '', za = '' } }
--! score.rule: gain: expected { REGISTER = n, .. }, whole numbers, got ""

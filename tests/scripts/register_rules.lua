-- The rules of a register that a ship declares.
--load: arguments
player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = { a = { strat = 3 } } })
--! player.def: registers.a: unknown argument "strat" (did you mean "start"?)
player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = { a = { start = 3, max = 2 } } })
--! player.def: registers.a: start 3 is greater than max 2
player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = { a = { start = -1 } } })
--! player.def: registers.a: start -1 is less than min 0
player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = { a = { at = 'left' } } })
--! player.def: registers.a.at: expected top or low, got "left"
player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = { a = { show = 'bar' } } })
--! player.def: registers.a: `show = "bar"` requires `max`
player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = { x = 1 } })
--! player.def: registers: "x" is already a property of players

-- What scripts are told about wrong arguments for backgrounds.
--board: backgrounds
bg.def('day', print)
--load: arguments
bg.layer(1).map = 'see'
--! layer: unknown map "see" (in rom.lua: none)
bg.layer(1).layer = 'middle'
--! layer: layer: expected back or front, got "middle"
bg.plane().wrap = true
--! a plane has no property "wrap" (did you mean "map"?)
bg.plane().fog = { two = 3 }
--! plane: fog: unknown argument "two" (did you mean "to"?)
bg.plane().fog = { to = 3 }
--! plane: fog: far: expected a number from 1 to 16383 px, got nil
bg.plane().fog = { to = 'blue', far = 3 }
--! plane: fog: to: expected a colour from 0x000000 to 0xffffff, got "blue"
bg.lines(1, { wav = 3, every = 9 })
--! bg.lines: unknown argument "wav" (did you mean "wave"?)
bg.lines(1, { 1, 'x' })
--! bg.lines: line 2: expected a number from -16383 to 16383 px, got "x"
bg.show('night')
--! bg.show: unknown background "night" (known: day)

-- Registers and the score of a player end at 0.
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = { power = 3 } })
string.sys.join(1, 'ship')
local p = player.get(1)

--case: what would be below 0 is 0
p.power = -5
print(p.power)
p.power = 2
p.power = p.power - 3.0
print(p.power)
p.power = math.mininteger
print(p.power)
p.power = 2147483647
print(p.power)
--> 0
--> 0
--> 0
--> 2147483647

--case: the score, too
score.add(-5, p)
print(p.score)
score.add(3, p)
score.add(-9, p)
print(p.score)
--> 0
--> 0

--each: other numbers
p.power = -2.5
--! player: power: expected a whole number from 0 to 2147483647, got -2.5
p.power = 2147483648
--! player: power: expected a whole number from 0 to 2147483647, got 2147483648
p.lives = -1
--! player: lives: expected a whole number from 0 to 99, got -1

--load: at first
player.def('a', { sprite = 'dot', hit = { circle = 1 }, registers = { power = -1 } })
--! player.def: registers.power: expected a whole number from 0 to 2147483647, got -1

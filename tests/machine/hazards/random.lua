-- stock: distinct
-- board: fault main.lua:3: attempt to call a nil value (field 'random')
print(math.random(1 << 40))

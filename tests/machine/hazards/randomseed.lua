-- stock: distinct
-- board: fault main.lua:3: attempt to call a nil value (field 'randomseed')
print(math.randomseed())

-- stock: address
-- board: fault main.lua:3: invalid conversion '%p' to 'format'
print(("%p"):format({}))

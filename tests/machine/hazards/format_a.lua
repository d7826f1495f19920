-- stock: text 0x1.8p+0
-- board: fault main.lua:3: invalid conversion '%a' to 'format'
print(("%a"):format(1.5))

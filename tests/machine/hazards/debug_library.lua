-- stock: address
-- board: fault main.lua:3: undeclared global "debug"
print(debug.getregistry()[1])

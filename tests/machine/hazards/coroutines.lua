-- stock: address
-- board: fault main.lua:3: undeclared global "coroutine"
print(coroutine.running())

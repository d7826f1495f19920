-- stock: distinct
-- board: fault main.lua:3: undeclared global "os"
print(os.time(), os.clock(), os.tmpname())

-- stock: address
-- board: fault main.lua:3: undeclared global "io"
print(io.stdout)

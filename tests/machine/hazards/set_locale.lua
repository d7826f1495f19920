-- stock: text de_DE
-- board: fault main.lua:3: undeclared global "os"
print(os.setlocale("de_DE.UTF-8"))

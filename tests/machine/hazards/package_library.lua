-- stock: distinct with LUA_PATH=./?.lua
-- board: fault main.lua:3: undeclared global "package"
print(package.path)

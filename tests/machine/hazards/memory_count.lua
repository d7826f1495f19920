-- stock: distinct with LUA_PATH=./a/rather/long/path/?.lua
-- board: fault main.lua:3: undeclared global "collectgarbage"
print(collectgarbage("count"))

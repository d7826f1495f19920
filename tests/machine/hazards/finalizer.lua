-- stock: distinct with LUA_PATH=./a/rather/long/path/that/changes/when/the/collector/comes/round/?.lua
-- board: refused main.lua:4: __gc is not available (finalizers run at different times on different machines)
local n, at = 0, {}
local function note(self) at[#at + 1] = n setmetatable({}, getmetatable(self)) end local m = { __gc = note }
setmetatable({}, m)
for i = 1, 200000 do n = i local t = { i } end
print(table.concat(at, " "))

-- stock: distinct with LUA_PATH=./a/rather/long/path/that/changes/when/the/collector/comes/round/?.lua
-- board: refused main.lua:3: __mode is not available (weak tables hold different entries on different machines)
local weak, at = setmetatable({}, { __mode = "v" }), {}
for i = 1, 200000 do
  if not weak[1] then at[#at + 1] = i end
  weak[1] = weak[1] or { i }
  local t = { i }
end
print(table.concat(at, " "))

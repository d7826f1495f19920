-- stock: distinct
-- board: fault main.lua:5: undeclared global "next"
local t = {}
for i = 1, 40 do t["key" .. i * 7] = i end
print((next(t)))

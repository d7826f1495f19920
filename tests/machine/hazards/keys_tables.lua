-- stock: distinct
-- board: fault main.lua:5: pairs: keys of type table have no fixed order
local t, out = {}, {}
for i = 1, 40 do t[{}] = i end
for _, v in pairs(t) do out[#out + 1] = v end
print(table.concat(out, " "))

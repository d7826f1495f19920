-- stock: distinct
-- board: same
local t, out = {}, {}
for i = 1, 40 do t["key" .. i * 7] = i end
for k in pairs(t) do out[#out + 1] = k end
print(table.concat(out, " "))

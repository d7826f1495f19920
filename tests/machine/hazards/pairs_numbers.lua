-- stock: same
-- board: same
local t, out = { 3, 1, 2 }, {}
t[40], t[-7], t[1 << 40] = 1, 2, 3
for k in pairs(t) do out[#out + 1] = k end
print(table.concat(out, " "))

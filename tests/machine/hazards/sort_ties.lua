-- stock: same
-- board: same
local t, out = {}, {}
for i = 1, 40 do t[i] = { key = i % 3, id = i } end
table.sort(t, function(a, b) return a.key < b.key end)
for i = 1, #t do out[i] = t[i].id end
print(table.concat(out, " "))

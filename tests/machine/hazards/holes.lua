-- stock: same
-- board: same as stock
local f = { 1, 2, 3, 4 }
for i = 5, 9 do f[i] = i end
for i = 5, 9 do f[i] = nil end
print(#{ 1, 2, nil, 4 }, #{ nil, nil, 3 }, #f, table.pack(nil, nil).n, select("#", nil, nil))

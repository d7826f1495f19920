-- stock: text invalid order function
-- board: same
local t = {}
for i = 1, 100 do t[i] = i * 7919 % 101 end
table.sort(t, function() return true end)
print(#t)

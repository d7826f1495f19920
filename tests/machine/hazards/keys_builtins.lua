-- stock: distinct
-- board: fault main.lua:4: pairs: keys of type function have no fixed order
local t, out = { [print] = "out", [math.abs] = "abs", [string.rep] = "rep", [table.sort] = "sort", [type] = "type" }, {}
for _, v in pairs(t) do out[#out + 1] = v end
print(table.concat(out, " "))

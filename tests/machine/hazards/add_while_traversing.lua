-- stock: distinct
-- board: same
local t, out = { a = 1, b = 2, c = 3 }, {}
for k in pairs(t) do
  if #out < 200 then
    out[#out + 1] = k
    t[k .. #out] = true
  end
end
print(#out, table.concat(out, " "))

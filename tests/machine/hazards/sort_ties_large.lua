-- stock: distinct
-- board: same
-- McIlroy's adversary makes stock sort choose pivots by the clock; the ties then tell which.
local n, solid, pivot, value, index = 2000, 0, 0, {}, {}
for i = 1, n do value[i], index[i] = n, i end
table.sort(index, function(a, b)
  if value[a] == n and value[b] == n then
    value[a == pivot and a or b] = solid
    solid = solid + 1
  end
  if value[a] == n then pivot = a elseif value[b] == n then pivot = b end
  return value[a] < value[b]
end)
local list, digest = {}, 0
for i = 1, n do list[i] = { key = value[i] // 3, id = i } end
table.sort(list, function(a, b) return a.key < b.key end)
for i = 1, n do digest = (digest * 31 + list[i].id) & 0xffffffffffff end
print(digest)

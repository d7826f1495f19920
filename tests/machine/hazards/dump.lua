-- stock: crash
-- board: fault main.lua:3: attempt to call a nil value (field 'dump')
local code = string.dump(function(a, b) local t = { a, b } return t[1] + t.x end, true)
for i = 13, #code do
  local f = load(code:sub(1, i - 1) .. "\xff" .. code:sub(i + 1), "x", "b")
  if f then pcall(f, 1, 2) end
end

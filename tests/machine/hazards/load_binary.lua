-- stock: text bad binary format (truncated chunk)
-- board: same
print(load("\27Lua"))
print(load("\27LuaS\0", "x", "b"))
print(load(function() return nil end, "x", "b"))

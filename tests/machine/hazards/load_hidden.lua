-- stock: text function: 0x
-- board: same
print(load("return 2 " .. "\94 2"))
print(load("return '__" .. "gc'"))
print(load(function() return nil end))

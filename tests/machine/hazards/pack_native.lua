-- stock: native
-- board: fault main.lua:3: attempt to call a nil value (field 'pack')
print(#string.pack("l", 1))

-- stock: text 2.6390158215458
-- board: fault main.lua:4: attempt to call a nil value (field '__pow')
local m = getmetatable("")
print(m.__pow("2", "1.4"))

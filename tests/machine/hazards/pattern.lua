-- stock: hang
-- board: fault main.lua:3: infinite loop: more than 50000000 instructions in one frame
print(("a"):rep(400):find((".-"):rep(5) .. "b"))

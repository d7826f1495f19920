-- stock: hang
-- board: fault main.lua:3: infinite loop: more than 50000000 instructions in one frame
table.move({}, 1, 1 << 40, 2)

-- stock: same
-- board: same as stock
print(7 // 2, -7 // 2, 7 % -3, -7 % 3, 7.5 // 2, -7.5 % 2, math.mininteger // -1, math.mininteger % -1, 3 / 2 * 2)
print(1.0 // 0 == math.huge, -1.0 % math.huge, 0.0 // 1)
print("10" + 1, "0x10" * 2, tonumber("0x1p4"), tonumber("9223372036854775808"), math.tointeger("8"), 1e15, 1e100, 0.1)
print(math.maxinteger + 1 == math.mininteger, 1 < 1.5, math.ult(1, -1), 5 // 0.3, 5 % 0.3, math.fmod(-5, 3))

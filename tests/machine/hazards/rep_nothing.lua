-- stock: hang
-- board: same
print(#(""):rep(1 << 40))

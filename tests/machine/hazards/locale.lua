-- stock: distinct in de_DE
-- board: same
print(1.5, ("%.2f"):format(1.5), tonumber("1.5"), tonumber("1,5"), "a" < "B", ("\xe4"):upper() == "\xc4")

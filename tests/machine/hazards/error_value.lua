-- stock: address
-- board: same
print(pcall(error, {}))
print(pcall(error, setmetatable({}, { __name = "thing" })))

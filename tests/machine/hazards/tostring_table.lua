-- stock: address
-- board: same
print({}, print, tostring(function() end), ("%s"):format({}), setmetatable({}, { __name = "thing" }))

-- stock: text -nan
-- board: same
print(0 / 0, -(0 / 0), ("%f %g %.3e"):format(0 / 0, -(0 / 0), 0 / 0), 1 / 0, -1 / 0, math.huge, 2.0 * (1 << 53))

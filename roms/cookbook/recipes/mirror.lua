-- mirror.lua - Mirror: A pattern and its mirror image are fired together. The pattern calls the
-- function `each` for every bullet, and that function fires the bullet twice.
local function both(a)
  bullet.fire(a)
  a.x, a.dir, a.bank = 240 - a.x, 180 - a.dir, 7
  bullet.fire(a)
end

return function()
  for k = 0, forever do
    local x = 60 + 44 * angle.sin(1.5 * k)
    pattern.fan { x = x, y = 50 + 20 * angle.cos(3 * k), kind = "petal", bank = 5, n = 5,
                  spread = 150, dir = 90 + 70 * angle.cos(2 * k),
                  speed = 1.7, each = both }
    wait(7)
  end
end

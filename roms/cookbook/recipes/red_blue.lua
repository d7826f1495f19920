-- red_blue.lua - Red cancels blue: Bullets with different tags cancel each other when they meet.
-- Two fountains cover the field; a calm line forms between them and moves towards the weaker one.
bullet.meet("red", "blue", { clear = "both", spark = "glint" })

return function()
  for k = 0, forever do
    local swing = 50 * angle.sin(3 * k)
    pattern.ring { x = 50, y = 70, kind = "orb", bank = 1, tag = "red", n = 20 + 6 * (k % 2),
                   dir = 5 * k, speed = 1.5 }
    pattern.ring { x = 190, y = 70 + swing, kind = "orb", bank = 6, tag = "blue",
                   n = 20 + 6 * ((k + 1) % 2), dir = 180 - 5 * k, speed = 1.5 }
    wait(32)
  end
end

-- lanterns.lua - Lanterns to shoot: Lanterns have hp, stop shots, and burst into an aimed ring when
-- shot down; otherwise they only drift. The player decides when and where they burst.
local function burst(b)
  pattern.ring { kind = "rice", bank = 3, x = b.x, y = b.y, n = 14, aim = true, speed = 1.5 }
end

bullet.def("lantern", { sprite = "big", hit = { circle = 9 }, bank = 2, hp = 10, score = 300,
                        spark = "glint", on_death = burst })

local function run(e)
  for k = 0, forever do
    pattern.fan { from = e, kind = "lantern", n = 4, spread = 100, dir = 90 + 12 * (k % 3 - 1),
                  speed = 0.9 }
    wait(90)
  end
end

return { run = run, ship = "gun" }

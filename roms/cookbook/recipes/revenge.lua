-- revenge.lua - Revenge bullets: A wisp that is shot down fires an aimed fan, unless it dies close
-- to the ship, so courage pays. The kind's on_death fires the fan, and a query checks the distance.
enemy.def("avenger", { sprite = "wisp", hit = { box = { 16, 16 } }, hp = 4, score = 100,
                       spark = "glint", bank = 1,
  on_death = function(e)
    if #query.near { what = "player", x = e.x, y = e.y, radius = 80 } > 0 then return end
    pattern.fan { kind = "rice", bank = 1, x = e.x, y = e.y, n = 5, spread = 50, aim = true,
                  speed = 2 }
  end })
local swoop = path.def { { x = -12, y = 40 }, { x = 120, y = 150, over = 90, ease = "out" },
                         { x = 252, y = 30, over = 90, ease = "in" } }

local function run()
  for k = 0, forever do
    stage.wave { kind = "avenger", n = 7, every = 12, path = swoop, mirror = k % 2 == 1 }
    wait(110)
  end
end

return { run = run, ship = "gun", alone = true }

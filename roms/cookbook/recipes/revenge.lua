-- revenge.lua - Revenge bullets: a wisp that is shot down near the player answers with an aimed fan; far away it does not.
-- on_death belongs to the kind, and the distance is asked with a query.
enemy.def("avenger", { sprite = "wisp", hit = { box = { 16, 16 } }, hp = 4, score = 100, spark = "glint", bank = 1,
  on_death = function(e, p)
    if not p or #query.near { what = "player", from = e, radius = 70 } > 0 then return end
    pattern.fan { kind = "rice", bank = 1, x = e.x, y = e.y, n = 3, spread = 20, aim = true, speed = 2 }
  end })
local swoop = path.def { { x = -12, y = 40 }, { x = 120, y = 130, over = 90, ease = "out" }, { x = 252, y = 30, over = 90, ease = "in" } }

local function run()
  for k = 0, forever do
    stage.wave { kind = "avenger", n = 6, every = 14, path = swoop, mirror = k % 2 == 1 }
    wait(150)
  end
end

return { run = run, ship = "gun", alone = true }

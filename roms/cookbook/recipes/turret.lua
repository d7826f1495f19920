-- turret.lua - Turning turrets: Each pike turns its head towards the player by at most two degrees
-- per frame and fires where it looks, so a fast ship stays out of its line. `dir` turns a picture
-- that has `rotations`; the pike's picture looks down, which is 90 degrees.
enemy.def("pike", { sprite = "pike", hit = { circle = 10 }, hp = 30, score = 500, spark = "glint",
                    blink = 4, run = function(e)
  local look, n = 90, 0
  while true do
    local off = angle.difference(look, angle.to(e, player.nearest(e.x, e.y)))
    look = look + math.max(-2, math.min(2, off))
    e.dir = look - 90
    n = n + 1
    if n % 40 < 16 and n % 4 == 0 then
      bullet.fire { kind = "rice", bank = 5, speed = 2.6, dir = look,
                    x = e.x + 14 * angle.cos(look), y = e.y + 14 * angle.sin(look) }
    end
    wait(1)
  end
end })

local function run()
  local pikes = {}
  for i = 1, 4 do
    pikes[i] = enemy.spawn { kind = "pike", x = 48 * i, y = i % 3 == 1 and 60 or 100 }
  end
  for k = 0, forever do
    for i, e in ipairs(pikes) do
      if e.alive then
        e:move { x = k % 2 == 0 and 240 - 48 * i or 48 * i, y = e.y, over = 150, ease = "both" }
      end
    end
    wait(170)
  end
end

return { run = run, ship = "gun", alone = true }

-- formation.lua - Formation: Seven wisps fly in a V. Both wings use the same path, but one wing
-- mirrors it. The wisps fire where the path pauses.
local dive = path.def { { x = 120, y = -20 }, { x = 120, y = 90, over = 70, ease = "out" },
                        { wait = 50 }, { x = 120, y = -40, over = 80, ease = "in" } }

local function fire(me)
  wait(80)
  pattern.fan { from = me, kind = "orb", bank = 5, n = 3, spread = 36, aim = true, speed = 1.9 }
end

local function run()
  while true do
    enemy.spawn { kind = "wisp", path = dive, run = fire }
    for i = 1, 3 do
      enemy.spawn { kind = "wisp", path = dive, dx = 30 * i, dy = -16 * i, run = fire }
      enemy.spawn { kind = "wisp", path = dive, dx = 30 * i, dy = -16 * i, mirror = true,
                    run = fire }
    end
    wait(210)
  end
end

return { run = run, ship = "gun", alone = true }

-- homing_shot.lua - Homing shots: Fangs fly out to both sides, then turn towards the nearest enemy
-- by up to six degrees per frame. In a shot's motion program, `home` seeks enemies; in a bullet's,
-- it seeks players.
shot.def("fang", { sprite = "fang", hit = { circle = 4 }, damage = 1, turns = true, bank = 4 })
local seek = motion.def { { speed = 4, over = 10 }, { home = 6, speed = 7, over = 50 } }

player.def("hunter", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then
      for side = -1, 1, 2 do
        shot.fire { kind = "fang", from = p, dx = 10 * side, dir = 270 + 55 * side, speed = 7,
                    motion = seek }
      end
    end
    wait(7)
  end
end })

local function run()
  for k = 0, forever do
    enemy.spawn { kind = "wisp", x = 30 + 71 * k % 180, y = 40 + 37 * k % 90 }
    wait(40)
  end
end

return { run = run, ship = "hunter", alone = true }

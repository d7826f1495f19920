-- familiars.lua - Familiars: Six bullets orbit their owner at a pulsing distance and fire outwards.
-- Each has its own task, which ends when the bullet dies. All six die when the owner dies.
local round = motion.def { { orbit = 0, radius_to = 46, spin = 2, over = 40 },
  { loop = 99, { orbit = 46, radius_to = 26, spin = 2, over = 60 },
    { orbit = 26, radius_to = 46, spin = 2, over = 60 } }, { die = true } }

local function fire(me, owner)
  while true do
    wait(9)
    bullet.fire { kind = "petal", from = me, bank = 7, dir = angle.to(owner, me) + 30, speed = 1.6 }
  end
end

return function(e)
  for i = 1, 6 do
    local b = bullet.fire { kind = "big", bank = 6, from = e, dir = 60 * i, speed = 0, around = e,
                            motion = round }
    task.own(b, fire, e)
  end
  while true do
    wait(110)
    pattern.fan { from = e, kind = "star", bank = 3, n = 5, spread = 60, aim = true, speed = 2 }
  end
end

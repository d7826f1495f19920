-- escorts.lua - Escorts: Wisps circle a jelly that wanders at random in a box. They spiral out to
-- their orbits, follow the jelly as it moves, and fire outwards one after another.
local function escort(me, around, i)
  wait_for(me:orbit { around = around, radius = 20, radius_to = 48, spin = 2.4, dir = 90 * i,
                      over = 60 })
  me:orbit { around = around, radius = 48, spin = 2.4 }
  wait(10 * i)
  while me.alive do
    pattern.fan { from = me, kind = "petal", bank = 4, n = 3, spread = 40,
                  dir = angle.to(around, me),
                  speed = 1.6 }
    wait(40)
  end
end

local function run(e)
  e:wander { x = 120, y = 90, w = 120, h = 60, every = 70, over = 60 }
  for i = 1, 4 do
    task.own(enemy.spawn { kind = "wisp", from = e, hp = 60 }, escort, e, i)
  end
end

return { run = run, ship = "gun" }

-- reflect.lua - Reflection: Pressing fire opens a bubble for a third of a
-- second. Each bullet in it is replaced by a shot flying the opposite
-- way.
shot.def("returned", { sprite = "orb", hit = { circle = 4 }, damage = 1, bank = 4 })

local function parry(p)
  local bubble = sprite.put { sprite = "bubble", follow = p, bank = 4, scale = 2 }
  for _ = 1, 20 do
    for _, b in ipairs(query.near { what = "bullet", from = p, radius = 26 }) do
      shot.fire { kind = "returned", x = b.x, y = b.y, dir = b.dir + 180, speed = b.speed + 3,
                  by = p }
      b:clear { spark = "glint" }
    end
    wait(1)
  end
  bubble:remove()
end

player.def("mirror_ship", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then parry(p) end
    wait(20)
  end
end })

local function run(e)
  while true do
    pattern.fan { from = e, kind = "orb", bank = 1, n = 9, spread = 60, aim = true, speed = 2.6 }
    wait(18)
  end
end

return { run = run, ship = "mirror_ship" }

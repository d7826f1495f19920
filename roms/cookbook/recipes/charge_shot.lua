-- charge_shot.lua - Charge shot: Hold fire to charge: sparks gather and an orb grows. Release the
-- button to shoot. Each of the three strengths is a shot kind, and a full charge also clears
-- bullets.
local names, damage = { "shot_small", "shot_middle", "shot_full" }, { 4, 12, 40 }
for i, name in ipairs(names) do
  shot.def(name, { sprite = ({ "orb", "big", "bubble_200" })[i], hit = { circle = 5 * i },
                   damage = damage[i], bank = 3 + i, cancels = i == 3 })
end

player.def("charger", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    wait_until(function() return pad.down("fire", p) end)
    local held, orb = 0, sprite.put { sprite = "orb", follow = p, dy = -24, bank = 4 }
    while pad.down("fire", p) and held < 90 do
      held = held + 1
      if held % 3 == 0 then spark.burst { kind = "glint", from = p, dy = -24, n = 2, speed = 1 } end
      if held == 40 then orb.sprite, orb.bank = "big", 5 end
      wait(1)
    end
    orb:remove()
    shot.fire { kind = names[1 + held // 45], from = p, dy = -24, speed = 7 }
    wait(12)
  end
end })

local function run(e)
  for k = 0, forever do
    pattern.ring { from = e, kind = "orb", bank = 1, n = 20, dir = 9 * k, speed = 1 }
    wait(34)
  end
end

return { run = run, ship = "charger" }

-- charge_shot.lua - Charge shot: Hold fire to charge: sparks gather and an orb grows. Release the
-- button to shoot. Each of the three strengths is a shot kind with its own `scale`, and a full
-- charge also clears bullets.
local names, damage = { "shot_small", "shot_middle", "shot_full" }, { 4, 12, 40 }
for i, name in ipairs(names) do
  shot.def(name, { sprite = i == 3 and "bubble" or "big", hit = { circle = 8 },
                   scale = 0.5 + (i - 1) * 0.75,
                   scale_hit = true, damage = damage[i], bank = 3 + i, cancels = i == 3 })
end

player.def("charger", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    wait_until(function() return pad.down("fire", p) end)
    local held, orb = 0, sprite.put { sprite = "big", follow = p, dy = -24, bank = 4, scale = 0.25 }
    while pad.down("fire", p) and held < 90 do
      held = held + 1
      if held % 3 == 0 then spark.burst { kind = "glint", from = p, dy = -24, n = 2, speed = 1 } end
      orb.scale = 0.25 + held // 10 / 8
      if held == 45 then orb.bank = 5 end
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

-- spread_shot.lua - Spread shot: The ship fires seven darts in a wide fan, or three close together
-- while focus is held. With `fire = "shot"`, any pattern fires shots; `by` sets their owner.
player.def("fan", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then
      pattern.fan { fire = "shot", from = p, dy = -12, kind = "dart", n = p.focus and 3 or 7,
                    spread = p.focus and 6 or 56,
                    speed = p.focus and 11 or 8, by = p }
    end
    wait(6)
  end
end })

local function run(e)
  for k = 0, forever do
    wait_for(e:move { x = 120 + 70 * angle.sin(90 * k), y = 70 + 20 * (k % 2), over = 60,
                      ease = "both" })
  end
end

return { run = run, ship = "fan" }

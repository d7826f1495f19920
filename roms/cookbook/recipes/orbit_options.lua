-- orbit_options.lua - Option wheel: Six options circle the ship, more closely while focus is held.
-- Each fires away from the ship, so the wheel guards every side.
option.def("wheel", { sprite = "bead", bank = 3, run = function(o)
  while true do
    if pad.down("fire", o.by) then
      shot.fire { kind = "dart", from = o, dir = angle.to(o.by, o), speed = 6, bank = 2 }
    end
    wait(8)
  end
end })

player.def("wheel_ship", { sprite = "ship", hit = { circle = 2 },
  options = { kind = "wheel", style = "orbit", radius = 42, close = 22, spin = 3,
              levels = { { n = 6 } } } })

local function run(_, p)
  for k = 0, forever do
    local a = 137.5 * k
    enemy.spawn { kind = "wisp", x = 120 + 130 * angle.cos(a), y = 180 + 130 * angle.sin(a),
                  run = function(e) e:move { x = p.x, y = p.y, over = 200 } end }
    wait(20)
  end
end

return { run = run, ship = "wheel_ship", alone = true }

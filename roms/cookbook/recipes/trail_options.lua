-- trail_options.lua - Trailing options: Four options follow the ship's path, nine frames apart, and
-- stop when it stops. Each option fires at its own angle, so the ship's path shapes the shot
-- pattern.
option.def("tail", { sprite = "bead", bank = 4, run = function(o)
  while true do
    if pad.down("fire", o.by) then
      shot.fire { kind = "dart", from = o, dir = 255 + 10 * (o.index - 1), speed = 8, bank = 4 }
    end
    wait(7)
  end
end })

player.def("comet_ship", { sprite = "ship", hit = { circle = 2 },
  options = { kind = "tail", style = "trail", apart = 9, levels = { { n = 4 } } } })

local function run(e)
  for k = 0, forever do
    wait_for(e:move { x = 120 + 70 * angle.sin(90 * k), y = 80, over = 60, ease = "both" })
  end
end

return { run = run, ship = "comet_ship" }

-- spread_shot.lua - A spread shot: five darts in a fan, two while focus is held, closer and faster. fire = "shot" makes
-- every pattern a pattern of shots; by says whose they are.
player.def("fan", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    if pad.down("fire", p) then
      pattern.fan { fire = "shot", from = p, dy = -12, kind = "dart", n = p.focus and 3 or 7, spread = p.focus and 6 or 56,
                    speed = p.focus and 11 or 8, by = p }
    end
    wait(6)
  end
end })

return { run = function(e) e.safe = forever end, ship = "fan" }

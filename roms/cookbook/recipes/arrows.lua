-- arrows.lua - Arrows: A list of points makes any formation, and `turns = true` turns it to face
-- its direction of flight. Of three arrows fired one after another, the second is aimed at the
-- player.
local head = { { 0, 0 }, { -9, 7 }, { -9, -7 }, { -18, 14 }, { -18, -14 }, { -14, 0 }, { -26, 0 },
               { -38, 0 } }

return function(e)
  while true do
    for i = -1, 1 do
      pattern.points { from = e, kind = "orb", bank = 2 + i, list = head, turns = true, aim = true,
                       dir = 24 * i, speed = 2.2 }
      wait(22)
    end
    wait(36)
  end
end

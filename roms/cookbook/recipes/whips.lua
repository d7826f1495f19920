-- whips.lua - Whips: Curved lines of bullets lash out from the left and the right, aimed at the
-- player. The slow bullets of a whip are its handle and the fast ones its tip, so the whip cracks
-- on arrival.
return function(e)
  for k = 0, forever do
    local side = k % 2 == 0 and 1 or -1
    for i = 0, 2 do
      pattern.whip { from = e, dx = -40 * side, kind = "rice", bank = 2 + k % 2 * 3, n = 18,
                     speed = 0.9, speed_to = 3.2,
                     dir = (12 * i - 60) * side, bend = 80 * side, aim = true }
      wait(8)
    end
    wait(46)
  end
end

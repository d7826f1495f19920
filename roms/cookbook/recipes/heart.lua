-- heart.lua - A heart: rows of signs, a bullet each. It pulses as its bullets are told to stand and
-- go by their tag, all with one line each.
local heart = [[
  .##...##.
  ####.####
  #########
  #########
  .#######.
  ..#####..
  ...###...
  ....#....
]]

return function(e)
  for k = 1, forever do
    pattern.picture { from = e, kind = "orb", bank = 1, gap = 11, dots = heart, aim = true,
                      speed = 1.3, tag = "heart" .. k % 4 }
    for _ = 1, 3 do
      wait(24)
      bullet.group("heart" .. k % 4).speed = 0.2
      wait(12)
      bullet.group("heart" .. k % 4).speed = 1.8
    end
  end
end

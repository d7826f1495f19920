-- heart.lua - Heart: Rows of characters place one bullet each. The heart pulses because one line
-- stops and one line releases all bullets with its tag.
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

-- heart.lua - Heart: Each # in the picture places one bullet. The heart beats because one line of
-- code slows all bullets with its tag and another speeds them up.
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

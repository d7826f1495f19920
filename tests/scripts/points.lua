-- A player's score: from 0 to 999999999999.
player.def('ship', { sprite = 'dot', hit = { circle = 2 } })

--case: a score stops at its limits
string.sys.join(1, 'ship')
for _, points in ipairs { 5, -6, 999999999998, 1, 1, 1000000000000, -999999999998, -1000000000000, 1000000000000 } do
  score.add(points, 1)
  print(player.get(1).score)
end
--> 5
--> 0
--> 999999999998
--> 999999999999
--> 999999999999
--> 999999999999
--> 1
--> 0
--> 999999999999

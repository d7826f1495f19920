-- patterns/try.lua - your pattern. e is the enemy, p the player. Save the file, and the running game reloads it.
return function(e)
  for i = 1, forever do
    pattern.ring { from = e, kind = "rice", bank = 1, n = 18, dir = 7 * i, speed = 1.8 }
    pattern.ring { from = e, kind = "star", bank = 3, n = 9, dir = -5 * i, speed = 1.2 }
    wait(24)
  end
end

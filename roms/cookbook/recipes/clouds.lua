-- clouds.lua - Out of the mist: A bullet with a delay starts as a harmless, motionless cloud in its
-- own colour. A ring right next to the player is fair, because the clouds show where it will be.
bullet.def("spore", { sprite = "orb", hit = { circle = 3.5 }, cloud = "mist" })

return function(_, p)
  for k = 0, forever do
    local bank = ({ 1, 3, 4, 5, 7 })[k % 5 + 1]
    for i = 0, 4 do
      local a = 72 * i + 31 * k
      pattern.ring { x = p.x + 84 * angle.cos(a), y = p.y - 90 + 60 * angle.sin(a), kind = "spore",
                     bank = bank, n = 9, dir = a,
                     speed = 1.3, delay = 45 }
      wait(6)
    end
    wait(60)
  end
end

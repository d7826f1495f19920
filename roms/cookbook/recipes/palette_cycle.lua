-- palette_cycle.lua - Palette cycle: Twelve colours of a bank rotate, so everything drawn in that
-- bank shimmers without a script. A palette fade turns the field to dusk and back.
return function(e)
  palette.cycle { first = 16 * 7 + 3, last = 16 * 7 + 14, every = 3 }
  for k = 0, forever do
    pattern.spiral { from = e, kind = "big", bank = 7, n = 24, arms = 4, dir = 45 * k, step = 8,
                     every = 7, speed = 1.3 }
    palette.fade { to = 0x100418, over = 40, first = 16 * 8, last = 255 }
    wait(60)
    palette.fade { to = "main", over = 40, first = 16 * 8 }
    wait(60)
  end
end

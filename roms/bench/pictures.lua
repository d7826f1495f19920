-- pictures.lua - n motionless pictures. DIP picture selects how they are drawn: bullets of one kind, in different banks, rotated,
-- clipped at the left edge or blended, by a table or a rule; free sprites, plain and flipped.
local how = board.dip("picture")
local free = how == "sprite" or how == "flipped"
local blend = ({ blended = "glow", blended_banks = "glow", ramp = "shine" })[how]
local banks = how == "banks" or how == "blended_banks"

if not free then
  bullet.def("thing", { sprite = "kind1", hit = "none", turns = how == "turned", blend = blend })
end

return function(n)
  return function()
    for _ = 1, n do -- the largest, 128 px, just fits
      local x, y = how == "clipped" and 0 or rng.number(64, rom.field.w - 64), rng.number(64, rom.field.h - 64)
      if free then
        sprite.put { sprite = "kind1", x = x, y = y, flip_x = how == "flipped" }
      else
        bullet.fire { kind = "thing", x = x, y = y, speed = 0, dir = rng.dir(), bank = banks and rng.int(0, 7) or 0 }
      end
    end
  end
end

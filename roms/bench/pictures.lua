-- pictures.lua - n motionless pictures. DIP picture selects how they are drawn: bullets of one kind, in different banks, rotated,
-- clipped at the left edge, blended by a table or a rule, or scaled; free sprites, plain, flipped, turned, scaled and
-- translucent.
local how = board.dip("picture")
local free = ({ sprite = {}, flipped = { flip_x = true }, sprite_turned = {}, sprite_scaled = { scale = 1.5 },
  alpha = { alpha = 6 } })[how]
local blend = ({ blended = "glow", blended_banks = "glow", ramp = "shine" })[how]
local banks = how == "banks" or how == "blended_banks"

if not free then
  bullet.def("thing", { sprite = "kind1", hit = "none", turns = how == "turned" or how == "scaled_turned", blend = blend,
    scale = how:find("scaled") and 1.5 or nil })
end

return function(n)
  return function()
    for _ = 1, n do -- the largest, 128 px, just fits
      local x, y = how == "clipped" and 0 or rng.number(64, rom.field.w - 64), rng.number(64, rom.field.h - 64)
      if free then
        free.sprite, free.x, free.y, free.dir = "kind1", x, y, how == "sprite_turned" and rng.dir() or nil
        sprite.put(free)
      else
        bullet.fire { kind = "thing", x = x, y = y, speed = 0, dir = rng.dir(), bank = banks and rng.int(0, 7) or 0 }
      end
    end
  end
end

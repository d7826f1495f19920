-- wind.lua - Wind: Gusts from both sides carry the ship and the petals along. `p:push` adds to the
-- ship's move; the petals' motion says what a gust does to them.
local gusts = { motion.def { { vx = 2, over = 90 } }, motion.def { { vx = -2, over = 90 } } }

return function(e, p)
  for k = 0, forever do
    local way = k % 2 == 0 and 1 or -1
    for i = 1, 96 do
      if i % 16 == 1 then
        pattern.line { x = 120 - 60 * way, y = -6, kind = "petal", bank = k % 2 == 0 and 1 or 6,
                       n = 9, width = 260, speed = 1.3, motion = gusts[1 + k % 2] }
      end
      p:push(way * angle.sin(i / 96 * 180), 0) -- up to 1 px per frame
      wait(1)
    end
  end
end

-- lasers.lua - curves of 64 points that circle and never leave the field. DIP picture selects how they are drawn.
local looks = {
  plain = { strip = "ray" },
  sprite = { strip = "d16" },
  blended = { strip = "ray", blend = "glow" },
}

local look = looks[board.dip("picture")]
laser.def("worm", { strip = look.strip, blend = look.blend, width = 8, hit = { share = 0.5 } })

return function(n)
  local round = { motion.def { { turn = 4, over = forever } }, motion.def { { turn = -5, over = forever } } }
  return function()
    for i = 1, n do
      laser.curve { kind = "worm", x = 60 + 200 * (i % 8) / 7, y = 60 + 120 * (i // 8) / 8, dir = i * 45, speed = 2.5,
        points = 64, motion = round[i % 2 + 1], bank = i % 8 }
    end
  end
end

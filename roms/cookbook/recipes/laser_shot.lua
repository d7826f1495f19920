-- laser_shot.lua - Player laser: A beam follows the ship while fire is held, and fades when fire is
-- released or the ship is hit. A laser kind with damage hurts only enemies, every four frames.
laser.def("lance", { strip = "ray", width = 10, hit = { share = 1 }, damage = 2, every = 4,
                     bank = 4 })

player.def("lancer", { sprite = "ship", hit = { circle = 2 }, run = function(p)
  while true do
    wait_until(function() return pad.down("fire", p) end)
    local beam = laser.beam { kind = "lance", follow = p, dy = -14, dir = 270, length = 320,
                              hold = forever, warn = 0, grow = 6 }
    repeat
      beam.width = p.focus and 16 or 9
      wait(1)
    until not (pad.down("fire", p) and beam.alive)
    beam:fade()
  end
end })

local function run()
  for k = 0, forever do
    enemy.spawn { kind = "wisp", x = 30 + 71 * k % 180, y = -10, hp = 24, run = function(e)
      e:move { x = e.x, y = 340, over = 260 }
    end }
    wait(24)
  end
end

return { run = run, ship = "lancer", alone = true }

-- mines.lua - Mines: Mines drift down until the ship comes near, then blink and burst into a ring.
-- The engine checks `wait_for`, so a field full of mines runs no script.
local mine = motion.def { { wait_for = { near = 64 } }, { speed = 0.2, bank = 1 },
  { loop = 4, { bank = 3 }, { wait = 5 }, { bank = 1 }, { wait = 5 } },
  { emit = { pattern = "ring", n = 14, kind = "rice", bank = 2, speed = 1.8 } }, { die = true } }

local function run()
  for k = 0, forever do
    bullet.fire { kind = "big", bank = 6, x = 20 + 83 * k % 200, y = -12, speed = 1.2,
                  motion = mine }
    wait(18)
  end
end

return { run = run, ship = "gun", alone = true }

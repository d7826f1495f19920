-- snow.lua - Snow: Every flake sways with its own width and period. `sway` and `period` are
-- declared values, set at random for each flake. One motion program serves all flakes.
value.def("sway")
value.def("period")
local drift = motion.def { { wave = "sway", every = "period", over = forever } }

return function()
  while true do
    for _ = 1, 2 do
      bullet.fire { kind = "star", x = rng.int(0, 240), y = -10, speed = rng.number(0.7, 1.3),
                    bank = rng.pick { 0, 0, 5 },
                    sway = rng.int(6, 26), period = rng.int(60, 140), motion = drift }
    end
    wait(7)
  end
end

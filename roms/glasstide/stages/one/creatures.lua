-- stages/one/creatures.lua - who lives in the shallows.
local kinds = require "kinds"
local creature, small, large, burst = kinds.creature, kinds.small, kinds.large, kinds.burst
local collapse, COLD, WARM = kinds.collapse, kinds.COLD, kinds.WARM

creature("krill",    COLD, 16, 16, 4,   120,   small, {})
creature("fish",     COLD, 20, 26, 16,  360,   small, { pearl = 1 })
creature("jelly",    WARM, 28, 26, 70,  1500,  large, { pearl = 3 })
creature("ray",      COLD, 40, 26, 60,  1600,  large, { pearl = 3 })
creature("urchin",   COLD, 28, 28, 90,  2400,  burst, { pearl = 4 })
creature("nautilus", WARM, 32, 32, 150, 5000,  large, { pearl = 6, conch = 1 })
creature("crab",     COLD, 56, 34, 100, 30000, collapse, { pearl = 9 })

-- A float harms nobody: bullets end at it, so it is a shelter for as long as it holds.
enemy.def("float", { sprite = "float", bank = WARM, hit = { circle = 15 }, hp = 160, score = 800,
                     spark = "crumb", blink = kinds.BLINK, on_hit = kinds.chip, on_death = large,
                     drops = { pearl = 2 }, touch = false, blocks = true })

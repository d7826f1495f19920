-- stages/moon/creatures.lua - the moon, a disc in the black water.
local kinds = require "kinds"

-- It wanes and waxes: each phase of the fight has its own picture.
enemy.def("moon", { sprite = "moon", bank = 0, hit = { circle = 58 }, hp = 100, score = 200000,
                    spark = "crumb", blink = 4, blink_soft = true,
                    on_hit = kinds.chip, on_death = kinds.collapse,
                    pictures = { half = "moon_half", sickle = "moon_sickle", new = "moon_new",
                                 full = "moon_full", eclipse = "moon_eclipse" } })

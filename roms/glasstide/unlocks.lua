-- unlocks.lua - what can be earned; EXTRAS of the title shows it.
local moon = require "stages/moon"

unlock.def("tern", { title = "The Tern", when = { clear = "two" },
                     hint = "Come through the drowned glassworks" })
unlock.def("rush", { title = "The Rush", when = { clear = true, mode = "dive" },
                     hint = "Turn the tide" })
unlock.def("music_room", { title = "Music", when = { clear = "one" },
                           hint = "Come through the shallows" })
-- Colours of the craft, for the switch `lamps` of the settings; with ember come two pieces of
-- music.
unlock.def("gilt", { title = "Gilt Lamps", when = { mode = "caravan", score = 600000 },
                     hint = "600000 points in the caravan" })
unlock.def("ember", { title = "Ember Lamps", hint = "Outlive what is under the abyss",
                      when = function(_) return moon.outlived() end })

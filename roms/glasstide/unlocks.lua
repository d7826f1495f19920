-- unlocks.lua - the unlocks; EXTRAS on the title lists them.
local moon = require "stages/moon"

unlock.def("tern", { title = "The Tern", when = { clear = "two" },
                     hint = "Clear the drowned glassworks" })
unlock.def("rush", { title = "The Rush", when = { clear = true, mode = "dive" },
                     hint = "Turn the tide" })
unlock.def("music_room", { title = "Music", when = { clear = "one" },
                           hint = "Clear the shallows" })
-- Colours of the crafts, for the setting `lamps`; ember also unlocks two pieces in the music
-- room.
unlock.def("gilt", { title = "Gilt Lamps", when = { mode = "caravan", score = 600000 },
                     hint = "Score 600,000 in the caravan" })
unlock.def("ember", { title = "Ember Lamps", hint = "Survive what lies below the abyss",
                      when = function(_) return moon.outlived() end })

-- unlocks.lua - the unlocks; EXTRAS on the title lists them.
local moon = require "stages/moon"

unlock.def("tern", { title = "The Tern", when = { clear = "two" },
                     hint = "Clear stage two" })
unlock.def("rush", { title = "The Rush", when = { clear = true, mode = "dive" },
                     hint = "Clear all three stages in Dive" })
unlock.def("music_room", { title = "Music", when = { clear = "one" },
                           hint = "Clear stage one" })
-- Colours of the crafts, for the setting `lamps`; ember also unlocks two pieces in the music
-- room.
unlock.def("gilt", { title = "Gilt Lamps", when = { mode = "caravan", score = 600000 },
                     hint = "Score 600,000 in Caravan" })
unlock.def("ember", { title = "Ember Lamps", hint = "Finish Dive with RATE x3 on Normal or harder, and survive the Moon",
                      when = function(_) return moon.outlived() end })

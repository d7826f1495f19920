-- items.lua - the items.
local items = { BOMBS = 6 } -- the most bombs a craft can hold

-- All items are green; nothing green is dangerous.
-- Creatures drop pearls, conches and hearts. A pearl is worth more the higher the craft takes it.
-- A conch gives a bomb, a heart a life. Swept bullets become foam; bullets cleared by the gauge
-- become prisms.
item.def("pearl", { sprite = "nacre", bank = 4, radius = 9, gives = { score = { 100, 1000 } } })
item.def("conch", { sprite = "conch", bank = 4, radius = 10, gives = { score = 500, bombs = 1 },
                    full = "bombs", gravity = 0.02, top = 1,
                    on_take = function(p)
                      sound.play(p.bombs < items.BOMBS and "conch" or "power")
                    end })
item.def("heart", { sprite = "heart", bank = 4, radius = 10, gives = { lives = 1 },
                    gravity = 0.02, top = 1 })
item.def("prism", { sprite = "prism", bank = 4, radius = 10, gives = { score = 10 }, top = 1.2,
                    on_take = function(p) sound.play("shard", { from = p }) end })
item.def("foam",  { sprite = "foam", bank = 4, radius = 9, gives = { score = 20 }, top = 1.4 })

return items

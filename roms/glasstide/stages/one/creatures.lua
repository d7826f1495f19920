-- stages/one/creatures.lua - the creatures of the shallows.
local kinds = require "kinds"
local creature, small, large, burst = kinds.creature, kinds.small, kinds.large, kinds.burst
local huge, collapse, COLD, WARM = kinds.huge, kinds.collapse, kinds.COLD, kinds.WARM

value.def("rest") -- frames that a bullet waits before its next step

creature("krill",    COLD, 16, 16, 4,   120,   small, {})
creature("fish",     COLD, 20, 26, 16,  360,   small, { pearl = 1 })
creature("arrow",    COLD, 16, 28, 26,  700,   small, { pearl = 1 })
creature("seahorse", WARM, 16, 34, 44,  1100,  large, { pearl = 2 })
creature("jelly",    WARM, 28, 26, 70,  1500,  large, { pearl = 3 })
creature("ray",      COLD, 40, 26, 60,  1600,  large, { pearl = 3 })
creature("urchin",   COLD, 28, 28, 90,  2400,  burst, { pearl = 4 })
creature("nautilus", WARM, 32, 32, 150, 5000,  large, { pearl = 6, conch = 1 })
creature("lantern_nautilus", COLD, 54, 46, 100, 15000, huge, { pearl = 8, conch = 1 },
         { attack = "lantern_nautilus_attack" })

-- A float is harmless and stops bullets, so it is a shelter until it breaks.
enemy.def("float", { sprite = "float", bank = WARM, hit = { circle = 15 }, hp = 160, score = 800,
                     spark = "crumb", blink = kinds.BLINK, on_hit = kinds.chip, on_death = large,
                     drops = { pearl = 2 }, touch = false, blocks = true })

-- A hatch of the wreck lies on the deck, so ships can't collide with it.
enemy.def("hatch", { sprite = "hatch", bank = COLD, hit = { circle = 15 }, hp = 48, score = 1200,
                     spark = "crumb", blink = kinds.BLINK, blink_soft = true, on_hit = kinds.chip, on_death = large,
                     pictures = { ajar = "hatch_ajar", half = "hatch_half", open = "hatch_open" },
                     drops = { pearl = 3 }, touch = false })

-- A rib of the whale stops bullets too, and a flower opens on its spine. Both lie on the sand.
enemy.def("rib", { sprite = "rib", bank = 2, hit = { capsule = { 32, 7, 14 } }, hp = 190, score = 600,
                   spark = "crumb", blink = kinds.BLINK, blink_soft = true, on_hit = kinds.chip, on_death = large,
                   drops = { pearl = 1 }, touch = false, blocks = true })

enemy.def("flower", { sprite = "flower", bank = WARM, hit = { circle = 13 }, hp = 120, score = 1400,
                      spark = "crumb", blink = kinds.BLINK, on_hit = kinds.chip, on_death = large,
                      pictures = { ajar = "flower_ajar", open = "flower_open" },
                      drops = { pearl = 3 }, touch = false })

-- A claw breaks off and clears the bullets near it.
local function break_off(e, p)
  huge(e, p)
  sound.play("shatter", { from = e })
  spark.burst { kind = "glint", x = e.x, y = e.y, n = 24, speed = 3 }
  bullet.sweep { x = e.x, y = e.y, radius_to = 110, over = 18, spark = "pop", items = "foam" }
end

enemy.def("claw", { sprite = "claw", bank = COLD, hit = { box = { 26, 44 } }, hp = 340, blink_soft = true,
                    score = 5000, spark = "crumb", blink = kinds.BLINK, on_hit = kinds.chip,
                    on_death = break_off, drops = { pearl = 5 },
                    run = function(e) e.flip_x = e.dx < 0 end })

enemy.def("crab", { sprite = "crab", bank = COLD, hit = { box = { 58, 34 } }, hp = 100, blink_soft = true,
                    score = 30000, spark = "crumb", blink = kinds.BLINK, on_hit = kinds.chip,
                    on_death = collapse, drops = { pearl = 9 }, pictures = { attack = "crab_attack" }, parts = {
  { kind = "claw", dx = -52, dy = 42, share = 0.6, tag = "left claw" },
  { kind = "claw", dx = 52, dy = 42, share = 0.6, tag = "right claw" } } })

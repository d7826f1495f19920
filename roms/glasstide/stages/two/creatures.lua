-- stages/two/creatures.lua - the workers of the drowned glassworks, and their products: gobs,
-- ingots, cogs, steam, panes.
local kinds = require "kinds"
local creature, small, large, burst = kinds.creature, kinds.small, kinds.large, kinds.burst
local collapse, COPPER, STEEL = kinds.collapse, 0, 1
local glass = kinds.glass

creature("drone",    COPPER, 14, 18, 5,   160,   small, {})
creature("bottle",   STEEL,  14, 26, 10,  260,   small, { pearl = 1 })
creature("tongs",    COPPER, 26, 28, 26,  520,   small, { pearl = 1 })
creature("puffer",   COPPER, 26, 30, 60,  1600,  large, { pearl = 3 })
creature("worm",     STEEL,  18, 44, 70,  1800,  large, { pearl = 3 })
creature("gear_ray", COPPER, 46, 28, 84,  2400,  large, { pearl = 4 })
creature("crucible", STEEL,  32, 32, 100, 2800,  burst, { pearl = 4 })
creature("kiln",     COPPER, 46, 44, 260, 6000,  large, { pearl = 6, conch = 1 })

-- Trains run on the ground, under the ship. A ladle spills when it breaks.
local function rolling(name, h, hp, score, on_death, drops, pictures)
  enemy.def(name, { sprite = name, bank = COPPER, hit = { box = { 32, h } }, hp = hp, score = score, spark = "crumb",
                    blink = kinds.BLINK, blink_soft = true, on_hit = kinds.chip, on_death = on_death, drops = drops,
                    pictures = pictures, touch = false })
end

rolling("engine", 56, 170, 4000, large, { pearl = 4 }, { up = "engine_up" })
rolling("gun",    46, 70,  1200, large, { pearl = 2 })
rolling("ladle",  46, 90,  1600, burst, { pearl = 3 })

-- Bosses blink softly: they are large and under constant fire, so they would stay white.
local function boss_kind(name, w, h, score, on_death)
  enemy.def(name, { sprite = name, hit = { box = { w, h } }, hp = 100, score = score,
                    spark = "crumb", blink = kinds.BLINK, blink_soft = true, on_hit = kinds.chip,
                    on_death = on_death, drops = { pearl = 8 }, pictures = { attack = name .. "_attack" } })
end

boss_kind("bellows", 64, 60, 20000, function(e)
  sound.play("collapse", { from = e })
  large(e)
end)
boss_kind("cinder",  38, 46, 25000, collapse)
boss_kind("quench",  38, 46, 25000, collapse)

glass("cog",   { hit = { circle = 8 },         cloud = "mist_150" })
glass("gob",   { hit = { circle = 11 },        cloud = "mist_150" })
glass("steam", { hit = { circle = 6 } })
glass("ingot", { hit = { capsule = { 7, 3 } }, turns = true })

-- A pane stops shots until it breaks; its splinters hang for a moment, then fly off.
motion.def { name = "splintered", { speed = 0.25, over = 30 }, { speed = 1.5, over = 60 } }

glass("pane", { hit = { box = { 28, 6 } }, hp = 14, score = 200, spark = "splint", order = -1,
  on_death = function(b)
    sound.play("shatter", { from = b })
    pattern.ring { from = b, kind = "shard", bank = 7, dir = 18, speed = 1.3, delay = 20,
                   motion = "splintered",
                   n = by_difficulty { easy = 4, normal = 6, hard = 8, abyss = 10 } }
  end })

-- Poured glass, a curved laser.
laser.def("pour", { strip = "ray_of_light", width = 11, hit = { share = 0.5 }, graze = 12,
                    vanish = "glint" })

spark.def("ember", { sprite = "ember", life = 119, gravity = -0.005, drag = 0.004, bank = 13 })

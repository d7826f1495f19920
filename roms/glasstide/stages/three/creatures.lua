-- stages/three/creatures.lua - the creatures of the abyss.
local kinds = require "kinds"
local creature, small, large = kinds.creature, kinds.small, kinds.large
local by = require "stages/three/by"

local VIOLET = kinds.COLD

-- The toughest creatures throw splinters at the craft that broke them.
local function shatter(e, p)
  large(e, p)
  sound.play("shatter", { from = e })
  pattern.ring { from = e, kind = "chip", bank = 3, aim = true, speed = 1.6, delay = 20,
                 n = by(5, 8, 12, 18) }
end

creature("mite",   VIOLET, 16, 16, 4,   140,  small,   {})
creature("viper",  VIOLET, 20, 34, 26,  520,  small,   { pearl = 1 })
creature("squid",  VIOLET, 22, 36, 64,  1600, large,   { pearl = 3 })
creature("comb",   VIOLET, 26, 34, 84,  1900, large,   { pearl = 3 })
creature("bell",   VIOLET, 14, 14, 12,  260,  small,   {})
creature("spider", VIOLET, 22, 30, 96,  2400, large,   { pearl = 4 })
creature("shark",  VIOLET, 24, 50, 120, 3200, large,   { pearl = 4 })
creature("gulper", VIOLET, 44, 44, 190, 5200, shatter, { pearl = 6, conch = 1 })
creature("chain_head", VIOLET, 26, 30, 150, 4000, shatter, { pearl = 5 })

-- A lamp of the drowned quay. It stands on the ground; once lit, its light clears the bullets around it when it breaks.
enemy.def("quay_lamp", { sprite = "lamp_out", bank = VIOLET, hit = { circle = 13 }, hp = 56, score = 900,
                         spark = "crumb", blink = kinds.BLINK, on_hit = kinds.chip, pictures = { lit = "lamp_lit" },
                         drops = { pearl = 2 }, touch = false, on_death = function(e, p)
  large(e, p)
  if e.picture ~= "lit" then return end
  sound.play("lamp", { from = e })
  spark.burst { kind = "shock", from = e, speed = 0 }
  bullet.sweep { x = e.x, y = e.y, radius = 8, radius_to = 72, over = 16, spark = "pop", items = "foam" }
end })

creature("queen",  VIOLET, 60, 66, 100, 120000, kinds.collapse, { pearl = 15 }, { attack = "queen_attack" })

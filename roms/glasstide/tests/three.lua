-- three.lua - the abyss: every phase of its bosses and its waves use the right colours: violet and rose are for
-- creatures, green is for the player.
local phases = require "helpers/phases"

local BANKS <const> = "01235"

local function look(boss, phase, difficulty)
  if difficulty == "abyss" then test.shot(boss .. "-" .. phase) end
end

phases.watch({ banks = BANKS, first = 420, looks = 1, apart = 240,
               bosses = { { "angler", "bait", "match", "teeth" },
                          { "queen", "wheels", "held", "ebb", "window", "flower" }, { "undertow", "again" } } }, look)

local run = test.run { stage = "three", difficulty = "abyss", seed = 2, invincible = true }
for _ = 1, 8 do
  run:step(200)
  phases.colours(run, BANKS, "the waves")
end
test.equal(run:refused("bullets"), 0, "the waves: dropped bullets")

-- one.lua - the shallows: every phase of both bosses and the stage itself use only the colours reserved for
-- bullets.
local phases = require "helpers/phases"

local BANKS <const> = "01237"

local function look(boss, phase, difficulty)
  if difficulty == "normal" then test.shot(boss .. "-" .. phase) end
end

phases.watch({ banks = BANKS, first = 300, looks = 6, apart = 60,
               bosses = { { "nautilus", "lantern", "chambers" },
                          { "crab", "pincers", "grotto", "lamplight", "chandelier", "harbour" } } }, look)

-- The complete stage on abyss, with fire held.
local run = test.run { stage = "one", difficulty = "abyss", seed = 1, invincible = true, pads = "fire" }
while run.frame < 12000 and not run:moment("clear", "one") do
  run:step(120)
  if run.frame == 2640 then test.shot "wreck" end
  phases.colours(run, BANKS, "the stage, frame " .. run.frame)
end
test.expect(run:moment("won", "lantern") or run:moment("lost", "lantern"), "the nautilus appears")
test.expect(run:moment("phase", "pincers"), "the crab appears")
test.equal(run:refused("bullets") + run:refused("enemies"), 0, "no pool is full")

-- One claw breaks off, and the crab fights on.
local fight = test.run { stage = "crab/pincers", seed = 1, invincible = true, frames = 200 }
test.equal(fight:eval "enemy.count('left claw') + enemy.count('right claw')", 2, "two claws")
fight:exec "enemy.group('left claw'):hurt(400)"
fight:step(5)
test.equal(fight:eval "enemy.count('left claw')", 0, "the left claw is gone")
test.equal(fight:eval "enemy.count('right claw')", 1, "the right claw is left")
test.equal(fight:moment("won"), nil, "the phase is not won yet")

-- moon.lua - the moon's fight: every phase uses only the colours reserved for bullets. The densest phases on abyss are
-- dense enough.
local phases = require "helpers/phases"

local BANKS <const> = "123567"
local DENSE <const> = { gibbous = 400, new = 400, full = 800 } -- bullets at once on abyss

local function look(_, phase, difficulty, most)
  test.expect(difficulty ~= "abyss" or most >= (DENSE[phase] or 0), ("%s, abyss: %d at once"):format(phase, most))
  if difficulty == "normal" then test.shot("moon-" .. phase) end
end

phases.watch({ banks = BANKS, first = 240, looks = 5, apart = 60,
               bosses = { { "moon", "gibbous", "half", "crescent", "new", "full", "eclipse" } } }, look)

-- Only time ends the last phase.
local run = test.run { stage = "moon/eclipse", difficulty = "easy", seed = 1, invincible = true, pads = "fire" }
test.expect(run:wait(function(r) return r:moment("won", "eclipse") end, 60 * 60), "it ends")
test.expect(run.frame > 44 * 60, "but not early")

-- It appears after the queen if the player has enough shards; not on easy, and not with fewer.
local function behind_the_queen(difficulty, shards)
  local dive = test.run { stage = "three:queen", difficulty = difficulty, seed = 1, invincible = true,
                          pads = "fire", registers = { shards = shards } }
  test.expect(dive:wait(function(r) return r:moment("boss", "moon") or r:moment("clear", "three") end, 30000),
              "the queen is beaten")
  return dive:moment("boss", "moon") ~= nil
end

test.expect(behind_the_queen("normal", 400), "it appears")
test.expect(not behind_the_queen("normal", 100), "but not without shards")
test.expect(not behind_the_queen("easy", 400), "and not on easy")

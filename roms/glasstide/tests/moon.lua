-- moon.lua - the moon's fight: every phase begins and fires on each difficulty, there is room for all of it, and what
-- flies keeps to the colours that the moon leaves to bullets. The densest phases on abyss are dense.
local DIFFICULTIES <const> = { "easy", "normal", "hard", "abyss" }
local PHASES <const> = { "gibbous", "half", "crescent", "new", "full", "eclipse" }
local ALLOWED <const> = { [1] = true, [2] = true, [3] = true, [5] = true, [6] = true, [7] = true }
local DENSE <const> = { gibbous = 400, new = 400, full = 800 } -- bullets at once on abyss

-- The banks of all that flies, each as a digit or a letter.
local BANKS <const> = [[(function()
  local seen, list = {}, {}
  bullet.each(nil, function(b) seen[b.bank] = true end)
  laser.each(nil, function(l) if not l.by then seen[l.bank] = true end end)
  for bank = 0, 15 do if seen[bank] then list[#list + 1] = ("%x"):format(bank) end end
  return table.concat(list)
end)()]]

local function watch(phase, difficulty)
  local run = test.run { stage = "moon/" .. phase, difficulty = difficulty, seed = 1,
                         invincible = true, frames = 240 }
  local what = ("%s, %s"):format(phase, difficulty)
  local began = run:moment("phase", phase)
  test.expect(began and began.of == "moon", what .. ": the phase has begun")
  local most = 0
  for _ = 1, 5 do
    most = math.max(most, run:live("bullets") + run:live("lasers"))
    for digit in run:eval(BANKS):gmatch "." do
      local bank = tonumber(digit, 16)
      test.expect(ALLOWED[bank], what .. ": a bullet in bank " .. bank)
    end
    run:step(60)
  end
  test.expect(most > 0, what .. ": something flies")
  test.expect(difficulty ~= "abyss" or most >= (DENSE[phase] or 0), what .. ": " .. most .. " at once")
  test.equal(run:refused("bullets") + run:refused("lasers"), 0, what .. ": there was room")
  if difficulty == "normal" then test.shot("moon-" .. phase) end
end

for _, phase in ipairs(PHASES) do
  for _, difficulty in ipairs(DIFFICULTIES) do watch(phase, difficulty) end
end

-- The last one is outlived: time alone ends it.
local run = test.run { stage = "moon/eclipse", difficulty = "easy", seed = 1, invincible = true, pads = "fire" }
test.expect(run:wait(function(r) return r:moment("won", "eclipse") end, 60 * 60), "it goes")
test.expect(run.frame > 44 * 60, "not before its time")

-- It is met behind the queen, by those who have brought shards enough; not on easy, and not with fewer.
local function behind_the_queen(difficulty, shards)
  local dive = test.run { stage = "three:queen", difficulty = difficulty, seed = 1, invincible = true,
                          pads = "fire", registers = { shards = shards } }
  test.expect(dive:wait(function(r) return r:moment("boss", "moon") or r:moment("clear", "three") end, 30000),
              "the queen goes")
  return dive:moment("boss", "moon") ~= nil
end

test.expect(behind_the_queen("normal", 400), "it is there")
test.expect(not behind_the_queen("normal", 100), "it is not, without shards")
test.expect(not behind_the_queen("easy", 400), "it is not, on easy")

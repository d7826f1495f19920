-- three.lua - the abyss: every phase of its bosses begins and fires on each difficulty, in colours that are its own,
-- and so do its waves.
local phases = {
  angler = { "bait", "match", "teeth" },
  queen = { "wheels", "held", "ebb", "window", "flower" },
  undertow = { "again" },
}
local SOON <const>, LATER <const> = 420, 240 -- the boss has come, and has fired for some seconds; frames more
-- Bullets are in these banks and in no other: violet and rose are the creatures', green is the player's.
local STRANGE = [[(function()
  local n, may = 0, { [0] = true, true, true, true, [5] = true }
  bullet.each(nil, function(b) if not may[b.bank] then n = n + 1 end end)
  return n
end)()]]

local function watch(boss, phase, difficulty)
  local run = test.run { stage = boss .. "/" .. phase, difficulty = difficulty, seed = 1,
                         invincible = true, frames = SOON }
  local what = ("%s/%s, %s"):format(boss, phase, difficulty)
  local began = run:moment("phase", phase)
  test.expect(began and began.of == boss, what .. ": the phase has begun")
  test.expect(run:live("bullets") + run:live("lasers") > 0, what .. ": something flies")
  test.equal(run:eval(STRANGE), 0, what .. ": bullets in banks that are not the abyss's")
  run:step(LATER)
  test.equal(run:eval(STRANGE), 0, what .. ": nor later")
  test.equal(run:refused("bullets"), 0, what .. ": bullets there was no room for")
end

for _, boss in ipairs { "angler", "queen", "undertow" } do
  for _, phase in ipairs(phases[boss]) do
    for _, difficulty in ipairs { "easy", "normal", "hard", "abyss" } do
      watch(boss, phase, difficulty)
    end
    test.shot(boss .. "-" .. phase)
  end
end

local run = test.run { stage = "three", difficulty = "abyss", seed = 2, invincible = true }
for _ = 1, 8 do
  run:step(200)
  test.equal(run:eval(STRANGE), 0, "the waves: bullets in banks that are not the abyss's")
end
test.equal(run:refused("bullets"), 0, "the waves: bullets there was no room for")

-- bosses.lua - every phase of every boss begins, fires, and looks as it did; on each difficulty something flies.
local phases = {
  crab = { "pincers", "grotto", "lamplight", "chandelier", "harbour" },
}
local FRAMES <const> = 420 -- the boss has come, and has fired for some seconds

local function watch(boss, phase, difficulty)
  local run = test.run { stage = boss .. "/" .. phase, difficulty = difficulty, seed = 1,
                         invincible = true, frames = FRAMES }
  local what = ("%s/%s, %s"):format(boss, phase, difficulty)
  local began = run:moment("phase", phase)
  test.expect(began and began.of == boss, what .. ": the phase has begun")
  test.expect(run:live("bullets") + run:live("lasers") > 0, what .. ": something flies")
  test.equal(run:refused("bullets"), 0, what .. ": bullets there was no room for")
  return run
end

for _, boss in ipairs { "crab" } do
  for _, phase in ipairs(phases[boss]) do
    watch(boss, phase, "easy")
    watch(boss, phase, "hard")
    watch(boss, phase, "normal")
    test.shot(boss .. "-" .. phase)
  end
end

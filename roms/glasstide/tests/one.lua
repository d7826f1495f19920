-- one.lua - the shallows: every phase of both bosses begins and fires on each difficulty, there is room for all of it,
-- and what flies, in the stage as well, keeps to the colours that creatures and shots leave to bullets.
local DIFFICULTIES <const> = { "easy", "normal", "hard", "abyss" }
local ALLOWED <const> = { [0] = true, [1] = true, [2] = true, [3] = true, [7] = true }
local phases = {
  nautilus = { "lantern", "chambers" },
  crab = { "pincers", "grotto", "lamplight", "chandelier", "harbour" },
}

-- The banks of all that flies, each as a digit or a letter.
local BANKS <const> = [[(function()
  local seen, list = {}, {}
  bullet.each(nil, function(b) seen[b.bank] = true end)
  laser.each(nil, function(l) if not l.by then seen[l.bank] = true end end)
  for bank = 0, 15 do if seen[bank] then list[#list + 1] = ("%x"):format(bank) end end
  return table.concat(list)
end)()]]

local function colours(run, what)
  for digit in run:eval(BANKS):gmatch "." do
    local bank = tonumber(digit, 16)
    test.expect(ALLOWED[bank], what .. ": a bullet in bank " .. bank)
  end
end

local function watch(boss, phase, difficulty)
  local run = test.run { stage = boss .. "/" .. phase, difficulty = difficulty, seed = 1,
                         invincible = true, frames = 300 }
  local what = ("%s/%s, %s"):format(boss, phase, difficulty)
  local began = run:moment("phase", phase)
  test.expect(began and began.of == boss, what .. ": the phase has begun")
  local most = 0
  for _ = 1, 6 do
    most = math.max(most, run:live("bullets") + run:live("lasers"))
    colours(run, what)
    run:step(60)
  end
  if difficulty == "normal" then test.shot(boss .. "-" .. phase) end
  test.expect(most > 0, what .. ": something flies")
  test.equal(run:refused("bullets") + run:refused("lasers"), 0, what .. ": there was room")
end

for boss, list in pairs(phases) do
  for _, phase in ipairs(list) do
    for _, difficulty in ipairs(DIFFICULTIES) do watch(boss, phase, difficulty) end
  end
end

-- The whole of it, with fire held, on the hardest.
local run = test.run { stage = "one", difficulty = "abyss", seed = 1, invincible = true, pads = "fire" }
while run.frame < 12000 and not run:moment("clear", "one") do
  run:step(120)
  if run.frame == 1920 then test.shot "wreck" end
  colours(run, "the stage, frame " .. run.frame)
end
test.expect(run:moment("won", "lantern") or run:moment("lost", "lantern"), "the nautilus has come")
test.expect(run:moment("phase", "pincers"), "the crab has come")
test.equal(run:refused("bullets") + run:refused("enemies"), 0, "the stage has room")

-- A claw breaks off alone, and the crab goes on.
local fight = test.run { stage = "crab/pincers", seed = 1, invincible = true, frames = 200 }
test.equal(fight:eval "enemy.count('left claw') + enemy.count('right claw')", 2, "two claws")
fight:exec "enemy.group('left claw'):hurt(400)"
fight:step(5)
test.equal(fight:eval "enemy.count('left claw')", 0, "the left one is off")
test.equal(fight:eval "enemy.count('right claw')", 1, "the right one is on")
test.equal(fight:moment("won"), nil, "the phase goes on")

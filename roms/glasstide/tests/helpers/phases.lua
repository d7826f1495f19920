-- helpers/phases.lua - what every boss's phase is asked: it begins and fires on each difficulty, there is room for all
-- of it, and what flies keeps to the colours that its stage leaves to bullets.
local phases = {}

local DIFFICULTIES <const> = { "easy", "normal", "hard", "abyss" }

-- The banks of all that flies and is not the player's, each as a digit or a letter.
local BANKS <const> = [[(function()
  local seen, list = {}, {}
  bullet.each(nil, function(b) seen[b.bank] = true end)
  laser.each(nil, function(l) if not l.by then seen[l.bank] = true end end)
  for bank = 0, 15 do if seen[bank] then list[#list + 1] = ("%x"):format(bank) end end
  return table.concat(list)
end)()]]

-- All that flies now is in one of these banks, a digit each.
function phases.colours(run, banks, what)
  for digit in run:eval(BANKS):gmatch "." do
    test.expect(banks:find(digit, 1, true), what .. ": a bullet in bank " .. tonumber(digit, 16))
  end
end

-- Looks at a phase so often, so many frames apart, from its frame `first` on. Returns the most that flew at once.
local function watch(boss, phase, difficulty, a)
  local run = test.run { stage = boss .. "/" .. phase, difficulty = difficulty, seed = 1, invincible = true,
                         frames = a.first }
  local what = ("%s/%s, %s"):format(boss, phase, difficulty)
  local began, most = run:moment("phase", phase), 0
  test.expect(began and began.of == boss, what .. ": the phase has begun")
  for _ = 1, a.looks do
    most = math.max(most, run:live("bullets") + run:live("lasers"))
    phases.colours(run, a.banks, what)
    run:step(a.apart)
  end
  phases.colours(run, a.banks, what)
  test.expect(most > 0, what .. ": something flies")
  test.equal(run:refused("bullets") + run:refused("lasers") + run:refused("laser_points"), 0,
             what .. ": there was room")
  return most
end

-- Watches all phases on all difficulties. a: bosses, a list of { name, phases .. }; banks, digits; first, looks, apart.
-- look: called after each, as look(boss, phase, difficulty, most); its pictures are of that run.
function phases.watch(a, look)
  for _, boss in ipairs(a.bosses) do
    for i = 2, #boss do
      for _, difficulty in ipairs(DIFFICULTIES) do
        local most = watch(boss[1], boss[i], difficulty, a)
        if look then look(boss[1], boss[i], difficulty, most) end
      end
    end
  end
end

return phases

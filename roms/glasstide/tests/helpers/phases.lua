-- helpers/phases.lua - checks for every boss phase: it starts and fires on each difficulty, no pool is full, and its
-- bullets use only the colours that its stage reserves for bullets.
local phases = {}

local DIFFICULTIES <const> = { "easy", "normal", "hard", "abyss" }

-- The banks of all enemy bullets and lasers, each as a digit or a letter.
local BANKS <const> = [[(function()
  local seen, list = {}, {}
  bullet.each(nil, function(b) seen[b.bank] = true end)
  laser.each(nil, function(l) if not l.by then seen[l.bank] = true end end)
  for bank = 0, 15 do if seen[bank] then list[#list + 1] = ("%x"):format(bank) end end
  return table.concat(list)
end)()]]

-- Checks that every bullet and laser is in one of these banks, a digit each.
function phases.colours(run, banks, what)
  for digit in run:eval(BANKS):gmatch "." do
    test.expect(banks:find(digit, 1, true), what .. ": a bullet in bank " .. tonumber(digit, 16))
  end
end

-- Checks a phase `looks` times, `apart` frames apart, from its frame `first` on. Returns the most bullets seen.
local function watch(boss, phase, difficulty, a)
  local run = test.run { stage = boss .. "/" .. phase, difficulty = difficulty, seed = 1, invincible = true,
                         frames = a.first }
  local what = ("%s/%s, %s"):format(boss, phase, difficulty)
  local began, most = run:moment("phase", phase), 0
  test.expect(began and began.of == boss, what .. ": the phase starts")
  for _ = 1, a.looks do
    most = math.max(most, run:live("bullets") + run:live("lasers"))
    phases.colours(run, a.banks, what)
    run:step(a.apart)
  end
  phases.colours(run, a.banks, what)
  test.expect(most > 0, what .. ": it fires")
  test.equal(run:refused("bullets") + run:refused("lasers") + run:refused("laser_points"), 0,
             what .. ": no pool is full")
  return most
end

-- Checks all phases on all difficulties. a: bosses, a list of { name, phases .. }; banks, digits; first, looks, apart.
-- Calls look(boss, phase, difficulty, most) after each; a picture taken there shows that run.
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

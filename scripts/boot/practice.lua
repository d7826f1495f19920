-- boot/practice.lua - what a practice start begins with.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

-- practice is "boss/phase", "stage" or "stage:mark". Returns a function that starts that part in a scope owned by
-- `owner`, and returns the scope.
local function part(practice)
  local piece = sys.read("boot/piece")
  local name, phase = practice:match("^([^/]*)/(.*)$")
  if name then return piece("boot.run", { boss = name, phase = phase }) end
  local stage_name, mark = practice:match("^([^:]*):(.*)$")
  return piece("boot.run", { stage = stage_name or practice, mark = mark })
end

local function expect_registers(kind, with)
  local names, known = {}, {}
  for i, r in ipairs(sys.ship(kind).registers) do names[i], known[r.name] = r.name, true end
  for _, r in ipairs(with.registers) do
    if not known[r.name] then
      sys.fail("--register", ('ship "%s" has no register "%s"%s'):format(kind, r.name, sys.hint(r.name, names)))
    end
  end
end

-- What is practised, and with which ship: "crab/pincers@petrel"; without, it is the first.
local function split(a, practice)
  local what, kind = practice:match("^(.*)@([^@]*)$")
  if not what then return practice, a.kinds[1] end
  for _, known in ipairs(a.kinds) do
    if known == kind then return what, kind end
  end
  sys.unknown("boot.run", "ship", kind, a.kinds)
end

-- The function that starts that part in a game, or nil: the cabinet asks for the list; and the ship.
return function(a, practice)
  local what, kind = split(a, practice)
  expect_registers(kind, a.with)
  return what ~= "?" and part(what) or nil, kind
end

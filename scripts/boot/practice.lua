-- boot/practice.lua - reads the section of a practice start: "boss/phase", "stage" or "stage:mark", then maybe "@ship".
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

-- The stages that the game plays; one of them may have the fight of a boss.
local function stages_of(a)
  local list = {}
  for _, mode in ipairs(a.modes or { a }) do table.move(mode.stages, 1, #mode.stages, #list + 1, list) end
  return list
end

-- Returns a function that starts the section in a scope owned by `owner`, and returns the scope.
local function read_section(a, section)
  local piece = sys.read("boot/piece")
  local name, phase = section:match("^([^/]*)/(.*)$")
  if name then return piece("boot.run", { boss = name, phase = phase, search = stages_of(a) }) end
  local stage_name, mark = section:match("^([^:]*):(.*)$")
  return piece("boot.run", { stage = stage_name or section, mark = mark })
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

-- Returns the section without its ship, and the ship; by default the first one.
local function split(a, practice)
  local section, kind = practice:match("^(.*)@([^@]*)$")
  if not section then return practice, a.kinds[1] end
  for _, known in ipairs(a.kinds) do
    if known == kind then return section, kind end
  end
  sys.unknown("boot.run", "ship", kind, a.kinds)
end

-- Returns the function that starts the section, and the ship. The function is nil if the program asks for the list.
return function(a, practice)
  local section, kind = split(a, practice)
  expect_registers(kind, a.with)
  return section ~= "?" and read_section(a, section) or nil, kind
end

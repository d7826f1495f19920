-- mission.lua - mission.def: short tasks, made of sections that can be practised. The best result of each is stored as
-- a save "mission/NAME", by the same rule as scores. boot.lua shows and plays them: boot/mission.lua, screens/missions.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local mission = {}

local list, named = {}, {} -- definitions, in order and by name
local names = {}           -- of the definitions

local STARS <const> = 3 -- maximum: one for the goal, one for each value of `medals`

local function key(name) return "mission/" .. name end

-- Returns whether result a is better than result b.
local function better(m, a, b)
  if m.by == "time" then return a < b end
  return a > b
end

-- Returns the number of stars for a result.
local function stars(m, value)
  local n = 1
  for _, least in ipairs(m.medals or {}) do
    if not better(m, least, value) then n = n + 1 end
  end
  return n
end

local function best(m)
  local value, ship = tostring(save.get(key(m.name)) or ""):match("^(%-?%d+) (.+)$")
  value = math.tointeger(value)
  if not value then return nil, 0 end
  return value, stars(m, value), ship
end

local function find(api, name)
  local m = named[sys.check(api, name).name]
  if not m then sys.unknown(api, "mission", name, names) end
  return m
end

function mission.def(name, args)
  local m = sys.read("mission/def")(sys.check("mission.def", name, args), STARS)
  if named[m.name] then sys.fail("mission.def", ('mission "%s" is declared twice'):format(m.name)) end
  if #list == 0 then
    on.bomb(function() sys.missions.bombed = sys.missions.bombed + 1 end)
    on.kill(function(_, p) if p then sys.missions.killed = sys.missions.killed + 1 end end)
  end
  sys.note_place("mission.def", m.name)
  list[#list + 1], named[m.name], names[#names + 1] = m, m, m.name
end

function mission.best(name) return best(find("mission.best", name)) end

function mission.stars() return sys.missions.total() end

-- ---- for boot.lua and the screens ----

-- bombed, killed: since the start of the current mission.
sys.missions = { bombed = 0, killed = 0, stars = stars, best = best }

function sys.missions.total()
  local n = 0
  for _, m in ipairs(list) do n = n + select(2, best(m)) end
  return n, STARS * #list
end

function sys.missions.any() return #list > 0 end

function sys.missions.get(name) return named[name] end

-- Returns a mission's index in the list, and the number of missions.
function sys.missions.place(name)
  for i, m in ipairs(list) do
    if m.name == name then return i, #list end
  end
end

function sys.missions.each(f)
  for i, m in ipairs(list) do f(m, i) end
end

-- Saves a result if it is the best. Returns whether it is.
function sys.missions.enter(m, value, ship)
  local old = best(m)
  if old and not better(m, value, old) then return false end
  save.set(key(m.name), ("%d %s"):format(value, ship))
  return true
end

-- Fails unless everything that missions name is declared. a: the arguments of boot.run.
function sys.missions.expect(a) sys.read("mission/expect")(list, a) end

return mission

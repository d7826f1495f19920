-- unlock.lua - unlock.def and unlock.has: what players have earned. It is kept as saves "unlock/NAME", so in a demo's
-- start, and written by runs alone whose scores are kept. boot.lua asks what was earned when a stage is cleared and when
-- a run is over: unlock/earn.lua.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local unlock = {}

local list = {}  -- definitions, as they were declared: name, when, title, hint
local names = {} -- of these

-- of: as of sys.fail.
local function find(api, name, of)
  for _, u in ipairs(list) do
    if u.name == name then return u end
  end
  sys.unknown(api, "unlock", name, names, of)
end

local function has(name) return save.get("unlock/" .. name) == true end

function unlock.def(name, args)
  local a = sys.check("unlock.def", name, args)
  for _, u in ipairs(list) do
    if u.name == a.name then sys.fail("unlock.def", ('unlock "%s" is declared twice'):format(a.name)) end
  end
  if type(a.when) == "table" then
    a.when = sys.check("unlock.def when", a.when)
  elseif type(a.when) ~= "function" then
    sys.fail("unlock.def", ("when: expected a table or a function, got %s"):format(math.type(a.when) or type(a.when)))
  end
  sys.note_place("unlock.def", a.name)
  list[#list + 1], names[#names + 1] = a, a.name
end

function unlock.has(name) return has(find("unlock.has", sys.check("unlock.has", name).name).name) end

-- ---- for boot.lua and the screens ----

sys.unlock = {}

-- What keeps the thing that needs this unlock closed: its hint, or "" if it has none; nil: it is open. api and of: whose
-- error it is if nobody declared the unlock, as of sys.fail.
function sys.unlock.closed(needs, api, of)
  local u = needs and find(api or "needs", needs, of)
  if not u or has(u.name) then return nil end
  return u.hint or ""
end

function sys.unlock.any() return #list > 0 end

-- Calls f(unlock, has) for each.
function sys.unlock.each(f)
  for _, u in ipairs(list) do f(u, has(u.name)) end
end

-- Fails unless everything that the unlocks and `needs` name is there; a is boot.run's.
function sys.unlock.expect(a) sys.read("unlock/expect")(list, find, a) end

-- Keeps what this run has earned: run is what `when` is asked about. Returns the titles of what is new.
function sys.unlock.earn(run)
  local earned = sys.read("unlock/earn")
  local new = {}
  for _, u in ipairs(list) do
    if not has(u.name) and earned(u.when, run) then
      save.set("unlock/" .. u.name, true)
      new[#new + 1] = text.lang(u.title or (u.name:gsub("_", " "):upper()))
    end
  end
  return new
end

return unlock

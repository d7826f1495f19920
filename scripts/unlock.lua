-- unlock.lua - unlock.def and unlock.has: rewards that players have earned. They are stored as saves "unlock/NAME",
-- which are part of a demo's start, and written only by runs whose scores are saved. boot.lua checks for new unlocks
-- after each stage and at the end of a run (unlock/earn.lua).
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local unlock = {}

local list = {}  -- definitions in order: name, when, title, hint
local names = {} -- of the definitions

-- of: as in sys.fail.
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

-- Returns nil if the unlock is earned; otherwise its hint, or "". api and of: for the error about an undeclared unlock,
-- as in sys.fail.
function sys.unlock.closed(needs, api, of)
  local u = needs and find(api or "needs", needs, of)
  if not u or has(u.name) then return nil end
  return u.hint or ""
end

function sys.unlock.any() return #list > 0 end

-- Calls f(unlock, has) for each unlock.
function sys.unlock.each(f)
  for _, u in ipairs(list) do f(u, has(u.name)) end
end

-- Fails unless everything that unlocks and `needs` name is declared. a: the arguments of boot.run.
function sys.unlock.expect(a) sys.read("unlock/expect")(list, find, a) end

-- Saves the unlocks that this run has earned. run: the argument of `when`. Returns the titles of the new ones.
function sys.unlock.earn(run)
  local earned = sys.read("unlock/earn")
  local new = {}
  for _, u in ipairs(list) do
    if not has(u.name) and earned(u.when, run) then
      save.set("unlock/" .. u.name, true)
      new[#new + 1] = u.title and text.lang(u.title) or menu.label(u.name)
    end
  end
  return new
end

return unlock

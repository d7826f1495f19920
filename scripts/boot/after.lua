-- boot/after.lua - what follows a game that was not left: ending and staff roll, then name entry and scores.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local SCORES = 6 * 60 -- frames that the scores are shown

local function holds(when, run)
  if type(when) == "function" then return when(run) == true end
  for key, value in pairs(when or {}) do
    if run[key] ~= value then return false end
  end
  return true
end

-- Returns the sections of the staff roll for this run.
local function staff_of(a, run)
  local parts = {}
  for _, part in ipairs(a.staff) do
    if holds(part.when, run) then parts[#parts + 1] = part end
  end
  return parts
end

-- Shows the first ending that matches the run. Returns false if no staff roll follows.
local function ending(a, show, run)
  if type(a.ending) == "function" then return a.ending(run) end
  for _, e in ipairs(a.ending or {}) do
    if holds(e.when, run) then return e.show(run) end
  end
  show("ending", run)
end

-- Returns the place of a row in the table of all ships, or nil.
local function place(scores, row)
  for i, r in ipairs(score.rows(scores)) do
    if r.ship == row.ship and r.score == row.score and r.name == row.name then return i end
  end
end

-- Players whose scores are among the best enter their names. Then the table is shown: that of their ship, or for two
-- different ships that of all ships.
local function enter_names(a, show, run)
  local entries = sys.read("boot/records").best(run, #a.kinds > 1)
  if #entries == 0 then return end
  local scores = sys.score_table(run.difficulty, run.mode)
  local names, ship, mark = show("name", entries), entries[1].row.ship, nil
  if type(names) == "string" then names = { names } end
  for i, e in ipairs(entries) do
    e.row.name = type(names) == "table" and names[i] or nil
    if not e.row.name then sys.fail("boot.run", 'screen "name": expected a list of names, got ' .. type(names)) end
    local at = score.enter(scores, e.row)
    mark = mark and at and math.min(mark, at) or mark or at
    if e.row.ship ~= ship then ship = nil end
  end
  if not ship then mark = place(scores, entries[1].row) end
  show("scores", run.difficulty, SCORES, mark, ship, run.mode)
end

-- run: mode, difficulty, ship, ships, players, continues, clear, scores.
return function(a, show, run)
  if run.clear then
    local staff = ending(a, show, run)
    sys.wipe()
    if a.staff and staff ~= false then show("staff", staff_of(a, run)) end
  end
  enter_names(a, show, run)
end

-- boot/after.lua - all that is after a game that nobody left: ending and staff, then names and scores.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each

local RANKS = 10      -- rows of a table
local SCORES = 6 * 60 -- frames it stands

local function holds(when, run)
  for key, value in pairs(when or {}) do
    if run[key] ~= value then return false end
  end
  return true
end

-- The first ending that is for this run.
local function ending(a, show, run)
  if type(a.ending) == "function" then return a.ending(run) end
  for _, e in ipairs(a.ending or {}) do
    if holds(e.when, run) then return e.show(run) end
  end
  show("ending", run)
end

-- The row a score would take in its table, or nil.
local function rank(name, points)
  local rows = score.rows(name)
  if points <= 0 then return nil end
  for i, r in ipairs(rows) do
    if points > r.score then return i <= RANKS and i or nil end
  end
  return #rows < RANKS and #rows + 1 or nil
end

-- Everybody whose score is among the best enters a name, then sees it in the table.
local function enter_names(show, run)
  local entries = {}
  for p, points in ipairs(run.scores) do
    local row = rank(run.difficulty, points)
    if row then entries[#entries + 1] = { p = p, points = points, rank = row } end
  end
  if #entries == 0 then return end
  local names, row = show("name", entries), nil
  if type(names) == "string" then names = { names } end
  for i, e in ipairs(entries) do
    local name = type(names) == "table" and names[i] or nil
    if not name then sys.fail("boot.run", "screen name: expected a list of names, got " .. type(names)) end
    local at = score.enter(run.difficulty, { name = name, score = e.points })
    row = row and at and math.min(row, at) or row or at
  end
  show("scores", run.difficulty, SCORES, row)
end

-- run: what was played, and what became of it: mode, difficulty, ship, ships, players, continues, clear, scores.
return function(a, show, run)
  if run.clear then
    ending(a, show, run)
    sys.wipe()
    if a.staff then show("staff", a.staff) end
  end
  enter_names(show, run)
end

-- boot/after.lua - all that is after a game that nobody left: ending and staff, then names and scores.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each

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

-- Everybody whose score is among the best enters a name, then sees it in the table of their ship.
local function enter_names(a, show, run)
  local entries = sys.read("boot/records").best(run, #a.players > 1)
  if #entries == 0 then return end
  local names, first = show("name", entries), {}
  if type(names) == "string" then names = { names } end
  for i, e in ipairs(entries) do
    e.row.name = type(names) == "table" and names[i] or nil
    if not e.row.name then sys.fail("boot.run", "screen name: expected a list of names, got " .. type(names)) end
    local at, ship = score.enter(run.difficulty, e.row), e.row.ship or ""
    first[ship] = first[ship] and at and math.min(first[ship], at) or first[ship] or at
  end
  for ship, at in pairs(first) do show("scores", run.difficulty, SCORES, at, ship ~= "" and ship or nil) end
end

-- run: what was played, and what became of it: mode, difficulty, ship, ships, players, continues, clear, scores.
return function(a, show, run)
  if run.clear then
    ending(a, show, run)
    sys.wipe()
    if a.staff then show("staff", a.staff) end
  end
  enter_names(a, show, run)
end

-- boot/records.lua - the results of a run: the tally of each stage, unlocks, and rows of the score tables. They are in
-- nvram, which the program saves only for runs that were played from the title, without rewinding, at full speed.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local records = {}

local FEW = 14 -- highest number of a stage in a row of a table; nvram.h

local scoring, unlocks = rawget(sys, "scoring"), rawget(sys, "unlock") -- nil if the game does not use them

-- Fails unless everything that rules, tally, unlocks and `needs` name is declared. a: boot.run's arguments.
function records.expect(a)
  if scoring then scoring.expect() end
  if rawget(sys, "missions") then sys.missions.expect(a) end
  if unlocks then return unlocks.expect(a) end
  local function refuse(api, needs, of)
    if needs then sys.unknown(api, "unlock", needs, {}, of) end
  end
  for _, list in ipairs { a.players, a.kinds } do
    for _, kind in ipairs(list) do refuse("player.def", sys.ship(kind).needs, kind) end
  end
  for name, needs in pairs(rawget(sys, "stage_needs") or {}) do refuse("stage.def", needs, name) end
  for _, mode in ipairs(a.modes or {}) do refuse("boot.run", mode.needs) end
  for _, m in ipairs(a.music or {}) do refuse("boot.run", m.needs) end
end

-- Returns the hint of an unlock that has not been earned, or ""; nil if it has been earned.
function records.closed(needs) return needs and unlocks.closed(needs) end

-- Returns the index of the run's next open stage after the i-th, or nil.
function records.next(run, i)
  local needs = rawget(sys, "stage_needs") or {}
  for k = i + 1, #run.stages do
    if not records.closed(needs[run.stages[k]]) then return k end
  end
end

-- Starts a run that has mode, stages and ships. Adds the fields that `when` of unlock.def reads.
function records.begin(run)
  run.difficulty, run.ship, run.players = board.difficulty(), run.ships[1], #run.ships
  run.continues, run.clear, run.cleared, run.reached, run.scores = 0, false, {}, 0, {}
end

local function earn(run)
  run.continues = sys.run("continues")
  for p = 1, run.players do run.scores[p] = hud.score(p) end
  return unlocks and unlocks.earn(run) or {}
end

-- Returns the rows of the tallies, each a label and every player's points; nil if the game has no tally.
local function tallies(n, last)
  local rows, row_of = {}, {}
  for p = 1, n do
    local lines = scoring and scoring.tally(player.get(p), last)
    if not lines then return end
    for _, line in ipairs(lines) do
      local word = text.lang(line.label)
      local row = row_of[word] or { n == 1 and line.value and word .. " " .. line.value or word, 0, 0 }
      if not row_of[word] then rows[#rows + 1] = row end
      row_of[word], row[p + 1] = row, line.points
    end
  end
  local function points(p) return function() return hud.score(p) end end -- the scores can still rise
  rows[#rows + 1] = { "Score", points(1), n > 1 and points(2) or nil }
  return rows
end

-- Returns each player's grade for a stage; nil if the game gives no grades.
local function grades(run, name)
  if not run.grades then return nil end
  local list = {}
  for p = 1, run.players do
    list[p] = run.grades(name, player.get(p))
    if type(list[p]) ~= "string" then
      sys.fail("boot.run", 'grades: expected a string such as "S", got ' .. type(list[p]))
    end
  end
  return list
end

-- Records that the run's i-th stage was cleared. Returns the rows of its results, or nil for the default ones; the titles
-- of new unlocks, which can be the next stage; and a grade for each player, or nil.
function records.stage(run, i)
  run.stage = run.stages[i]
  run.reached, run.cleared[run.stage] = run.reached + 1, true
  local new = earn(run)
  run.stage = nil
  return tallies(run.players, not records.next(run, i)), new, grades(run, run.stages[i])
end

-- Ends the run. Returns the titles of new unlocks.
function records.over(run) return earn(run) end

-- Returns the place that a score would have in its table, or nil.
local function rank(scores, ship, points)
  local rows, place = score.rows(scores, ship), 1
  while rows[place] and rows[place].score >= points do place = place + 1 end
  return points > 0 and place <= 10 and place or nil
end

-- Returns how many other players of this run are ahead of player p in the same table.
local function ahead(run, p, many)
  local n, points = 0, run.scores[p]
  for q, other in ipairs(run.scores) do
    local same = not many or run.ships[q] == run.ships[p]
    if same and (other > points or other == points and q < p) then n = n + 1 end
  end
  return n
end

-- Returns the players whose scores enter a table, as { p, points, rank, row } each; row: the table's row without a name.
-- A game with one ship has one table for each mode and difficulty, other games have one for each ship, too.
function records.best(run, many)
  local list = {}
  for p, points in ipairs(run.scores) do
    local ship = many and run.ships[p] or nil
    local place, stage = rank(sys.score_table(run.difficulty, run.mode), ship, points), math.min(run.reached + 1, FEW)
    local row = { score = points, ship = ship, stage = stage, clear = run.clear, continues = math.min(run.continues, 15) }
    place = place and place + ahead(run, p, many)
    if place and place <= 10 then list[#list + 1] = { p = p, points = points, rank = place, row = row } end
  end
  return list
end

return records

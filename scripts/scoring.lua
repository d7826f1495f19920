-- scoring.lua - score.rule, score.count, score.tally: points beyond those of enemies and items. All counts are
-- registers of the players, so they are reset with each game and each practice attempt.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local MOST = 1000000000000 -- maximum points of one score.add
local EDGE = 2147483647    -- maximum value of a register

-- event -> the type of its entities
local EVENTS = { graze = "bullet", kill = "enemy", take = "item", death = false, bomb = false }
local rules = {} -- name -> list of rules
local names = {} -- names that score.count accepts
local made = 0   -- number of rules

local own = {} -- kind of player -> the meaning of its names

local function has(p, name)
  local kind = p.kind
  if not own[kind] then
    local list = sys.ship(kind).registers -- the run's registers are last
    own[kind] = { grazes = true, lives = true, score = true }
    for i = 1, #list - #sys.run_names() do own[kind][list[i].name] = true end
  end
  return own[kind][name]
end

-- Fails unless some ship has the register; for other ships it counts as 0. of: the rule or tally of the error,
-- { api, at }, with `at` as in sys.fail.
local function missing(name, of)
  for _, known in ipairs(sys.scoring.registers()) do
    if known == name then return 0 end
  end
  sys.unknown(of.api, "register", name, sys.scoring.registers(), of.at)
end

-- Returns the value of a name: player p's register or property, or the run's.
local function read(name, p, of) return has(p, name) and p[name] or sys.run(name) or missing(name, of) end

local function write(name, p, v, of)
  v = math.max(-EDGE, math.min(v, EDGE))
  if has(p, name) then
    p[name] = v
  elseif not sys.run_set(name, v) then
    missing(name, of)
  end
end

local function number(r, field, p, thing)
  local v = r[field]
  if type(v) == "string" then return read(v, p, r) end
  if type(v) == "function" then
    local n = v(p, thing)
    if type(n) ~= "number" or n ~= n then
      local got = n ~= n and "NaN" or type(n)
      sys.fail(r.api, ("%s: expected the function to return a number, got %s"):format(field, got), r.at)
    end
    return n
  end
  return v
end

local function whole(v) return math.tointeger(math.floor(math.max(-MOST, math.min(v, MOST)))) end

-- The points of a rule without `points`: those of the entity, times - 1, because it has already given them once.
local function reward(r, n, p, thing)
  local times = r.times and number(r, "times", p, thing) or 1
  if r.points then return number(r, "points", p, thing) * times * n end
  return r.times and thing and sys.worth(thing, p) * (times - 1) or 0
end

local function apply(r, n, p, thing)
  for name, by in pairs(r.gain or {}) do write(name, p, read(name, p, r) + by * n, r) end
  for name, of in pairs(r.most or {}) do write(name, p, math.max(read(name, p, r), read(of, p, r)), r) end
  local points = whole(reward(r, n, p, thing))
  if points ~= 0 then score.add(points, p) end
  for name, v in pairs(r.set or {}) do write(name, p, v, r) end
end

local function fire(list, n, p, thing)
  for _, r in ipairs(list) do
    if not r.kind or thing.kind == r.kind then apply(r, n, p, thing) end
  end
end

local function heard(event, list)
  if event == "kill" then
    return on.kill(function(e, p)
      if p then fire(list, 1, p, e) end
    end)
  end
  local kinds = EVENTS[event]
  on[event](function(p, thing) fire(list, 1, p, kinds and thing) end)
end

function score.rule(args)
  local a = sys.check("score.rule", args)
  local event = sys.read("scoring/rule")(a, EVENTS)
  if not rules[event] then
    rules[event] = {}
    if a.name then names[#names + 1] = a.name else heard(event, rules[event]) end
  end
  made = made + 1
  a.api, a.at = "score.rule", tostring(made)
  sys.note_place(a.api, a.at)
  table.insert(rules[event], a)
end

function score.count(name, n, p)
  local a = sys.check("score.count", name, n, p)
  if EVENTS[a.name] ~= nil or not rules[a.name] then sys.unknown("score.count", "rule", a.name, names) end
  local who = a.p <= 2 and player.get(math.tointeger(a.p)) or a.p
  if a.n > 0 and who.alive then fire(rules[a.name], a.n, who) end
end

-- ---- the tally at the end of a stage ----

local lines -- list of { label, value, points, stage, last }; nil: no tally is declared
local began -- player -> line -> value when the stage began

local function value(line, p)
  if type(line.value) == "function" then
    local n = line.value(p)
    if n == nil or type(n) == "boolean" or type(n) == "number" then return n end
    local text = '"%s": expected the function to return a number or true, got %s'
    sys.fail(line.api, text:format(line.label, type(n)), line.at)
  end
  return read(line.value, p, line)
end

function score.tally(list)
  lines = sys.read("scoring/tally")(sys.check("score.tally", list).list)
  sys.note_place("score.tally", "")
  on.stage(function(_, state)
    if state ~= "start" then return end
    began = { {}, {} }
    player.each(function(p)
      for i, line in ipairs(lines) do began[p.index][i] = line.stage and tonumber(value(line, p)) or 0 end
    end)
  end)
end

-- ---- for the results ----

sys.scoring = {}

-- The names that can be used: properties, the registers of all ships, and those of the run.
function sys.scoring.registers()
  local list, known = { "grazes", "lives", "score" }, {}
  for _, kind in ipairs(sys.kinds("player")) do
    for _, r in ipairs(sys.ship(kind).registers) do
      if not known[r.name] then list[#list + 1] = r.name end
      known[r.name] = true
    end
  end
  return list
end

-- Fails unless every register that is named exists on some ship.
function sys.scoring.expect() sys.read("scoring/expect")(rules, lines or {}, sys.scoring.registers()) end

-- Gives player p the points of the tally. last: the last stage was cleared. Returns the lines to show, a list of
-- { label, value, points }, or nil if no tally is declared. A line with a condition instead of a number has no value.
function sys.scoring.tally(p, last)
  local shown, since = {}, began and began[p.index] or {}
  if not lines then return end
  for i, line in ipairs(lines) do
    local n = (last or not line.last) and value(line, p)
    if n then
      local count = n == true and 1 or n - (since[i] or 0)
      local points = whole(count * line.points)
      shown[#shown + 1] = { label = line.label, value = n ~= true and count or nil, points = points }
      score.add(points, p)
    end
  end
  return shown
end

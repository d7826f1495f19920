-- boot/mission.lua - plays a mission and shows its result, until the player stops retrying.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local FEW <const> = 10 * 60 -- frames left from which on the clock is in the alarm colour

-- Returns the value that a goal or a measure counts, of the player or of the run.
local function count(name, p, age)
  if name == "kills" then return sys.missions.killed end
  if name == "frames" or name == "time" then return age end
  if name == "score" then return hud.score(1) end
  local n = sys.value(1, name)
  if n == nil then n = sys.run(name) end
  if n == nil and (name == "grazes" or name == "lives") then n = p[name] end
  return n or 0
end

local function reached(m, p, age)
  if type(m.goal) == "function" then return m.goal(p) == true end
  for name, n in pairs(m.goal or {}) do
    if count(name, p, age) < n then return false end
  end
  return true
end

-- The goal that is first by name, or nil.
local function first_goal(m)
  local first
  for name in pairs(type(m.goal) == "table" and m.goal or {}) do
    if not first or name < first then first = name end
  end
  return first
end

-- Returns n of a goal's count as "34/60", frames in seconds.
local function part_of(m, name, n)
  local unit = name == "frames" and 60 or 1
  return ("%d/%d"):format(math.min(n, m.goal[name]) // unit, m.goal[name] // unit)
end

-- Returns the progress of the first goal, "34/60", with the time left; and whether that is short.
local function progress(m, p, age)
  local first, words = first_goal(m), {}
  if first and first ~= "frames" then
    words[1] = part_of(m, first, count(first, p, age))
  elseif first then
    words[1] = ("%d"):format(math.max(0, m.goal[first] - age + 59) // 60)
  end
  local left = m.limit and m.limit - age
  if left then words[#words + 1] = ("%d:%02d"):format((left + 59) // 3600, (left + 59) // 60 % 60) end
  return table.concat(words, "  "), left and left <= FEW
end

local function draw(m, p, age)
  local words, late = progress(m, p, age)
  hud.note(words ~= "" and words or nil, late and hud.banks.alarm or hud.banks.bright)
end

-- Watches a mission until it is over. Returns whether the goal was reached, the frames it took, why it failed, and the
-- most that the first goal's count had.
local function watch(m, game, stopped)
  local p, age, cleared = player.get(1), 0, nil
  local first, most = first_goal(m), 0
  local piece = m.start(game, function(won) cleared = won end)
  local stop <close> = setmetatable({}, { __close = function() task.stop(piece) end })
  while not stopped() do
    local is_reached = reached(m, p, age)
    draw(m, p, age)
    most = first and math.max(most, count(first, p, age)) or most
    if m.bombs and sys.missions.bombed > m.bombs then
      return false, age, m.bombs == 0 and "You used a bomb" or "Too many bombs", most
    end
    if is_reached and not m.clear then return true, age end
    if not task.alive(piece) then
      local time_up = m.boss and m.clear and not cleared
      return m.clear and is_reached and (cleared or m.stage ~= nil), age, time_up and "Time up" or "Goal not reached", most
    end
    if m.limit and age >= m.limit then return false, age, "Time up", most end
    wait(1)
    age = age + 1
  end
  return false, age, m.lives == 1 and "You were hit" or "No lives left", most
end

local function begin(m, run, enter)
  local game = enter(run.ships)
  local p = player.get(1)
  sys.missions.killed, sys.missions.bombed = 0, 0
  p.lives = m.lives - 1
  for name, n in pairs(m.registers or {}) do
    if sys.value(1, name) then p[name] = n else sys.run_set(name, n) end
  end
  sys.mark("game", run.ships[1], nil, nil, 1)
  sys.mark("difficulty", board.difficulty())
  sys.mark("mission", m.name)
  hud.banner({ text.lang(m.title), text.lang(m.text or "") }, 150)
  return game
end

-- Plays the mission once. Returns how it was left ("restart", "quit"), or the answer of the result's screen.
local function try(m, run, host)
  local game = begin(m, run, host.enter)
  local done, age, reason, most = watch(m, game, host.stopped)
  local left, ship = host.left(), run.ships[1]
  local result = { mission = m.name, title = m.title, done = done, by = m.by, value = count(m.by, player.get(1), age) }
  result.goal, result.reason = m.text or "", reason
  result.progress = not done and first_goal(m) and part_of(m, first_goal(m), most) or ""
  if done then
    result.stars = sys.missions.stars(m, result.value)
    result.new = sys.missions.enter(m, result.value, ship)
  end
  result.best, result.most, result.ship = sys.missions.best(m)
  host.finish(done, 0)
  local answer = left
  if not left then
    host.quieten()
    hud.banner()
    task.stop(game) -- the HUD would write over the result
    sys.cue(done and "mission" or "failed")
    answer = host.show("mission", result)
  end
  host.leave(game, 1)
  return answer
end

-- run: mission and ships; host: functions of boot.lua.
return function(run, host)
  local m = sys.missions.get(run.mission)
  local answer
  repeat answer = try(m, run, host) until answer ~= "again" and answer ~= "restart"
end

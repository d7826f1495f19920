-- boot/front.lua - all that is before a game: the title and what can be looked at from there, demos while nobody comes,
-- and the choices.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local ATTRACT = 10 * 60 -- frames the title waits before it shows a demo
local SCORES = 6 * 60   -- frames the score table stands by itself

local function any_score()
  for _, name in ipairs(sys.difficulties()) do
    if score.rows(name)[1] then return true end
  end
end

local function any_spell()
  local found = false
  boss.each(function(b)
    for _, phase in ipairs(b.phases) do
      for _, name in ipairs(phase.spell and sys.difficulties() or {}) do
        found = found or sys.history(b.name, phase.id, 0, name) > 0
      end
    end
  end)
  return found
end

-- Where one can go from the title: what the game has, and what has something in it.
local function places(a)
  local list = { "start" }
  local missions = rawget(sys, "missions")
  if missions and missions.any() then list[2] = "missions" end
  if any_score() then list[#list + 1] = "scores" end
  if any_spell() then list[#list + 1] = "history" end
  if a.music then list[#list + 1] = "music" end
  local unlocks = rawget(sys, "unlock")
  if unlocks and unlocks.any() then list[#list + 1] = "unlocks" end
  for _, p in ipairs(a.pages or {}) do list[#list + 1] = p.name end
  list[#list + 1], list[#list + 2] = "replays", "settings"
  return list
end

local function expect_place(what, list)
  for _, place in ipairs(list) do
    if place == what then return end
  end
  local got = tostring(what)
  local said = 'screen title: expected one of %s, or nil, got "%s"%s'
  sys.fail("boot.run", said:format(table.concat(list, ", "), got, sys.hint(got, list)))
end

local function pressed(button) return pad.take(button, 0, 1) or pad.take(button, 0, 2) end

-- Nobody came: a demo, the next each time, then the scores. True: somebody pressed fire or START, and wants the menu.
local function attract(a, show)
  local demos = a.demos or { a.demo }
  if #demos > 0 then
    a.shown = (a.shown or 0) % #demos + 1
    board.attract(demos[a.shown])
    wait(1) -- and the board stands while it is shown; the press that ends it comes in the frame after
    if pressed("start") or pressed("fire") then return true end
  end
  a.told = show("scores", board.difficulty(), SCORES) == true
  return a.told
end

-- What is told before the title: once the power is on, and each time nobody came. True: START has ended it.
local function tell(a)
  if not a.opening then return false end
  text.clear()
  local scope, left = sys.scope(), false
  local teller = task.own(scope, a.opening)
  while task.alive(teller) and not left do
    wait(1)
    left = pressed("start")
  end
  task.stop(scope)
  sys.wipe()
  return left
end

-- The mission that is to be played, and with which ship; nil: back to the title. last: the one that was played before.
local function choose_mission(a, show, last, choices)
  while true do
    local name = show("missions", last)
    if name == nil then return nil end
    local m = sys.missions.get(name)
    if not m then
      sys.fail("boot.run", ('screen "missions": expected the name of a mission or nil, got "%s"'):format(tostring(name)))
    end
    if m.difficulty then board.difficulty(m.difficulty) end
    while m.difficulty or choices.difficulty(a, show) do
      local ships = m.ship and { m.ship } or choices.ships(a, show, 1)
      if ships then return { mission = name, stages = {}, ships = { ships[1] } } end
      if m.difficulty or #sys.difficulties() < 2 then break end
    end
    last = name
  end
end

-- The game's own page of that name, or nil.
local function page_of(a, name)
  for _, p in ipairs(a.pages or {}) do
    if p.name == name then return p end
  end
end

-- The title, and back to it, until somebody starts. Returns how many play, or a run of a mission. last: the mission that
-- was played before; its list comes first then.
local function wait_for_players(a, show, last, choices)
  local what, players, from = last and "missions", nil, nil -- from: the place of the list that one comes from
  while what ~= "start" do
    if not a.told then from = tell(a) and "start" or from end
    a.told = true
    local list = places(a)
    if last then last = nil else what, players = show("title", ATTRACT, list, from) end
    from = what
    if what == "missions" then
      expect_place(what, list)
      local run = choose_mission(a, show, a.mission, choices)
      if run then
        a.mission = run.mission
        return nil, run
      end
    elseif what == nil then
      from = attract(a, show) and "start" or nil
    elseif what == "replays" or what == "settings" then
      board.ask(what)
    elseif what ~= "start" and page_of(a, what) then
      show("page", page_of(a, what))
    elseif what ~= "start" then
      expect_place(what, list)
      show(what, what == "music" and a.music or what ~= "unlocks" and board.difficulty() or nil)
    end
  end
  return players or 1
end

-- The mode to be played; nil: back. Without modes it is one without a name.
local function choose_mode(a, show)
  if not a.modes then return { stages = a.stages } end
  if #a.modes == 1 then return a.modes[1] end
  local list, closed = {}, sys.read("boot/records").closed
  for i, mode in ipairs(a.modes) do
    local hint = closed(mode.needs)
    list[i] = { name = mode.name, text = hint or mode.text, closed = hint ~= nil }
  end
  local name = show("mode", list)
  for _, mode in ipairs(a.modes) do
    if mode.name == name then return mode end
  end
end

-- True when a difficulty is set; nil: back.
local function choose_difficulty(a, show)
  local names = sys.difficulties()
  if #names < 2 then return true end
  local name = show("difficulty", names, board.difficulty(), a.difficulties or {})
  return name and board.difficulty(name) ~= nil
end

-- Each player's ship; nil: back.
local function choose_ships(a, show, players)
  if #a.kinds > 1 then
    local ships = show("ship", a.players, players, a.ships or {})
    return type(ships) == "string" and { ships } or ships
  end
  local ships = {}
  for p = 1, players do ships[p] = a.kinds[1] end
  return ships
end

-- One choice after the other; nil from one goes back to the one before. Returns mode and ships, or nil.
local function choose(a, show, players)
  local mode, ships
  while true do
    mode = choose_mode(a, show)
    if not mode then return nil end
    while choose_difficulty(a, show) do
      ships = choose_ships(a, show, players)
      if ships then return mode, ships end
      if #sys.difficulties() < 2 then break end
    end
    if not a.modes or #a.modes < 2 then return nil end
  end
end

-- Until a game is to begin. Returns what is to be played: mode (a name, or nil), stages, ships; or a mission and ships.
-- last: the mission that was played before, or nil.
return function(a, show, last)
  local choices = { difficulty = choose_difficulty, ships = choose_ships }
  while true do
    local players, run = wait_for_players(a, show, last, choices)
    if run then return run end
    last = nil
    local mode, ships = choose(a, show, players)
    if mode then return { mode = mode.name, stages = mode.stages, ships = ships } end
  end
end

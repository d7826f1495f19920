-- boot/front.lua - everything before a run: the title and the pages that it opens, the attract demos, and the page on
-- which mode, difficulty and ships are chosen.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local ATTRACT <const> = 10 * 60 -- frames that the title waits before it shows a demo
local SCORES <const> = 6 * 60   -- frames that the attract mode shows the scores

local closed = sys.read("boot/records").closed

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

-- The entries of the title's menu: those that have content.
local function entries(a)
  local missions, unlocks = rawget(sys, "missions"), rawget(sys, "unlock")
  local list = { "start", "practice" }
  local function add(name, has_content)
    if has_content then list[#list + 1] = name end
  end
  add("missions", missions and missions.any())
  add("replays", true)
  add("scores", true)
  add("history", any_spell())
  add("music", a.music)
  add("unlocks", unlocks and unlocks.any())
  for _, p in ipairs(a.pages or {}) do add(p.name, true) end
  add("settings", true)
  add("how_to_play", true)
  add("quit", true)
  return list
end

local function expect_entry(what, list)
  for _, name in ipairs(list) do
    if name == what then return end
  end
  local got = tostring(what)
  local message = 'screen title: expected one of %s, or nil, got "%s"%s'
  sys.fail("boot.run", message:format(table.concat(list, ", "), got, sys.hint(got, list)))
end

local function pressed(button) return pad.take(button, 0, 1) or pad.take(button, 0, 2) end

-- Shows the next demo, then the scores. Returns true if a player pressed fire or START, which opens the menu.
local function attract(a, show)
  local demos = a.demos or { a.demo }
  if #demos > 0 then
    a.shown = (a.shown or 0) % #demos + 1
    board.attract(demos[a.shown])
    wait(1) -- the board is frozen during the demo; the press that ends it arrives one frame later
    if pressed("start") or pressed("fire") then return true end
  end
  a.opened = show("scores", board.difficulty(), SCORES) == true
  return a.opened
end

-- Plays the opening: after power-on, and after each attract mode that nobody ended. Returns true if START ended it.
local function play_opening(a)
  if not a.opening then return false end
  text.clear()
  local scope, ended = sys.scope(), false
  local opening = task.own(scope, a.opening)
  while task.alive(opening) and not ended do
    sys.tell_key("fire", "Next")
    sys.tell_key("start", "Skip")
    wait(1)
    ended = pressed("start")
  end
  task.stop(scope)
  sys.wipe()
  return ended
end

-- ---- the page start ----

local function list_modes(a)
  local list = {}
  for i, mode in ipairs(a.modes or {}) do
    list[i] = { name = mode.name, text = mode.text, closed = closed(mode.needs) }
  end
  return list
end

local function list_difficulties(a)
  local list = {}
  local texts = a.difficulties or {}
  for i, name in ipairs(sys.difficulties()) do list[i] = { name = name, text = texts[name] } end
  return list
end

-- Ships with their forms. A form that doesn't set text or figures has the ship's.
local function list_ships(a)
  local list = {}
  for i, kind in ipairs(a.players) do
    local about = a.ships and a.ships[kind] or {}
    local ship = { name = kind, title = about.title, text = about.text, figures = about.figures }
    ship.closed = closed(sys.ship(kind).needs)
    for k, f in ipairs(about.forms or {}) do
      ship.forms = ship.forms or {}
      ship.forms[k] = { name = f.kind, title = f.title, text = f.text or about.text,
                        figures = f.figures or about.figures, closed = closed(sys.ship(f.kind).needs) }
    end
    list[i] = ship
  end
  return list
end

local SAVES <const> = { mode = "last/mode", difficulty = "last/difficulty", ships = { "last/ship", "last/ship 2" } }

-- The choices of the last run, also after power-on.
local function last_choices()
  local ships = {}
  for p, key in ipairs(SAVES.ships) do ships[p] = save.get(key) end
  return { mode = save.get(SAVES.mode), difficulty = save.get(SAVES.difficulty) or board.difficulty(), ships = ships }
end

local function save_choices(modes, difficulties, a, choice)
  if #modes > 1 then save.set(SAVES.mode, choice.mode) end
  if #difficulties > 1 then save.set(SAVES.difficulty, choice.difficulty) end
  for p, kind in ipairs(#a.kinds > 1 and choice.ships or {}) do save.set(SAVES.ships[p], kind) end
end

local function only(list) return #list == 1 and list[1].name or nil end

-- The mode that the page start returned, out of the game's modes.
local function find_mode(a, name)
  if not a.modes then return { stages = a.stages } end
  local names = {}
  for i, mode in ipairs(a.modes) do
    if mode.name == name then return mode end
    names[i] = mode.name
  end
  sys.unknown("boot.run", "mode", tostring(name), names)
end

-- Fills in what has one option only, and what a game's own page start left out.
local function complete(a, choice, modes, difficulties, fixed, players)
  choice.mode = choice.mode or only(modes)
  choice.difficulty = fixed.difficulty or choice.difficulty or only(difficulties)
  choice.ships = choice.ships or {}
  for p = 1, players do choice.ships[p] = choice.ships[p] or fixed.ship or a.kinds[1] end
  return choice
end

-- Shows the page start, unless nothing is left to choose. fixed: a mission's title, and its difficulty, ship or modes.
-- Returns { mode, difficulty, ships }, or nil for back.
local function choose(a, show, players, fixed)
  local modes, difficulties = fixed.modes or list_modes(a), list_difficulties(a)
  local lists = {
    title = fixed.title,
    modes = #modes > 1 and modes or nil,
    difficulties = not fixed.difficulty and #difficulties > 1 and difficulties or nil,
    ships = fixed.ship and { { name = fixed.ship } } or list_ships(a),
  }
  local choice = {}
  if lists.modes or lists.difficulties or not fixed.ship and #a.kinds > 1 then
    choice = show("start", players, lists, last_choices())
  end
  if not choice then return nil end
  choice = complete(a, choice, modes, difficulties, fixed, players)
  if choice.difficulty then board.difficulty(choice.difficulty) end
  save_choices(modes, difficulties, a, choice)
  return choice
end

-- Returns the run of a mission, or nil for back to the title. last: the mission that was played before, or nil.
local function choose_mission(a, show, last)
  while true do
    local name = show("missions", last)
    if name == nil then return nil end
    local m = sys.missions.get(name)
    if not m then
      local message = 'screen "missions": expected the name of a mission or nil, got "%s"'
      sys.fail("boot.run", message:format(tostring(name)))
    end
    local choice = choose(a, show, 1, { title = m.title, difficulty = m.difficulty, ship = m.ship, modes = {} })
    if choice then return { mission = name, stages = {}, ships = choice.ships } end
    last = name
  end
end

-- ---- the title ----

-- The game's own page of that name, or nil.
local function page_of(a, name)
  for _, p in ipairs(a.pages or {}) do
    if p.name == name then return p end
  end
end

local ASKED <const> = { practice = true, replays = true, settings = true, quit = true }

-- Opens what was chosen in the title's menu, other than "start" and "missions".
local function open(a, show, what)
  if ASKED[what] then return board.ask(what) end
  if page_of(a, what) then return show("page", page_of(a, what)) end
  if what == "how_to_play" then return show(what, sys.read("boot/how_to_play")(a), a.kinds[1]) end
  show(what, what == "music" and a.music or what ~= "unlocks" and board.difficulty() or nil)
end

-- Shows the title and what is chosen there until a run starts. Returns the run. last: the mission that was played
-- before; the list of missions is shown first.
return function(a, show, last)
  local what, players, from = last and "missions", 1, a.played and "start" or nil -- from: the entry of the menu that the player returns from
  while true do
    if not last then
      local back = a.opened == nil and sys.at_title() -- from the program's settings or a replay: no opening
      if not a.opened then from = (back or play_opening(a)) and "start" or from end
      a.opened = true
      local list = entries(a)
      what, players = show("title", ATTRACT, list, from, players)
      if what then expect_entry(what, list) end
    end
    from, last = what, nil
    if what == nil then
      from = attract(a, show) and "start" or nil
    elseif what == "start" then
      local choice = choose(a, show, players or 1, {})
      local mode = choice and find_mode(a, choice.mode)
      a.played = choice and true or a.played
      if choice then return { mode = mode.name, stages = mode.stages, ships = choice.ships } end
    elseif what == "missions" then
      local run = choose_mission(a, show, a.mission)
      a.mission = run and run.mission or a.mission
      if run then return run end
    else
      open(a, show, what)
    end
  end
end

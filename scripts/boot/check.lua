-- boot/check.lua - checks the arguments of boot.run while the game loads, except players and stages (boot/args.lua).
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local SCREENS = {
  "title", "start", "continue", "results", "name", "ending", "staff", "scores", "again",
  "history", "music", "unlocks", "missions", "mission", "page", "how_to_play",
}

local MAX_TABLE <const> = 31 -- bytes of a score table's name, which is mode/difficulty
local MAX_PAUSE <const> = 8 -- entries of a game in the pause menu

local function fail(what, expected, got)
  sys.fail("boot.run", ("%s: expected %s, got %s"):format(what, expected, got))
end

-- Fails unless all keys of t are in names. what: the message's word for a key.
local function expect_names(what, t, names)
  local known = {}
  for _, name in ipairs(names) do known[name] = true end
  for _, key in ipairs(sys.keys(t)) do
    if not known[key] then
      sys.fail("boot.run", ('unknown %s "%s"%s'):format(what, tostring(key), sys.hint(tostring(key), names)))
    end
  end
end

local function expect_type(what, value, kind)
  if value ~= nil and type(value) ~= kind then fail(what, "a " .. kind, type(value)) end
end

local function expect_text(what, value, needed)
  if needed or value ~= nil then
    if type(value) ~= "string" then fail(what, "a string", type(value)) end
  end
end

local function expect_stages(what, list)
  if type(list) ~= "table" or #list == 0 then
    fail(what, "a list of at least one stage", type(list) == "table" and "none" or type(list))
  end
  for i = 1, #list do stage.expect("boot.run", tostring(list[i])) end
end

local function check_screens(screens)
  for _, name in ipairs { "mode", "difficulty", "ship" } do
    if screens[name] then
      local message = 'the screen "%s" was replaced by "start", which chooses mode, difficulty and ships'
      sys.fail("boot.run", message:format(name))
    end
  end
  expect_names("screen", screens, SCREENS)
  for name, f in pairs(screens) do expect_type("screen " .. name, f, "function") end
end

-- modes: a list of { name, stages, text?, needs? }.
local function check_modes(modes)
  if #modes == 0 then fail("modes", "a list of at least one mode", "none") end
  for i = 1, #modes do
    local mode = modes[i]
    local what = ("mode %d"):format(i)
    if type(mode) ~= "table" then fail(what, "a table", type(mode)) end
    expect_names("argument of a mode:", mode, { "name", "stages", "text", "needs" })
    expect_text(what .. ": name", mode.name, true)
    for _, difficulty in ipairs(i > 1 and sys.difficulties() or {}) do
      local left = MAX_TABLE - 1 - #difficulty
      if #mode.name > left then fail(what .. ": name", ("at most %d bytes"):format(left), #mode.name) end
    end
    expect_text(what .. ": text", mode.text)
    expect_text(what .. ": needs", mode.needs)
    expect_stages(('mode "%s": stages'):format(mode.name), mode.stages)
  end
end

local function check_difficulties(texts)
  expect_names("difficulty", texts, sys.difficulties())
  for name, words in pairs(texts) do expect_text("difficulty " .. name, words) end
end

local function check_figures(what, figures)
  for i = 1, #figures do
    local f = figures[i]
    local good = type(f) == "table" and type(f[1]) == "string" and math.type(f[2]) == "integer"
    if not good or f[2] < 0 or f[2] > 5 then
      local got = type(f) == "table" and "another" or type(f)
      fail(what .. ": figures", 'a list of { "Range", 0 to 5 }', got)
    end
  end
end

-- The arguments that ships and forms share.
local function check_told(what, told)
  expect_text(what .. ": title", told.title)
  expect_text(what .. ": text", told.text)
  expect_type(what .. ": figures", told.figures, "table")
  check_figures(what, told.figures or {})
end

-- The forms of a ship, each of a kind of player: a list of { kind, title?, text?, figures? }.
local function check_forms(ship, forms)
  expect_type(ship .. ": forms", forms, "table")
  if #forms == 0 then fail(ship .. ": forms", "a list of at least one form", "none") end
  local kinds, known = sys.kinds("player"), {}
  for _, kind in ipairs(kinds) do known[kind] = true end
  for i = 1, #forms do
    local form = forms[i]
    local what = ("%s: form %d"):format(ship, i)
    if type(form) ~= "table" then fail(what, "a table", type(form)) end
    expect_names(("argument of %s:"):format(what), form, { "kind", "title", "text", "figures" })
    expect_text(what .. ": kind", form.kind, true)
    if not known[form.kind] then sys.unknown("boot.run", what .. ": player", form.kind, kinds) end
    check_told(what, form)
  end
end

local function check_ships(ships, players)
  expect_names("ship", ships, players)
  for kind, ship in pairs(ships) do
    expect_type("ship " .. kind, ship, "table")
    expect_names(("argument of ship %s:"):format(kind), ship, { "title", "text", "figures", "forms" })
    check_told("ship " .. kind, ship)
    if ship.forms ~= nil then check_forms("ship " .. kind, ship.forms) end
  end
end

local RUN = { "mode", "difficulty", "ship", "players", "continues" }

-- Checks for which runs an ending or a section of the staff roll is: values of some fields in RUN, or a function.
local function check_when(what, of, when)
  if type(when) == "function" then return end
  expect_type(what .. ": when", when, "table")
  expect_names("condition of " .. of .. ":", when or {}, RUN)
end

-- endings: a function, or a list of { show, when?, music? }.
local function check_endings(ending)
  if type(ending) == "function" then return end
  if type(ending) ~= "table" then fail("ending", "a function or a list", type(ending)) end
  for i = 1, #ending do
    local e = ending[i]
    if type(e) ~= "table" then fail(("ending %d"):format(i), "a table", type(e)) end
    expect_names("argument of an ending:", e, { "when", "show", "music" })
    if type(e.show) ~= "function" then fail(("ending %d: show"):format(i), "a function", type(e.show)) end
    check_when(("ending %d"):format(i), "an ending", e.when)
  end
end

local function check_staff(parts)
  for i = 1, #parts do
    local part = parts[i]
    local what = ("staff %d"):format(i)
    if type(part) ~= "table" then fail(what, 'a list of strings such as { "Art", "A. Name" }', type(part)) end
    for k = 1, #part do expect_text(("%s: text %d"):format(what, k), part[k], true) end
    check_when(what, "the staff", part.when)
  end
end

-- pages: a list of { name, show }. A page is an entry of the main menu and can't have the name of another entry.
local function check_pages(pages)
  local known = { practice = true, replays = true, settings = true, quit = true }
  for _, name in ipairs(SCREENS) do known[name] = true end
  for i = 1, #pages do
    local p = pages[i]
    local what = ("page %d"):format(i)
    if type(p) ~= "table" then fail(what, 'a table such as { name = "how to score", show = f }', type(p)) end
    expect_names("argument of a page:", p, { "name", "show" })
    expect_text(what .. ": name", p.name, true)
    if known[p.name] then sys.fail("boot.run", ('%s: "%s" is used twice'):format(what, p.name)) end
    if type(p.show) ~= "function" then fail(('page "%s": show'):format(p.name), "a function", type(p.show)) end
    known[p.name] = true
  end
end

local HOW_TO_PLAY <const> = { "move", "fire", "focus", "bomb", "graze" } -- the library's pages
local BUTTONS <const> = { "up", "down", "left", "right", "fire", "bomb", "focus", "special", "start", "select" }

local function check_how_to_play_page(p, what)
  if type(p) == "string" then
    expect_names("page of how_to_play:", { [p] = true }, HOW_TO_PLAY)
  else
    if type(p) ~= "table" then fail(what, "a table or the name of a page", type(p)) end
    expect_names(("argument of %s:"):format(what), p, { "title", "text", "button", "gauges", "show" })
    expect_text(what .. ": title", p.title, true)
    expect_text(what .. ": text", p.text, true)
    if p.button then expect_names("button of how_to_play:", { [p.button] = true }, BUTTONS) end
    expect_type(what .. ": gauges", p.gauges, "table")
    for i, name in ipairs(p.gauges or {}) do expect_text(("%s: gauge %d"):format(what, i), name, true) end
    expect_type(what .. ": show", p.show, "function")
  end
end

-- how_to_play: a list of { title, text, button, show } and names of the library's pages.
local function check_how_to_play(list)
  if #list == 0 then fail("how_to_play", "a list of at least one page", "none") end
  for i = 1, #list do check_how_to_play_page(list[i], ("how_to_play: page %d"):format(i)) end
end

-- pause: a list of { label, function }.
local function check_pause(pause)
  if #pause > MAX_PAUSE then fail("pause", ("at most %d entries"):format(MAX_PAUSE), #pause) end
  for i = 1, #pause do
    local entry = pause[i]
    local what = ("pause %d"):format(i)
    if type(entry) ~= "table" then fail(what, 'a table such as { "Map", show_map }', type(entry)) end
    expect_text(what .. ": label", entry[1], true)
    if type(entry[2]) ~= "function" then fail(('pause "%s"'):format(entry[1]), "a function", type(entry[2])) end
  end
end

local function check_demos(demos)
  for i = 1, #demos do expect_text(("demos: %d"):format(i), demos[i], true) end
end

return function(a)
  if a.screens then check_screens(a.screens) end
  if a.modes then check_modes(a.modes) end
  if a.difficulties then check_difficulties(a.difficulties) end
  if a.ships then check_ships(a.ships, a.players) end
  if a.ending then check_endings(a.ending) end
  if a.staff then check_staff(a.staff) end
  if a.demos then check_demos(a.demos) end
  if a.pause then check_pause(a.pause) end
  if a.pages then check_pages(a.pages) end
  if a.how_to_play then check_how_to_play(a.how_to_play) end
  if a.music then sys.read("boot/music")(a) end
end

-- screens/start.lua - the page before a run: mode, difficulty, and each player's ship and form, one row each. The ships
-- fire their shots below the rows.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page, preview = sys.read("menu/page"), sys.read("menu/preview")

local CELLS <const> = 5                    -- length of a figure's bar, and the icons that fit into one
local PREVIEW <const> = 7                  -- rows below the panel for the ships, at least
local WIDEST <const> = 26                  -- columns for one of two players
local BLINK <const> = 16                   -- frames that the arrows keep their colour
local BURST <const>, PAUSE <const> = 90, 40 -- frames that the ships fire, and don't
local LIFE <const>, STAR <const> = hud.glyph(137, "*"), hud.glyph(138, "*")
local LEFT <const>, RIGHT <const> = hud.glyph(139, "<"), hud.glyph(140, ">")

-- The page's state: rows, cursor, age (frames since the last change), players, ships (by name of the kind).
local state

-- ---- rows ----
-- A row has a label, the chosen index per player (at) and options(p): the list of player p. A row that is not `each` is
-- shared by the players.

local function add_row(label, list, each)
  local row = { label = text.lang(label), at = { 1, 1 }, each = each, options = function() return list end }
  state.rows[#state.rows + 1] = row
  return row
end

local function option(row, p) return row.options(p)[row.at[p]] end

local function first_open(list)
  for i, o in ipairs(list) do
    if not o.closed then return i end
  end
  return 1
end

-- The index of an option by name if it is open; otherwise of the first open one.
local function index_of(list, name)
  for i, o in ipairs(list) do
    if o.name == name and not o.closed then return i end
  end
  return first_open(list)
end

-- A ship is known by its own kind or by that of one of its forms.
local function find_ship(list, kind)
  for i, ship in ipairs(list) do
    for k, form in ipairs(ship.forms or {}) do
      if form.name == kind and not form.closed and not ship.closed then return i, k end
    end
  end
  return index_of(list, kind), nil
end

local function add_shared(label, list, last)
  if not list then return nil end
  local row = add_row(label, list, false)
  row.at[1] = index_of(list, last)
  row.at[2] = row.at[1]
  return row
end

-- The row of forms follows that of the ships: it has the forms of the chosen ship.
local function add_ships(list, last)
  local ships = add_row("SHIP", list, true)
  local has_forms = false
  for _, ship in ipairs(list) do has_forms = has_forms or ship.forms ~= nil end
  local forms = has_forms and add_row("FORM", {}, true) or nil
  if forms then
    forms.options = function(p)
      local ship = option(ships, p)
      return not ship.closed and ship.forms or {}
    end
  end
  for p = 1, state.players do
    local i, k = find_ship(list, last[p])
    ships.at[p] = i
    if forms then forms.at[p] = k or first_open(forms.options(p)) end
  end
  if #list == 1 then table.remove(state.rows, #state.rows - (forms and 1 or 0)) end -- only its picture is shown
  return ships, forms
end

-- The form, or the ship without forms, that player p has chosen.
local function ship_of(p) return state.forms and option(state.forms, p) or option(state.ships, p) end

-- ---- what is drawn ----

local function label_of(o) return o.closed and "? ? ?" or menu.label(o.title or o.name) end

-- The figures of a kind, as { label, cells } each: those that the author gives, or speed, lives and the registers that
-- the HUD shows as icons.
local function figures_of(o)
  local list = {}
  if o.closed then return list end
  for i, f in ipairs(o.figures or {}) do list[i] = { text.lang(f[1]), STAR:rep(f[2]) } end
  if o.figures then return list end
  local s = sys.ship(o.name)
  list[1] = { text.lang("SPEED"), hud.bar(s.speed, state.fastest, CELLS) }
  list[2] = { text.lang("FOCUS"), hud.bar(s.focus, state.fastest, CELLS) }
  list[3] = { text.lang("LIVES"), s.lives > CELLS and "x" .. s.lives or LIFE:rep(s.lives) }
  for _, r in ipairs(s.registers) do
    if r.show == "icons" and r.value > 0 then
      list[#list + 1] = { menu.label(r.name), STAR:rep(math.min(r.value, CELLS)) }
    end
  end
  return list
end

local function each_kind(f)
  for _, ship in ipairs(state.ships.options(1)) do
    for _, o in ipairs(ship.forms or { ship }) do f(o) end
  end
end

-- Calls f for each option of a row, of all ships.
local function each_option(row, f)
  if row == state.forms then return each_kind(f) end
  for _, o in ipairs(row.options(1)) do f(o) end
end

local function column(p)
  return page.column(p, state.players, WIDEST)
end

local function text_cols(row)
  local _, cols = column(1)
  return math.max(1, (row.each and cols or page.cols) - 2)
end

-- The rows that the longest text and the longest list of figures take.
local function measure()
  state.text_rows, state.figure_rows, state.label, state.value, state.fastest = 0, 0, 0, 0, 1
  each_kind(function(o) state.fastest = math.max(state.fastest, sys.ship(o.name).speed) end)
  for _, row in ipairs(state.rows) do
    state.label = math.max(state.label, sys.cells(row.label))
    each_option(row, function(o)
      state.value = math.max(state.value, sys.cells(label_of(o)))
      local words = o.closed or o.text
      local n = words and #hud.wrap(text.lang(words), text_cols(row)) or 0
      state.text_rows = math.max(state.text_rows, n)
    end)
  end
  if state.players == 1 then
    each_kind(function(o) state.figure_rows = math.max(state.figure_rows, #figures_of(o)) end)
  end
  state.value = math.min(state.value, page.cols - state.label - 8)
end

local function fit(s, cols) return hud.wrap(s, math.max(1, cols))[1] end

-- Draws `s` in the middle of some columns, between arrows if it can be changed now.
local function draw_value(row, s, bank, arrows, col, cols)
  hud.put(col + (cols - sys.cells(s)) // 2, row, s, bank)
  if not arrows then return end
  local blink = state.age // BLINK % 2 == 0 and hud.banks.bright or hud.banks.plain
  hud.put(col, row, LEFT, blink)
  hud.put(col + cols - 1, row, RIGHT, blink)
end

local function draw_row(i, row, at, bank)
  local chosen = i == state.cursor
  page.clear(at, 1)
  if row.each and state.players > 1 then
    for p = 1, state.players do
      local o, col, cols = option(row, p), column(p)
      local s = o and fit(label_of(o), cols - 4) or "-"
      draw_value(at, s, o and bank or hud.banks.faint, chosen and #row.options(p) > 1, col + 1, cols - 2)
    end
    return
  end
  local o, cols = option(row, 1), state.value + 4
  local col = page.col + (page.cols - state.label - 2 - cols) // 2
  hud.put(col, at, row.label, bank)
  local s, arrows = o and fit(label_of(o), state.value) or "-", chosen and #row.options(1) > 1
  draw_value(at, s, bank, arrows, col + state.label + 2, cols)
end

local function draw_rows()
  for i, row in ipairs(state.rows) do
    local bank = page.bank(i, state.shown, i == state.cursor and hud.banks.bright or hud.banks.plain)
    if bank then draw_row(i, row, state.top + (i - 1) * state.gap, bank) end
  end
end

local function draw_texts()
  local row = state.rows[state.cursor]
  page.clear(state.text, state.text_rows * state.apart)
  for p = 1, row.each and state.players or 1 do
    local o = option(row, p)
    local words = o and (o.closed or o.text)
    local col, cols = page.col, page.cols
    if row.each then col, cols = column(p) end
    if words then page.text(state.text, words, hud.banks[o.closed and "faint" or "plain"], col, cols, state.apart) end
  end
end

local function draw_figures()
  page.clear(state.figures, state.figure_rows)
  if state.players > 1 then
    for p = 1, 2 do
      local col, cols = column(p)
      page.centre(state.figures - 1, text.lang("PLAYER %d"):format(p), hud.banks.plain, col, cols)
    end
  end
  local o = ship_of(1)
  local list, widest = state.figure_rows > 0 and figures_of(o) or {}, 0
  for _, f in ipairs(list) do widest = math.max(widest, sys.cells(f[1])) end
  local col = page.col + (page.cols - widest - 1 - CELLS) // 2
  for i, f in ipairs(list) do
    hud.put(col, state.figures + i - 1, f[1], hud.banks.plain)
    hud.put(col + widest + 1, state.figures + i - 1, f[2], hud.banks.bright)
  end
end

-- ---- the ships ----

-- Where ship p is, in pixels of the field.
local function place_of(p)
  local col, cols = column(p)
  return (2 * col + cols) * 4 - rom.field.x, (state.figures - (state.players > 1 and 4 or 3)) * 8 - rom.field.y
end

-- Shows the ships that are chosen now; one that is closed is not shown.
local function show_ships()
  for p = 1, state.players do
    local o = ship_of(p)
    local kind = not (option(state.ships, p).closed or o.closed) and o.name or nil
    if kind ~= state.kinds[p] then
      if kind then preview.ship(p, kind, place_of(p)) else preview.hide(p) end
      state.kinds[p] = kind
    end
  end
end

local function fly()
  local fires = state.shown % (BURST + PAUSE) < BURST
  for p = 1, state.players do
    preview.place(p, place_of(p))
    if fires then preview.hold(p, "fire") else preview.hold(p) end
  end
  preview.step()
end

-- ---- buttons ----

local function turn(row, p, step)
  local n = #row.options(p)
  if step == 0 or n < 2 then return false end
  row.at[p] = (row.at[p] - 1 + step) % n + 1
  if row == state.ships and state.forms then state.forms.at[p] = first_open(state.forms.options(p)) end
  if not row.each then row.at[2] = row.at[1] end
  return true
end

-- True if a button changed something.
local function move()
  local row, step = state.rows[state.cursor], page.step("up", "down")
  if step ~= 0 and #state.rows > 1 then
    state.cursor = (state.cursor - 1 + step) % #state.rows + 1
    return true
  end
  if not row.each or state.players == 1 then return turn(row, 1, page.step("left", "right")) end
  local one = turn(row, 1, page.step("left", "right", 1))
  return turn(row, 2, page.step("left", "right", 2)) or one
end

-- The row of a choice that is closed, or nil.
local function closed_row()
  for i, row in ipairs(state.rows) do
    for p = 1, row.each and state.players or 1 do
      local o = option(row, p)
      if o and o.closed then return i end
    end
  end
end

-- Runs until the page is answered. Returns true to start.
local function ask()
  local idle = 0
  while idle < page.IDLE do
    if page.opening(state.shown, #state.rows) or state.age == 0 or state.age % BLINK == 0 then
      page.head("START", state.shown)
      page.foot("FIRE: START  BOMB: BACK", state.shown)
      draw_rows()
    end
    if state.age == 0 then
      show_ships()
      draw_texts()
      draw_figures()
    end
    if state.bar then page.glide(state.bar, state.top + (state.cursor - 1) * state.gap, state.shown == 0) end
    fly()
    sys.tell_keys()
    wait(1)
    idle, state.age, state.shown = idle + 1, state.age + 1, state.shown + 1
    if move() then
      sys.cue("menu")
      idle, state.age = 0, 0
    end
    if page.accepted() then
      local closed = closed_row()
      sys.cue(closed and "wrong" or "select")
      if not closed then return true end
      state.cursor, state.age = closed, 0 -- its text says how to open it
    elseif page.pressed("bomb") then
      sys.cue("back")
      return false
    end
  end
  return false
end

-- Makes room for the ships: the lines of the texts move together, then the figures go, then the choices move together.
local function lay_out()
  measure()
  local foot = page.row + page.rows - (page.low and 2 or 4)
  local pad = page.low and 0 or 1
  local bottom
  state.top = page.head("START", 0)
  for tight = 0, 3 do
    state.gap, state.apart = tight < 3 and 2 or 1, tight < 1 and 2 or 1
    if tight == 2 then state.figure_rows = 0 end
    state.figures = foot - 1 - state.figure_rows
    state.text = state.top + #state.rows * state.gap + pad
    bottom = state.text + state.text_rows * state.apart + 1
    if state.figures - bottom >= PREVIEW then break end
  end
  page.panel(bottom)
  state.bar = state.gap > 1 and page.bar(page.col + 1, state.top, page.cols - 2, state.gap) or nil
end

local function answer(mode, difficulty)
  local choice = { ships = {} }
  choice.mode, choice.difficulty = mode and option(mode, 1).name, difficulty and option(difficulty, 1).name
  for p = 1, state.players do choice.ships[p] = ship_of(p).name end
  return choice
end

-- players: how many choose. lists: modes, difficulties and ships, each a list of { name, title?, text?, closed? },
-- where closed is the hint of a locked one; modes and difficulties are nil if there is nothing to choose; ships can
-- have figures and forms. last: mode, difficulty and ships of the last run. Returns mode, difficulty and ships by
-- name, or nil for back.
return function(players, lists, last)
  text.clear()
  state = { rows = {}, players = players, cursor = 1, age = 0, shown = 0, kinds = {} }
  local mode = add_shared("MODE", lists.modes, last.mode)
  local difficulty = add_shared("DIFFICULTY", lists.difficulties, last.difficulty)
  state.ships, state.forms = add_ships(lists.ships, last.ships)
  lay_out()
  local choice = ask() and answer(mode, difficulty) or nil
  if state.bar then state.bar:remove() end
  preview.close()
  page.done()
  return choice
end

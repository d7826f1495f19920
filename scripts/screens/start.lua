-- screens/start.lua - the page before a run: mode, difficulty, and each player's ship and form, one row each. The ships
-- fire their shots below the rows.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page, preview = sys.read("menu/page"), sys.read("menu/preview")

local CELLS <const> = 5                    -- length of a figure's bar, and its most icons
local PREVIEW <const> = hud.full and 5 or 6 -- rows below the panel for the ships, at least
local EDGE <const> = 24                    -- px from the middle of a ship to the edge of the field, at least
local WIDEST <const> = 26                  -- columns of a player
local TEXT <const> = math.min(WIDEST, page.cols - 4) -- columns of text
local PITCH <const> = page.low and 1.25 or hud.full and 1.75 or 1.5 -- rows from one figure to the next, at least
-- Rows from one choice to the next, and from one line of text to the next, on a full page.
local CLOSE <const>, TIGHT <const> = hud.full and 1.75 or 1.5, hud.full and 1.5 or 1.25
local BLINK <const> = 16                   -- frames that the arrows keep their colour
local BURST <const>, PAUSE <const> = 90, 40 -- frames that the ships fire, and don't
local LIFE <const> = hud.glyph(137, "*")
local LEFT <const>, RIGHT <const> = hud.glyph(139, "<"), hud.glyph(140, ">")
local KEYS <const> = { "fire", "Start", "bomb", "Back" }
local INSET <const> = page.low and 0 or 1  -- columns of the page outside the panel, at each side

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
  local ships = add_row("Ship", list, true)
  local has_forms = false
  for _, ship in ipairs(list) do has_forms = has_forms or ship.forms ~= nil end
  local forms = has_forms and add_row("Shot", {}, true) or nil
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

local function label_of(o)
  return o.closed and "? ? ?" or o.title and text.lang(o.title) or menu.label(o.name)
end

-- What is said of an option: its text, or how to unlock it.
local function words_of(o)
  return o.closed and page.how_to_unlock(o.closed) or o.text and text.lang(o.text)
end

local function name_of(p) return text.lang("%dP"):format(p) end

-- The texts about a row's options that are chosen, each with its bank. If players' texts differ, each starts with the
-- player's name.
local function texts_of(row)
  local list = {}
  for p = 1, row.each and state.players or 1 do
    local o = option(row, p)
    list[p] = { o and words_of(o) or "", o and o.closed and "faint" or "plain" }
  end
  if list[2] and list[1][1] == list[2][1] then list[2] = nil end
  for p, t in ipairs(list[2] and list or {}) do t[1] = name_of(p) .. ": " .. t[1] end
  return list
end

-- The figures of a kind, as { label, value } each, where a number is a number of stars: those that the author gives, or
-- speed, lives and the registers that the HUD shows as icons.
local function figures_of(o)
  local list = {}
  if o.closed then return list end
  for i, f in ipairs(o.figures or {}) do list[i] = { text.lang(f[1]), f[2] } end
  if o.figures then return list end
  local s = sys.ship(o.name)
  list[1] = { text.lang("Speed"), hud.bar(s.speed, state.fastest, CELLS) }
  list[2] = { text.lang("Focus"), hud.bar(s.focus, state.fastest, CELLS) }
  list[3] = { text.lang("Lives"), s.lives > CELLS and "x" .. s.lives or LIFE:rep(s.lives) }
  for _, r in ipairs(s.registers) do
    if r.show == "icons" and r.value > 0 then
      list[#list + 1] = { menu.label(r.name), math.min(r.value, CELLS) }
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

-- Returns the first column and the width of player p's part of the page. The labels of the rows that both players have
-- are between two parts.
local function column(p)
  if state.players == 1 then return page.column(1, 1, WIDEST) end
  local side = (page.cols - state.middle) / 2
  local cols = math.min(WIDEST, math.floor(side) - INSET)
  return p == 1 and side - cols or page.cols - side, cols
end

local function is_shared(row) return not row.each or state.players == 1 end

-- Measures the labels and values of rows, and the longest text and list of figures.
local function measure()
  state.text_rows, state.figure_rows, state.fastest = 0, 0, 1
  state.label, state.shared_value, state.middle, state.own_value = 0, 0, 0, 0 -- columns
  each_kind(function(o) state.fastest = math.max(state.fastest, sys.ship(o.name).speed) end)
  for _, row in ipairs(state.rows) do
    local key = is_shared(row) and "label" or "middle"
    state[key] = math.max(state[key], sys.cells(row.label))
  end
  for _, row in ipairs(state.rows) do
    local values = is_shared(row) and "shared_value" or "own_value"
    local head, times = is_shared(row) and "" or name_of(1) .. ": ", is_shared(row) and 1 or state.players
    each_option(row, function(o)
      state[values] = math.max(state[values], sys.cells(label_of(o)))
      local words = words_of(o)
      local n = words and #hud.wrap(head .. words, TEXT) or 0
      state.text_rows = math.max(state.text_rows, n * times)
    end)
  end
  each_kind(function(o) state.figure_rows = math.max(state.figure_rows, #figures_of(o)) end)
  state.shared_value = math.min(state.shared_value, page.cols - state.label - 8)
end

local function fit(s, cols) return hud.wrap(s, math.max(1, cols))[1] end

-- Draws player p's option of a row in the middle of some columns, between arrows if it can be changed now.
local function draw_value(row, p, at, bank, col, cols)
  local o = option(row, p)
  local s = o and fit(label_of(o), cols - 2) or "-"
  hud.put(col + (cols - sys.cells(s)) / 2, at, s, o and bank or hud.banks.faint)
  if row ~= state.rows[state.cursor] or #row.options(p) < 2 then return end
  local blink = state.age // BLINK % 2 == 0 and hud.banks.bright or hud.banks.plain
  hud.put(col, at, LEFT, blink)
  hud.put(col + cols - 1, at, RIGHT, blink)
end

local function draw_row(row, bank)
  page.clear(row.place, 1)
  if is_shared(row) then
    local cols = state.shared_value + 4
    local col = (page.cols - state.label - 2 - cols) // 2
    hud.put(col, row.place, row.label, bank)
    return draw_value(row, 1, row.place, bank, col + state.label + 2, cols)
  end
  page.centre(row.place, row.label, bank)
  for p = 1, state.players do
    local col, cols = column(p)
    local part, inside = math.min(cols - 1, state.own_value + 3), INSET + 1 -- the arrows are in the bar
    local first = math.max(inside, math.min(page.cols - inside - part, col + (cols - part) / 2))
    draw_value(row, p, row.place, bank, first, part)
  end
end

local function draw_rows()
  for i, row in ipairs(state.rows) do
    local bank = page.bank(i, state.shown, i == state.cursor and hud.banks.bright or hud.banks.plain)
    if bank then draw_row(row, bank) end
  end
  for p = 1, state.heads and state.players or 0 do
    local col, cols = column(p)
    page.centre(state.heads, name_of(p), hud.banks.faint, col, cols)
  end
end

local function draw_texts()
  local row = state.rows[state.cursor]
  page.clear(state.text, state.text_rows * state.apart)
  local list, n = texts_of(row), 0
  for _, t in ipairs(list) do
    t.lines = t[1] ~= "" and page.wrap(t[1], TEXT) or {}
    n = n + #t.lines
  end
  local at = state.text + (state.text_rows - n) * state.apart / 2
  for _, t in ipairs(list) do
    for _, line in ipairs(t.lines) do
      hud.put((page.cols - sys.cells(line)) / 2, at, line, hud.banks[t[2]])
      at = at + state.apart
    end
  end
end

-- The x of ship p and its figures: the middle of its part of the page, but in the field.
local function middle_of(p)
  local col, cols = column(p)
  local left, right = rom.view.x + EDGE, rom.view.x + rom.view.w - EDGE
  return math.max(left, math.min(right, (2 * col + cols) * 4))
end

local function draw_figures()
  page.clear(state.figures, state.figure_rows * state.pitch)
  for p = 1, state.figure_rows > 0 and state.players or 0 do
    local list, widest, _, cols = figures_of(ship_of(p)), 0, column(p)
    for _, f in ipairs(list) do widest = math.max(widest, sys.cells(f[1])) end
    widest = math.min(widest, cols - 1 - CELLS)
    local col = middle_of(p) / 8 - (widest + 1 + CELLS) / 2
    for i, f in ipairs(list) do
      local row, at = state.figures + (i - 1) * state.pitch, col + widest + 1
      hud.put(col, row, fit(f[1], widest), hud.banks.plain)
      if type(f[2]) == "number" then page.stars(at, row, f[2], CELLS) else hud.put(at, row, f[2], hud.banks.bright) end
    end
  end
end

-- ---- the ships ----

-- Where ship p is in the field.
local function place_of(p) return sys.to_field(middle_of(p), state.ship_row * 8) end

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

-- Leaves nothing chosen in a row that is locked.
local function open_row(row)
  for p = 1, 2 do
    local o = option(row, p)
    if o and o.closed then
      row.at[p] = first_open(row.options(p))
      if row == state.ships and state.forms then state.forms.at[p] = first_open(state.forms.options(p)) end
    end
  end
end

-- True if a button changed something.
local function move()
  local row, step = state.rows[state.cursor], page.step("up", "down")
  if step ~= 0 and #state.rows > 1 then
    open_row(row) -- what is locked is only looked at
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
      page.head(state.title, state.shown)
      page.foot(closed_row() and page.BACK or KEYS)
      draw_rows()
    end
    if state.age == 0 then
      show_ships()
      draw_texts()
      draw_figures()
    end
    if state.bar then page.glide(state.bar, state.rows[state.cursor].place, state.shown == 0) end
    fly()
    page.tell(closed_row() and page.BACK or KEYS, state.players)
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

-- Gives each row its place, and `heads` that of the players' names above the rows that both have. Returns the row below.
local function place_rows(gap)
  local at, heads = page.head(state.title, 0), nil
  for _, row in ipairs(state.rows) do
    if not is_shared(row) and not heads then
      heads = at + gap / 2 - 0.5
      at = heads + math.min(gap, 1.5)
    end
    row.place, at = at, at + gap
  end
  state.heads = heads
  return math.ceil(at)
end

-- How the page makes room for the ships, step by step: rows from one choice to the next, rows from one line of text to
-- the next, and whether the figures are shown.
local STEPS <const> = {
  { 2, page.pitch, true }, { 2, TIGHT, true }, { CLOSE, TIGHT, true }, { CLOSE, TIGHT, false }, { 1, 1, false },
}

local function lay_out()
  measure()
  local bottom, gap
  for _, step in ipairs(STEPS) do
    gap, state.apart, state.pitch = step[1], step[2], math.max(PITCH, step[2])
    if not step[3] then state.figure_rows = 0 end
    state.figures = page.rows - 3 - state.figure_rows * state.pitch
    state.text = place_rows(gap) + (page.low and 0 or 1)
    bottom = math.ceil(state.text + state.text_rows * state.apart) + 1
    if state.figures - bottom >= PREVIEW then break end
  end
  state.ship_row = state.figures - math.max(3, math.min(5, (state.figures - bottom) * 3 // 5))
  page.panel(bottom)
  local edge = state.players == 1 and 2 or 1.5
  state.bar = gap > 1 and page.bar(page.col + edge, state.rows[1].place, page.cols - 2 * edge, gap) or nil
end

local function answer(mode, difficulty)
  local choice = { ships = {} }
  choice.mode, choice.difficulty = mode and option(mode, 1).name, difficulty and option(difficulty, 1).name
  for p = 1, state.players do choice.ships[p] = ship_of(p).name end
  return choice
end

-- players: how many choose. lists: modes, difficulties and ships, each a list of { name, title?, text?, closed? },
-- where closed is the hint of a locked one; modes and difficulties are nil if there is nothing to choose; ships can
-- have figures and forms; title: the heading, default Start. last: mode, difficulty and ships of the last run. Returns
-- mode, difficulty and ships by name, or nil for back.
return function(players, lists, last)
  text.clear()
  state = { title = lists.title or "Start", rows = {}, players = players, cursor = 1, age = 0, shown = 0, kinds = {} }
  local mode = add_shared("Mode", lists.modes, last.mode)
  local difficulty = add_shared("Difficulty", lists.difficulties, last.difficulty)
  state.ships, state.forms = add_ships(lists.ships, last.ships)
  lay_out()
  local choice = ask() and answer(mode, difficulty) or nil
  if state.bar then state.bar:remove() end
  preview.close()
  page.done()
  return choice
end

-- hud.lua - what the screen shows during play: scores, lives, registers, the boss's rows and banners. Menus use its
-- helpers for text. Every row has a place that no other row overlaps. A field that leaves ten columns to its right gets
-- a side panel there; otherwise the rows are drawn over the field, and are hidden while a ship is near.
local sys = ... -- functions for the standard library only; documented in src/script/api/api_sys.c
local hud = {}

hud.cols, hud.rows = rom.screen.w // 8, rom.screen.h // 8
-- Palette banks of text; games with coloured text set them in main.lua. alarm: warnings and a boss's last seconds.
hud.banks = { plain = 0, bright = 0, faint = 0, alarm = 0 }
hud.low = 2 -- rows of 8 px left free below the registers at the field's lower edge
hud.shy = 8 -- px: rows over the field are hidden while the centre of a ship is nearer than this; 0: never
hud.gone = { false, false } -- by player: whether the rows at the lower edge are hidden
hud.graze = "GRAZE" -- the label of the graze count
hud.large = sys.large_hud() -- the player chose larger letters for scores, lives and icons

-- The character with this code (128 or more), or `plain` if the font has no picture for it.
function hud.glyph(code, plain) return sys.glyph(code) and string.char(code) or plain end

-- Has s full-width letters that need more than a cell?
local function has_full(s) return 2 * sys.cells(s) > sys.cells(s, 2) end

hud.full = has_full(text.lang("name")) -- the language of the run has such letters, by its name

-- Writes s at a column and a row, which may be fractions of a cell. size: 1 to 3 cells a letter.
function hud.put(col, row, s, bank, size)
  if row < 0 or row >= hud.rows or col < 0 or col >= hud.cols or s == "" then return end
  text.put { col = col, row = row, text = s, bank = bank or hud.banks.plain, rim = true, size = size, full_width = true }
end

-- Breaks s into lines of at most `width` cells, between words if possible. Also returns how many lines end inside a
-- word. size: of the letters, by default 1.
function hud.wrap(s, width, size)
  if #s * (size or 1) <= width then return { s }, 0 end
  return sys.wrap(s, width, size)
end

-- The same, into lines of nearly equal length.
function hud.balance(s, width, size)
  local lines, fewest = hud.wrap(s, width, size)
  local longest = size or 1
  if #lines == 1 then return lines end
  for word in s:gmatch("%S+") do
    local n = sys.cells(word, size)
    if n <= width then longest = math.max(longest, n) end
  end
  for narrower = width - (size or 1), longest, -(size or 1) do
    local tried, broken = hud.wrap(s, narrower, size)
    if #tried > #lines then break end
    if broken <= fewest then lines, fewest = tried, broken end
  end
  return lines
end

local PITCH <const> = 10 -- px from one row to the next: 8 px of letters, 2 px free
local FULL_PITCH <const> = 14 -- the same for full-width letters
local GAP <const> = 6    -- px between groups of rows
local MARGIN <const> = 1 -- columns free on each side of a banner
local FEW <const> = 6    -- up to this many icons are drawn; more are drawn as an icon and a number
local BEAT <const> = 8   -- frames that a full bar stays in each of its two colours
local LIFE, STAR = hud.glyph(137, "*"), hud.glyph(138, "*")

-- Returns the px from one line of text to the next. size: of the letters. s: all there is in the line, if known.
function hud.pitch(size, s)
  return size == 1 and hud.full and (not s or has_full(s)) and FULL_PITCH or PITCH + 8 * (size - 1)
end

local SCREEN <const> = { col = 0, cols = hud.cols }
local FIELD <const> = { col = (rom.view.x + 7) // 8 }
FIELD.cols = (rom.view.x + rom.view.w) // 8 - FIELD.col
local FIELD_BOTTOM <const> = rom.view.y + rom.view.h -- px

-- Of the columns to the right of the field, a panel leaves the first free, and the last if there are more than ten.
-- Over the field, rows stay one column off its edges.
local room = (rom.screen.w - rom.view.x - rom.view.w) // 8
local PANEL <const> = room >= 10
local LEFT <const> = PANEL and hud.cols - room + 1 or FIELD.col + 1
local WIDTH <const> = room > 10 and room - 2 or PANEL and 9 or FIELD.cols - 2
local TOP <const> = PANEL and 8 or rom.view.y + 4 -- px

hud.field, hud.panel = FIELD, PANEL
hud.declared = (rom.view.y + rom.view.h * 5 // 8) // 8 * 8 -- px: the top of a spell's name when it is declared
local DECLARED_END <const> = hud.declared + 46 -- px: below three lines of it, and a rule

local BEST_COLS <const> = 12              -- "HI 000000000"
local CLOCK_COLS <const> = 4              -- a boss's clock: two digits of size 2
local HISTORY_COLS, BONUS_COLS = 14, 13   -- "CAPTURED 12/34", "BONUS 0001234"
local LIVES_COLS <const> = 4              -- in a panel
local LOW_COLS <const> = math.min(12, FIELD.cols // 2 - 1)
local NEAR_EVERY <const> = 8              -- frames from one look for ships near the rows to the next
local LOW_BAR <const> = LOW_COLS * 2 // 3 -- a bar at the lower edge ends before a ship at its start in a narrow field
local STACKED <const> = PANEL or WIDTH < 2 * BEST_COLS + 1 -- two scores do not fit in a row

-- A panel's rows for the boss are at its lower end: the clock and 2 px, three rows for the name and the bar or two for
-- each bar of a cast, three for the spell, and the history and the bonus.
local PANEL_END <const> = rom.screen.h - 6 -- px
local function boss_height(bars) return 18 + hud.pitch(1) * (math.max(3, 2 * bars) + 5) end
local ROWS_END <const> = PANEL and PANEL_END - boss_height(2) or FIELD_BOTTOM - rom.view.h // 2 -- of the players' rows

-- The players' rows, by layout and number of players: what is at the left, in the middle and at the right. The digit is
-- the player's number; {} is a gap.
local ROWS <const> = {
  over = { -- over the field; registers follow, two in a row
    { { "score1", false, "best" }, { "lives1", false, "graze1" } },
    { { false, "best" }, { "score1", false, "score2" }, { "lives1", false, "lives2" }, { "graze1", false, "graze2" } },
  },
  stacked = { -- in a panel, or over a narrow field; the registers of the run follow
    { { "best" }, {}, { "score1" }, { "lives1", false, "graze1" }, { "registers1" } },
    { { "best" }, {}, { "score1" }, { "lives1", false, "graze1" }, { "registers1" }, {}, { "score2" },
      { "lives2", false, "graze2" }, { "registers2" }, {} },
  },
  large_over = { -- large scores, lives and icons; the other rows give way to them
    { { "best" }, { "score1" }, { "lives1", false, "graze1" } },
    { { false, "best" }, { "score1" }, { "score2" }, { "lives1", false, "lives2" } },
  },
  large_stacked = {
    { { "best" }, {}, { "name1", false, "lives1" }, { "points1" }, { "graze1" }, { "registers1" } },
    { { "name1", false, "lives1" }, { "points1" }, { "registers1" }, {}, { "name2", false, "lives2" }, { "points2" },
      { "registers2" }, {} },
  },
}

local players = 0                   -- how many play
local playing = false               -- the rows are drawn
local GROUPS <const> = { "top1", "top2", "top3", "boss", "low1", "low2" }
local last_score = {}               -- by player: the score of a player who is out cannot be read
local record = 0                    -- the best score of the table
local note, note_bank               -- what the game shows in place of that
local is_large = false              -- the rows are those of a larger HUD,
local all_fit = true                -- and there is room for all
local items = {}                    -- what the players' rows show: place, label, get, make, low, size of its letters;
                                    -- value and bank shown
local groups = {}                   -- rows over the field that are hidden together, by name: places, hidden, own: where
                                    -- the game shows more
local ship_x, ship_y = {}, {}       -- by player; y is false while the player has no ship
local rows_end = 0                  -- y below the players' rows
local hidden = { low = 0, all = 0 } -- how many dialogues and pages hide the lower rows, and all rows
local panel                         -- the plate behind a panel's rows
local banner_row = 0                -- the first row of cells below all rows
local banner                        -- lines; area, row and h: its cells; ends: the clock when it is removed
local again                         -- everything has to be drawn

local cells = sys.cells

-- Puts s, translated, in the middle of `cols` columns from `first`; by default of the field during play, otherwise of
-- the screen. Long text is wrapped. size: of the letters. Returns the first row of cells below it.
function hud.centre(row, s, bank, first, cols, size)
  if not math.type(row) then sys.fail("hud.centre", ("row: expected a number, got %s"):format(tostring(row))) end
  local area = playing and FIELD or SCREEN
  first, cols = first or area.col, cols or first and hud.cols or area.cols
  size = size or 1
  local lines = hud.balance(text.lang(s), math.max(size, cols), size)
  local pitch = hud.pitch(size)
  for i, line in ipairs(lines) do
    hud.put(first + math.max(0, cols - sys.cells(line, size)) / 2, row + (i - 1) * pitch / 8, line, bank, size)
  end
  return row + ((#lines - 1) * pitch + 15) // 8
end

function hud.score(i)
  last_score[i] = player.get(i).score or last_score[i] or 0
  return last_score[i]
end

-- The best score of the table and of the players.
function hud.best()
  local best = record
  for i = 1, players do best = math.max(best, hud.score(i)) end
  return best
end

-- A bar of `length` characters, in eighths of a character if the font has them; never empty while value > 0.
function hud.bar(value, full, length)
  local eighths = math.min(value, full) * length * 8 // full
  if value > 0 and eighths < 1 then eighths = 1 end
  local whole, rest = eighths // 8, eighths % 8
  if hud.glyph(136, "") == "" then
    whole = math.min(length, (eighths + 7) // 8)
    return ("="):rep(whole) .. ("-"):rep(length - whole)
  end
  local s = string.char(136):rep(whole)
  if rest > 0 then s = s .. string.char(128 + rest) end
  return s .. string.char(128):rep(length - #s)
end

-- ---- places ----

-- col, cols: cells; y: px; align: left, middle, right, or spread (the label left, the value right); size: of letters.
-- group: hides the place with others. left, width: cells of the text.

local function place(col, y, cols, align, size)
  return { col = col, y = y, cols = math.max(0, cols), align = align, size = size or 1 }
end

local function write(p)
  if p.text and not (p.group and p.group.hidden) then hud.put(p.left, p.y / 8, p.text, p.bank, p.size) end
end

local function wipe(p)
  if not p.text or p.group and p.group.hidden then return end
  local col = math.min(p.col, p.left // 1)
  text.clear { col = col, row = p.y // 8, w = p.col + p.cols - col, h = p.size }
end

-- Replaces the text of a place. size: of its letters from now on, if given.
function hud.show(p, s, bank, size)
  if p.text == s and p.bank == bank and p.size == (size or p.size) then return end
  wipe(p)
  p.size = size or p.size
  p.text, p.bank, p.width = s ~= "" and s or nil, bank, cells(s, p.size)
  local free = p.cols - p.width
  p.left = p.col + (p.align == "left" and 0 or p.align == "middle" and free / 2 or free)
  write(p)
end

-- Adds places to a group. Those in a panel are never hidden.
local function add_to_group(name, places)
  if PANEL and name ~= "low1" and name ~= "low2" then return end
  groups[name] = groups[name] or { places = {}, hidden = false }
  for _, p in ipairs(places) do
    p.group = groups[name]
    table.insert(groups[name].places, p)
  end
end

-- The text of a label and a value for a place. short: replaces a label that is too long. size: of the letters.
function hud.labelled(p, label, value, short, size)
  local free = math.max(0, p.cols // (size or p.size) - cells(value) - 1) -- columns for the label
  if cells(label) > free then label = short or "" end
  local spread = p.align == "spread" and free + 1 - cells(label)
  return label .. (" "):rep(spread or label ~= "" and 1 or 0) .. value
end

-- A function that returns the places of rows, one below the other.
local function rows_from(y)
  return function(align, pitch)
    pitch = pitch or hud.pitch(1)
    y = y + pitch
    return place(LEFT, y - pitch, WIDTH, align)
  end
end

local function boss_over_field(names, pips)
  local row, cols = rows_from(rows_end), WIDTH - CLOCK_COLS - 1
  local at = { bars = {}, name = {}, spell = {} }
  at.clock = place(LEFT + WIDTH - CLOCK_COLS, rows_end + 2, CLOCK_COLS, "right", 2)
  at.pips = place(LEFT + cols - pips, rows_end, pips, "right")
  local label = 0
  for _, name in ipairs(names) do label = math.min(math.max(label, cells(name) + 1), cols // 2) end
  for i = 1, math.max(1, #names) do
    local y = row(nil, #names == 0 and PITCH).y
    local free = i == 1 and pips > 0 and pips + 1 or 0
    at.bars[i] = { name = place(LEFT, y, label - 1, "left"), bar = place(LEFT + label, y, cols - label - free, "left") }
  end
  local line = row().y
  at.spell[1] = place(LEFT, line, cols, "left")
  if #names < 2 then at.name[1] = place(LEFT, line, cols, "left") end
  at.history = row("left")
  at.bonus = row("right")
  if WIDTH > HISTORY_COLS + BONUS_COLS then
    at.history.cols = HISTORY_COLS
    at.bonus = place(LEFT + WIDTH - BONUS_COLS, at.history.y, BONUS_COLS, "right")
  end
  groups.boss = nil
  add_to_group("boss", { at.spell[1], at.history, at.bonus, at.name[1] })
  return at
end

local function boss_in_panel(names, pips)
  local bars = #names
  while bars > 2 and PANEL_END - boss_height(bars) < rows_end do bars = bars - 1 end
  local y = PANEL_END - boss_height(bars)
  local at, row = { bars = {}, name = {}, spell = {} }, rows_from(y + 18)
  at.clock = place(LEFT + WIDTH - CLOCK_COLS, y, CLOCK_COLS, "right", 2)
  at.pips = place(LEFT, y + 4, math.min(pips, WIDTH - CLOCK_COLS - 1), "left")
  if bars == 0 then at.name = { row("left"), row("left") } end
  for i = 1, math.max(1, bars) do at.bars[i] = { name = bars > 0 and row("left"), bar = row("left") } end
  if bars == 1 then row() end
  for i = 1, 3 do at.spell[i] = row("left") end
  at.history, at.bonus = row("spread"), row("spread")
  return at
end

-- The places of a boss's rows: clock, pips, history, bonus; the lines of name and spell, which share a row over the
-- field; bars, each with a name and a bar. names: of the bars; {}: one bar without a name. pips: how many are shown.
hud.boss_places = PANEL and boss_in_panel or boss_over_field

-- ---- the players' rows ----

-- A score with the zeros that fit after "1P" or "HI".
local function points(n, cols) return ("%0" .. math.max(1, math.min(9, cols - 3)) .. "d"):format(n) end

local function icons(icon, n, cols) return n > math.min(FEW, cols) and icon .. "x" .. n or icon:rep(n) end

local OUT <const> = -1 -- lives of a player who is out while another plays

-- size: of the letters in a larger HUD.
local KINDS <const> = {
  score = function(i)
    return { label = i .. "P", cols = BEST_COLS, make = points, get = function() return hud.score(i) end, size = 2 }
  end,
  name = function(i)
    return { label = "", make = function() return i .. "P" end, get = function() return i end }
  end,
  points = function(i) return { label = "", make = tostring, get = function() return hud.score(i) end, size = 2 } end,
  best = function()
    local function make(value, cols) return value == note and value or points(value, cols) end
    local function get() return note or hud.best(), note_bank end
    return { label = text.lang("HI"), short = "HI", make = make, get = get,
             size = players == 1 and not STACKED and 2 or nil }
  end,
  lives = function(i)
    local out = players > 1 and text.lang("OUT") or ""
    local function make(n, cols) return n < 0 and out or icons(LIFE, n, cols) end
    local function get() return player.get(i).lives or players > 1 and OUT or 0 end
    return { label = "", words = out, make = make, get = get, size = 2 }
  end,
  graze = function(i)
    return { label = text.lang(hud.graze), short = STAR, make = tostring, size = not (STACKED or hud.full) and 2 or nil,
             get = function() return player.get(i).grazes or 0 end }
  end,
}

-- The bank of a register with n in it: its mark and a full bar are bright.
local function bank_of(r, n)
  if r.show == "bar" and n > 0 and n >= r.max then return sys.clock() // BEAT % 2 == 0 and hud.banks.bright or nil end
  return r.mark and n >= r.mark and hud.banks.bright or nil
end

local SHOWN <const> = {
  number = function(_, n) return tostring(n) end,
  times = function(_, n) return ("x%d.%02d"):format(n // 100, n % 100) end,
  icons = function(_, n, cols) return icons(STAR, n, cols) end,
  bar = function(r, n, cols, most) return hud.bar(n, r.max, math.max(1, math.min(most, cols))) end,
}

local function register_item(i, r)
  local label = r.label == "" and "" or text.lang(r.label or r.name:gsub("_", " "):upper())
  local item = { label = label, player = i, register = r, size = r.show == "icons" and 2 or nil }
  function item.make(n, cols)
    local rest = item.label == "" and 0 or cells(item.label) + 1
    return SHOWN[r.show](r, n, cols - rest, item.low and LOW_BAR or 8)
  end
  function item.get()
    local n = sys.value(i, r.name, r.run)
    if item.low and n == r.value and r.show ~= "bar" and n == (r.show == "times" and 100 or 0) then return nil end
    return n, n and bank_of(r, n)
  end
  return item
end

-- A register of player i as its row shows it, and its bank; nil: there is no such ship or register.
function hud.register(i, name)
  local kind = player.get(i).kind
  for _, r in ipairs(kind and sys.ship(kind).registers or {}) do
    local item = r.name == name and register_item(i, r)
    local n, bank
    if item then n, bank = item.get() end
    if n then return (item.label == "" and "" or item.label .. " ") .. item.make(n, 16), bank end
  end
end

local function size_of(item) return item and is_large and item.size or 1 end
local function pitch_of(item) return item and hud.pitch(size_of(item), item.words or item.label) or 0 end

-- Adds an item in a place. size: of the largest letters in its row.
local function add_item(item, p, size, group)
  item.place = p
  p.size = size_of(item)
  p.y = p.y + 4 * (size - p.size)
  items[#items + 1] = item
  add_to_group(group, { p })
end

-- Gives the parts of a row their places at y and adds them. Returns the y of the next row.
local function add_row(y, left, middle, right)
  local size = math.max(size_of(left), size_of(middle), size_of(right))
  local below = y + math.max(pitch_of(left), pitch_of(middle), pitch_of(right))
  if below > ROWS_END then -- not shown
    all_fit = false
    return y
  end
  local alone = not middle and right == nil
  local cols = alone and WIDTH or (WIDTH - (middle and BEST_COLS + 2 or 1)) // 2
  local left_cols, right_cols = cols, cols
  if not alone and (STACKED or left and left.cols) then
    left_cols = math.max(LIVES_COLS, left.cols or 0)
    right_cols = WIDTH - left_cols - 1
  elseif right and right.label ~= "" and size_of(right) > 1 then
    left_cols = math.min(cols, 2 * LIVES_COLS)
    right_cols = WIDTH - left_cols - 1
  end
  local places = {
    place(LEFT, y, left_cols, alone and STACKED and (left.label == "" and "right" or "spread") or "left"),
    place(LEFT + (WIDTH - BEST_COLS) // 2, y, BEST_COLS, "middle"),
    place(LEFT + WIDTH - right_cols, y, right_cols, "right"),
  }
  for k, item in ipairs { left or false, middle or false, right or false } do
    if item then add_item(item, places[k], size, "top" .. k) end
  end
  return below
end

-- Takes the label off an item that has large letters: the label stays small, in an item of its own.
local function take_label(item)
  local label = item.label
  item.label = ""
  local function get()
    local value, bank = item.get()
    return value and label, bank
  end
  return { label = "", words = label, cols = cells(label), make = function() return label end, get = get }
end

-- Two registers in a row if their labels leave room for values.
local function add_registers(y, list)
  local i = 1
  local function is_short(item) return item and size_of(item) == 1 and cells(item.label) < WIDTH // 2 - 6 end
  while i <= #list do
    local both = not STACKED and is_short(list[i]) and is_short(list[i + 1])
    if STACKED and size_of(list[i]) > 1 then y = add_row(y, take_label(list[i]), false, list[i])
    else y = add_row(y, list[i], nil, both and list[i + 1] or nil) end
    i = i + (both and 2 or 1)
  end
  return y
end

-- own: the registers of each player; of_run: of the run.
local function add_rows(own, of_run)
  local y = TOP
  for _, row in ipairs(ROWS[(is_large and "large_" or "") .. (STACKED and "stacked" or "over")][players]) do
    local parts = {}
    for k, name in ipairs(row) do
      local kind, i = (name or ""):match("^(%a+)(%d?)$")
      if kind == "registers" then y = add_registers(y, own[tonumber(i)])
      else parts[k] = kind and KINDS[kind](tonumber(i)) or false end
      if parts[k] then parts[k].player = tonumber(i) end
    end
    if #parts > 0 then y = add_row(y, parts[1], parts[2] or nil, parts[3]) end
    if #row == 0 then y = y + GAP end
  end
  if not STACKED and players == 2 then
    for k = 1, math.max(#own[1], #own[2]) do y = add_row(y, own[1][k], nil, own[2][k] or false) end
    for k = 1, #of_run do y = add_row(y, nil, of_run[k]) end
    of_run = {}
  elseif not STACKED then
    table.move(of_run, 1, #of_run, #own[1] + 1, own[1])
    of_run = own[1]
  end
  rows_end = add_registers(y, of_run)
end

local FROM_BELOW <const> = { bar = 1, icons = 2, times = 3, number = 4 }

-- The rows at the field's lower edge, above hud.low rows: player 1's at the left, player 2's at the right. They are
-- hidden together with what a game shows below them.
local function add_low_rows(i, list)
  table.sort(list, function(a, b)
    a, b = a.register, b.register
    local above, below = FROM_BELOW[a.show], FROM_BELOW[b.show]
    return above < below or above == below and a.name < b.name
  end)
  local col = i == 1 and FIELD.col + 1 or FIELD.col + FIELD.cols - 1 - LOW_COLS
  local y = FIELD_BOTTOM - 8 * hud.low
  groups["low" .. i] = { places = {}, hidden = false, own = { left = col, width = LOW_COLS, y = y, size = hud.low } }
  local function add(item)
    local size = size_of(item)
    y = y - pitch_of(item)
    local p = place(col, y, LOW_COLS, i == 1 and "left" or "right")
    item.low = true
    add_item(item, p, size, "low" .. i)
  end
  for _, item in ipairs(list) do
    -- A large label is above its large value, below the name of a spell that is declared.
    local alone = is_large and players == 1 and y - 2 * hud.pitch(2) >= DECLARED_END
    local apart = alone or item.register.show == "bar"
    local label = apart and item.label ~= "" and take_label(item)
    if alone then item.size = 2 end
    add(item)
    if label then
      label.size = item.size
      add(label)
    end
  end
end

-- Is a position of the screen less than `distance` px from a place's text?
local function is_near(p, x, y, distance)
  return x > 8 * p.left - distance and x < 8 * (p.left + p.width) + distance
    and y > p.y - distance and y < p.y + 8 * p.size + distance
end

local function is_group_near(group, x, y)
  local distance = hud.shy + (group.hidden and 8 or 0)
  if group.own and is_near(group.own, x, y, distance) then return true end
  for _, p in ipairs(group.places) do
    if p.text and is_near(p, x, y, distance) then return true end
  end
  return false
end

local function set_hidden(group, is_hidden)
  if is_hidden then
    for _, p in ipairs(group.places) do wipe(p) end
  end
  group.hidden = is_hidden
  for _, p in ipairs(group.places) do write(p) end
end

local function update_gone()
  for i = 1, 2 do
    local low = groups["low" .. i]
    hud.gone[i] = hidden.all + hidden.low > 0 or low ~= nil and low.hidden
  end
end

-- Hides the groups of rows that a ship is near to, and shows them when it is 8 px further away.
local function hide_near_ships()
  local count = hud.shy > 0 and players or 0
  for i = 1, count do
    local ship = player.get(i)
    if ship.alive then ship_x[i], ship_y[i] = sys.to_screen(ship.x, ship.y) else ship_y[i] = false end
  end
  for _, name in ipairs(GROUPS) do
    local group, near = groups[name], false
    for i = 1, group and count or 0 do
      near = near or ship_y[i] and is_group_near(group, ship_x[i], ship_y[i])
    end
    if group and near ~= group.hidden then set_hidden(group, near) end
  end
  update_gone()
end

-- Shows an item's value, in the largest letters that leave room for its label. A note has no label.
local function show_item(item, value, bank)
  local size, label = size_of(item), value == note and "" or item.label
  local words = item.make(value, item.place.cols // size)
  if cells(label == "" and "" or label .. " ", size) + cells(words, size) > item.place.cols then
    size = 1
    words = item.make(value, item.place.cols)
  end
  hud.show(item.place, hud.labelled(item.place, label, words, item.short, size), bank, size)
end

-- Text is made only when a value has changed.
local function draw_items()
  for _, item in ipairs(items) do
    local value, bank
    if hidden.all == 0 and not (item.low and hidden.low > 0) then value, bank = item.get() end
    if value ~= item.value or bank ~= item.bank or again then
      item.value, item.bank = value, bank
      if value then show_item(item, value, bank) else hud.show(item.place, "") end
    end
  end
end

-- Puts a plate behind a panel's rows, where the screen was emptied.
local function put_panel()
  if not PANEL or panel and panel.alive then return end
  local x = rom.view.x + rom.view.w + 2
  panel = sprite.plate {
    x = x, y = 2, w = rom.screen.w - x - 2, h = rom.screen.h - 4, bank = hud.banks.plain, stay = true,
  }
end

local function draw()
  if again then put_panel() end
  draw_items()
  boss.draw(hidden.all > 0, again, hidden.low > 0)
  if sys.clock() % NEAR_EVERY == 0 or again then hide_near_ships() end
  again = false
  if banner and sys.clock() >= banner.ends then hud.banner() end
end

-- Hides the rows that a dialogue covers, or with `all` every row; with `shown`, shows them again. A dialogue covers a
-- panel, too.
function sys.hide_rows(all, shown)
  local rows = (all or PANEL) and "all" or "low"
  hidden[rows] = math.max(0, hidden[rows] + (shown and -1 or 1)) -- hud.start may have reset it in between
  if not playing then return end
  update_gone()
  draw_items()
  boss.draw(hidden.all > 0, false, hidden.low > 0)
  if panel and panel.alive then panel.hidden = hidden.all > 0 end
end

-- Shows a text, such as a clock or how far a goal is reached, in place of the best score; nil: the score again.
function hud.note(s, bank)
  if s ~= nil and type(s) ~= "string" then sys.fail("hud.note", "text: expected a string or nil") end
  note, note_bank = s, s and bank
end

-- Shows lines in the middle of the field, or from a row on, for a number of frames. Without lines, removes them. size:
-- of the letters.
function hud.banner(lines, frames, first, size)
  if lines and type(lines) ~= "table" then
    sys.fail("hud.banner", 'lines: expected a list of strings such as { "GO" }')
  end
  if lines and not math.tointeger(frames) then sys.fail("hud.banner", "frames: expected a whole number") end
  if banner then text.clear { col = banner.area.col, row = banner.row, w = banner.area.cols, h = banner.h } end
  banner = nil
  if not lines then return end
  first = math.max(first or hud.rows // 3, banner_row)
  local row, area = first, playing and FIELD or SCREEN
  for _, line in ipairs(lines) do
    row = hud.centre(row, line, hud.banks.bright, area.col + MARGIN, area.cols - 2 * MARGIN, size) + 1
  end
  banner = { lines = lines, area = area, row = first, h = row - first, ends = sys.clock() + frames, size = size }
end

-- Draws everything again, after other text was written over it.
function hud.refresh()
  for _, item in ipairs(items) do item.place.text = nil end
  if groups.boss then groups.boss.places = {} end
  again = true
  if banner then hud.banner(banner.lines, banner.ends - sys.clock(), banner.row, banner.size) end
end

-- The registers that player i's rows show: those at the top, those at the lower edge, those of the run.
local function registers_of(i)
  local own, low, of_run = {}, {}, {}
  local kind = player.get(i).kind
  for _, r in ipairs(kind and sys.ship(kind).registers or {}) do
    local list = r.run and of_run or r.at == "low" and (players == 2 or not PANEL) and low or own
    if r.show and r.show ~= "none" then list[#list + 1] = register_item(i, r) end
  end
  return own, low, of_run
end

-- Lays the rows out.
local function lay_out(large)
  is_large, all_fit, items, groups = large, true, {}, {}
  local own, of_run = {}, nil
  for i = players, 1, -1 do
    local low
    own[i], low, of_run = registers_of(i)
    add_low_rows(i, low)
  end
  add_rows(own, of_run)
end

-- True from hud.start until its owner ends. At other times, pages use the whole screen.
function hud.is_playing() return playing end

-- Draws every frame for n players, until the owner ends. scores: the score table, by default the difficulty's.
function hud.start(owner, n, scores)
  sys.show_whole(false)
  local top = score.rows(scores or board.difficulty())[1]
  players, playing, last_score, record = n, true, {}, top and top.score or 0
  hidden, banner, again, note, note_bank = { low = 0, all = 0 }, nil, true, nil, nil
  lay_out(hud.large)
  if is_large and not all_fit then lay_out(false) end
  banner_row = PANEL and 0 or (boss_over_field({ "", "" }, 0).bonus.y + PITCH + 7) // 8
  task.own(owner, function()
    local stop <close> = setmetatable({}, { __close = function()
      playing = false
      sys.show_whole(true)
    end })
    while true do
      draw()
      wait(1)
    end
  end)
end

return hud

-- hud.lua - what stands on the screen during play, as rows of text: scores and lives, the boss, the stage's banner.
-- Also the few words for putting text that the menus share. A field that leaves room to its right gets a side panel.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local hud = {}

hud.cols, hud.rows = rom.screen.w // 8, rom.screen.h // 8
-- A game with coloured text sets these in main.lua. alarm: a boss's last seconds, and its warning.
hud.banks = { plain = 0, bright = 0, faint = 0, alarm = 0 }
hud.low = 1 -- rows free below the registers that stand at the field's lower edge: what a game shows there itself
hud.shy = 0 -- px: what stands at the lower edge goes while a craft is so near to it
hud.gone = { false, false } -- by player, whether its rows there are gone so: what a game shows there itself goes with them
hud.graze = false -- the word before the number of grazes; false: a star

-- The font's own picture for a code from 128 on, or else a plain character.
function hud.glyph(code, plain) return sys.glyph(code) and string.char(code) or plain end

-- size 2: letters of two cells by two.
function hud.put(col, row, s, bank, size)
  if row < 0 or row >= hud.rows or col < 0 or col >= hud.cols or s == "" then return end
  text.put { col = col, row = row, text = s, bank = bank or hud.banks.plain, rim = true, size = size }
end

-- Breaks s between words into lines of at most `width` characters, and words that are longer; what fits stays as it is.
function hud.wrap(s, width) return #s <= width and { s } or sys.wrap(s, width) end

-- Puts s, in the language of the run, in the middle of `cols` columns from `first` on (the screen's), broken into
-- lines; returns the row below.
function hud.centre(row, s, bank, first, cols)
  if not math.tointeger(row) then sys.fail("hud.centre", ("row: expected a whole number, got %s"):format(tostring(row))) end
  first, cols = first or 0, cols or hud.cols
  for _, line in ipairs(hud.wrap(text.lang(s), cols)) do
    hud.put(first + math.max(0, (cols - sys.cells(line)) // 2), row, line, bank)
    row = row + 1
  end
  return row
end

-- The field leaves `room` columns to its right. Ten are enough for a panel, of all but the first and, from eleven on,
-- the last; else the rows go over the field, a cell off its edges.
local field_col, field_cols = (rom.field.x + 7) // 8, (rom.field.x + rom.field.w) // 8 - (rom.field.x + 7) // 8
local room = (rom.screen.w - rom.field.x - rom.field.w) // 8
local PANEL = room >= 10
local left = PANEL and hud.cols - room + 1 or field_col + 1
local width = room > 10 and room - 2 or room == 10 and 9 or field_cols - 2
local TOP = PANEL and 1 or rom.field.y // 8 + 1
local WIDE = width >= 23 -- lives, the best score and lives stand in one row

-- For the rows of a boss: where rows stand, whether that is a panel, and the columns of the field.
hud.place = { left = left, width = width, panel = PANEL, col = field_col, cols = field_cols }

local LIFE, GRAZE = hud.glyph(137, "*"), hud.glyph(138, "*")
local BOTTOM <const> = (rom.field.y + rom.field.h) // 8 - 1 -- the field's last row
local BANNER_ROW = hud.rows // 3
local FEW <const> = 6 -- so many icons stand side by side; of more, their number

local players = 0 -- how many play
local seen = {}   -- each player's last score: that of one who is out cannot be read
local shown = {}  -- the text of each row on the screen; a row is written only when it changes
local below = {}  -- and of those at the lower edge, by player and row
local banner      -- lines; row, h, the rows it covers; ends, the clock when it goes; nil: there is none
local record = 0  -- the best score of the table
local registers, low = { {}, {} }, { {}, {} } -- that each player's ship shows: name, label, show, max, mark, run
local covered = 0 -- how many stand over the field's lower edge
local values = {} -- what the rows tell of
local fresh       -- one of them is another than in the frame before
local again       -- all is to be written

local function points(n) return ("%09d"):format(n) end

function hud.score(i)
  seen[i] = player.get(i).score or seen[i] or 0
  return seen[i]
end

-- The best score of the table and of those who play.
function hud.best()
  local best = record
  for i = 1, players do best = math.max(best, hud.score(i)) end
  return best
end

local function icons(icon, n) return n > FEW and icon .. "x" .. n or icon:rep(n) end

-- All that rows are made of has a byte a cell, but for the registers' names in some languages.
local wide = false
local function cells(s) return wide and sys.cells(s) or #s end

local function fill(s, n) return s .. (" "):rep(n - cells(s)) end

-- One row with a left, a middle and a right part; where that is too long, a row for each. A row is { text, parts in
-- other banks: { column, text, bank } each }.
local function add(rows, first, middle, last, bank, other)
  local n = cells(first) + cells(middle) + cells(last)
  if n + 2 <= width then
    local line = fill(first, (width - cells(middle)) // 2) .. middle
    local row = { fill(line, width - cells(last)) .. last }
    if bank then row[2] = { 0, first, bank } end
    if other then row[#row + 1] = { width - cells(last), last, other } end
    rows[#rows + 1] = row
    return
  end
  for k, s in ipairs { first, middle, last } do
    for _, line in ipairs(s ~= "" and hud.wrap(s, width) or {}) do
      if WIDE and s == last then line = fill("", width - cells(line)) .. line end
      local own = k == 1 and bank or k == 3 and other
      rows[#rows + 1] = { line, own and { 0, line, own } or nil }
    end
  end
end

-- A bar of `length` characters, in eighths where the font has them; never empty while something is left.
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

local BEAT <const> = 8 -- frames that a full bar keeps its colour

-- The bank of a register's text where it is not the usual one: from its mark on, and of a bar that is full.
local function bank_of(r, n)
  if r.show == "bar" and n >= r.max and n > 0 then
    return sys.clock() // BEAT % 2 == 0 and hud.banks.bright or hud.banks.plain
  end
  return r.mark and n >= r.mark and hud.banks.bright or nil
end

-- The register r that player i shows, as its ship says, and its bank. A bar leaves room for the other player's.
local function register(i, r, at_edge)
  local n = r and sys.value(i, r.name, r.run)
  if not n then return "" end
  if r.show == "icons" then return r.label .. icons(GRAZE, n), bank_of(r, n) end
  if r.show == "times" then return r.label .. ("x%d.%02d"):format(n // 100, n % 100), bank_of(r, n) end
  if r.show ~= "bar" then return r.label .. n, bank_of(r, n) end
  local most = (WIDE and players > 1 and (width - 2) // 2 or width) - cells(r.label)
  if at_edge then most = math.min(most, math.max(5, 8 - cells(r.label))) end -- few cells over the field
  return r.label .. hud.bar(n, r.max, math.max(1, math.min(8, most))), bank_of(r, n)
end

-- The registers of player i; those of the run are of both, so they have a row by themselves.
local function stack_registers(rows, i, of_run)
  for _, r in ipairs(registers[i]) do
    if r.run == of_run then
      local s, bank = register(i, r)
      if s == "" then rows[#rows + 1] = { "" } else add(rows, s, "", "", bank) end
    end
  end
end

-- What covers the field's lower edge, a talk, takes these rows away, and brings them back.
function sys.low(shown_again)
  covered = covered + (shown_again and -1 or 1)
  for i = 1, covered == 1 and not shown_again and players or 0 do
    for k, old in pairs(below[i]) do
      local n = cells(old[1])
      hud.put(i == 1 and left or left + width - n, BOTTOM - hud.low - k + 1, (" "):rep(n))
    end
  end
  below, fresh = { {}, {} }, true
end

local PLACES <const> = { bar = 1, icons = 2, times = 3, number = 4 } -- from below

local LOW_COLS <const> = 12 -- columns that these rows have

-- Is a craft so near to player i's rows that they go? They come back only when it is a little farther off.
local function hides(i)
  if hud.shy <= 0 then return false end
  local far = hud.shy + (hud.gone[i] and 8 or 0)
  local top = (BOTTOM - hud.low - math.max(#low[i], 1) + 1) * 8 - rom.field.y - far
  local side = LOW_COLS * 8 + far
  for p = 1, players do
    local craft = player.get(p)
    local x, y = craft.x, craft.y
    if y and y > top and (i == 1 and x < side or i == 2 and x > rom.field.w - side) then return true end
  end
  return false
end

-- What stands at the field's lower edge: player one's to the left, two's to the right.
local function draw_low()
  if covered > 0 then return end
  for i = 1, players do
    for k, r in ipairs(low[i]) do
      local s, bank = register(i, r, true)
      local value = sys.value(i, r.name, r.run)
      if r.show ~= "bar" and value == r.value and value == (r.show == "times" and 100 or 0) or hud.gone[i] then s = "" end
      local key = s .. "|" .. (bank or "")
      local old = below[i][k] or { "", "" }
      if old[2] ~= key then
        local n = math.max(cells(s), cells(old[1]))
        local line = i == 1 and fill(s, n) or (" "):rep(n - cells(s)) .. s
        hud.put(i == 1 and left or left + width - n, BOTTOM - hud.low - k + 1, line, bank)
        below[i][k] = { s, key }
      end
    end
  end
end

-- Of two players in a narrow panel each has rows of its own; they stay where they are when one is out.
local function stacked_rows(rows, best)
  add(rows, "HI " .. best, "", "")
  for i = 1, 2 do
    rows[#rows + 1] = { "" }
    add(rows, i .. "P", "", icons(LIFE, player.get(i).lives or 0))
    rows[#rows + 1] = { points(hud.score(i)) }
    stack_registers(rows, i, false)
  end
  rows[#rows + 1] = { "" }
  stack_registers(rows, 1, true)
end

local function play_rows(rows)
  local best = points(hud.best())
  if players > 1 and not WIDE then return stacked_rows(rows, best) end
  if players > 1 then
    add(rows, points(hud.score(1)), "", points(hud.score(2)))
    add(rows, icons(LIFE, player.get(1).lives or 0), best, icons(LIFE, player.get(2).lives or 0))
  else
    add(rows, points(hud.score(1)), "", "HI " .. best)
    add(rows, icons(LIFE, player.get(1).lives or 0), "", (hud.graze and text.lang(hud.graze) .. " " or GRAZE) .. (player.get(1).grazes or 0))
  end
  for k = 1, math.max(#registers[1], #registers[2]) do
    local s, bank = register(1, registers[1][k])
    local t, other = register(2, registers[2][k])
    add(rows, s, "", t, bank, other)
  end
end

local function note(what, value)
  if values[what] ~= value then values[what], fresh = value, true end
end

local function note_registers(i, list, from)
  for k, r in ipairs(list) do
    local n = sys.value(i, r.name, r.run)
    note(2 * k + i + from, n)
    if n and r.show == "bar" and n >= r.max then note(2 * k + i + from + 80, bank_of(r, n)) end
  end
end

local function write(rows)
  for i = 1, math.max(#rows, #shown) do
    local row = rows[i] or { "" }
    local s = fill(row[1], width)
    local key = s
    for k = 2, #row do key = key .. "|" .. row[k][1] .. "=" .. row[k][3] end
    if key ~= (shown[i] or (" "):rep(width)) then
      hud.put(left, TOP + i - 1, s)
      for k = 2, #row do hud.put(left + row[k][1], TOP + i - 1, row[k][2], row[k][3]) end
    end
    shown[i] = key
  end
end

-- Most frames are as the one before: then no text is made.
local function draw()
  note("best", hud.best())
  for i = 1, players do
    local p = player.get(i)
    note(i, seen[i])
    note(i + 2, p.lives)
    note(i + 4, p.grazes)
    note_registers(i, registers[i], 4)
    note_registers(i, low[i], 44)
    hud.gone[i] = hides(i)
    note(200 + i, hud.gone[i])
  end
  if fresh then
    local rows = {}
    play_rows(rows)
    write(rows)
    draw_low()
    fresh = false
  end
  boss.draw(TOP + #shown + (PANEL and 1 or 0), again)
  again = false
  if banner and sys.clock() >= banner.ends then hud.banner() end
end

-- Shows lines in the middle of the field, or from a row on, for so many frames; without lines, ends that.
function hud.banner(lines, over, first)
  if lines and type(lines) ~= "table" then sys.fail("hud.banner", 'lines: expected a list of strings such as { "GO" }') end
  if lines and not math.tointeger(over) then sys.fail("hud.banner", "frames: expected a whole number") end
  if banner then text.clear { col = field_col, row = banner.row, w = field_cols, h = banner.h } end
  banner = nil
  if not lines then return end
  first = first or BANNER_ROW
  local row = first
  for _, line in ipairs(lines) do row = hud.centre(row, line, hud.banks.bright, field_col, field_cols) + 1 end
  banner = { row = first, h = row - first, ends = sys.clock() + over, lines = lines }
end

-- Writes all again after something else was written over it.
function hud.refresh()
  shown, below, fresh, again = {}, { {}, {} }, true, true
  if banner then hud.banner(banner.lines, banner.ends - sys.clock(), banner.row) end
end

-- Draws every frame for n players, until the owner ends.
function hud.start(owner, n)
  local top = score.rows(board.difficulty())[1]
  players, seen, shown, banner, record = n, {}, {}, nil, top and top.score or 0
  values, below, hud.gone, covered, fresh, again, wide = {}, { {}, {} }, { false, false }, 0, true, true, false
  for i = 1, 2 do
    local kind = i <= n and player.get(i).kind
    registers[i], low[i] = {}, {}
    for _, r in ipairs(kind and sys.ship(kind).registers or {}) do
      r.label = r.label == "" and "" or text.lang(r.label or (r.name:gsub("_", " "):upper())) .. " "
      wide = wide or #r.label ~= sys.cells(r.label)
      local list = r.at == "low" and not PANEL and low[i] or registers[i]
      if r.show and r.show ~= "none" and not (r.run and i > 1) then list[#list + 1] = r end
    end
    table.sort(low[i], function(r, s)
      local a, b = PLACES[r.show], PLACES[s.show]
      return a < b or a == b and r.name < s.name
    end)
  end
  task.own(owner, function()
    while true do
      draw()
      wait(1)
    end
  end)
end

return hud

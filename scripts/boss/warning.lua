-- boss/warning.lua - the warning before a boss: a dark picture, two bars in which WARNING scrolls, red flashes, and
-- between the bars a card with the boss's epithet and name.
local sys = ... -- functions for the standard library only; documented in src/script/api/api_sys.c
local OPENS <const> = 16 -- frames that the bars take to open, and to close
local PACE <const> = 3   -- frames in which WARNING scrolls by a letter
local BEAT <const> = 40  -- frames from one flash to the next
local BAR <const> = 3    -- rows of a bar: WARNING in its middle
local SHARE <const>, DIM <const> = 0.22, 0.45 -- strengths of a flash and of the dim

local COL <const>, COLS <const> = hud.field.col, hud.field.cols
local MIDDLE <const> = (rom.view.y + rom.view.h * 2 // 5) // 8
local LINE <const>, FIRST <const>, LAST <const> = hud.glyph(141, "-"), hud.glyph(142, "-"), hud.glyph(143, "-")

-- Returns the characters of s from the i-th on that fit in n cells.
local function part(s, i, n)
  local first, count = utf8.offset(s, i), n + 1
  local found
  repeat
    count = count - 1
    found = s:sub(first, (utf8.offset(s, i + count) or #s + 1) - 1)
  until sys.cells(found) <= n
  return found
end

-- A bar's rounded ends are off the screen where the field reaches the screen's edge; otherwise it ends at the field.
local BEYOND <const> = 8
local BAR_X <const> = rom.view.x > 0 and rom.view.x or -BEYOND
local BAR_END <const> = rom.view.x + rom.view.w
local BAR_W <const> = (BAR_END < rom.screen.w and BAR_END or BAR_END + BEYOND) - BAR_X

local function bar(row)
  return sprite.plate { x = BAR_X, y = row * 8 + 4, w = BAR_W, h = 8, bank = hud.banks.alarm, stay = true }
end

-- Opens a bar to a share of its height. The plate is missing if the pool of sprites is full.
local function open_bar(plate, row, share)
  if not plate.alive then return end
  plate.h = math.max(8, math.floor((BAR * 8 - 4) * share))
  plate.y = row * 8 + (BAR * 8 - plate.h) // 2
end

-- Draws a line whose share has grown from the middle.
local function rule(row, share)
  local n = math.floor((COLS - 6) * share)
  if n > 2 then hud.put(COL + (COLS - n) // 2, row, FIRST .. LINE:rep(n - 2) .. LAST, hud.banks.alarm) end
end

-- Returns the lines of the name and their size: 2 if its words fit in two lines, otherwise 1, as for full-width letters.
local function lines_of(name)
  local lines = hud.wrap(name, COLS - 2, 2)
  local whole = table.concat(lines, " ") == name and #lines <= 2
  if whole and not hud.full then return lines, 2 end
  return hud.wrap(name, COLS - 2), 1
end

-- Returns the card between the bars, with its number of rows.
local function card_of(b)
  local lines, size = lines_of(text.lang(b.title))
  local card = { lines = lines, size = size, rows = 6 + 3 * (#lines - 1) + size }
  card.epithet = b.epithet and text.lang(b.epithet)
  if card.epithet then card.rows = card.rows + 2 end
  return card
end

local function draw_card(card, age)
  rule(card.row + 1, math.min(1, age / OPENS))
  rule(card.row + card.rows - 2, math.min(1, age / OPENS))
  if age ~= OPENS then return end
  local row = card.row + 3
  if card.epithet then row = hud.centre(row, card.epithet, hud.banks.plain, COL, COLS) + 1 end
  for _, line in ipairs(card.lines) do
    hud.put(COL + (COLS - sys.cells(line, card.size)) // 2, row, line, hud.banks.bright, card.size)
    row = row + card.size + 1
  end
end

return function(b)
  local word = text.lang("WARNING")
  local letters = utf8.len(word)
  local row = (word .. "  "):rep(COLS // (letters + 2) + 2)
  local card = card_of(b)
  local rows = card.rows + 2 * BAR
  local top = MIDDLE - rows // 2
  local low = top + BAR + card.rows
  local bars = { bar(top), bar(low) }
  card.row = top + BAR
  local tidy <close> = setmetatable({}, { __close = function()
    text.clear { col = COL, row = top, w = COLS, h = rows }
    for _, plate in ipairs(bars) do plate:remove() end
    screen.dim { share = 0, over = OPENS }
  end })
  hud.banner() -- the stage's name would be over the card
  sys.cue("warning")
  screen.dim { share = DIM, over = OPENS }
  for t = 1, b.warning do
    local left = b.warning - t
    local open = math.min(t, left + 1, OPENS)
    for i, plate in ipairs(bars) do open_bar(plate, i == 1 and top or low, open / OPENS) end
    if t % BEAT == 1 and left > OPENS then screen.flash { to = 0xff2040, share = SHARE, over = BEAT - 4 } end
    if left == OPENS then text.clear { col = COL, row = top, w = COLS, h = rows } end
    if left > OPENS then
      local step = t // PACE % (letters + 2)
      if t % PACE == 0 and open == OPENS then
        hud.put(COL, top + 1, part(row, 1 + step, COLS), hud.banks.alarm)
        hud.put(COL, low + 1, part(row, letters + 3 - step, COLS), hud.banks.alarm)
      end
      if t <= OPENS + 1 then draw_card(card, t) end
    end
    wait(1)
  end
end

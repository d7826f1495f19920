-- boss/warning.lua - what announces a boss: the picture darkens between two bars in which WARNING runs, a red light
-- beats, and in the middle stands a card with its epithet and its name.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local OPENS <const> = 16 -- frames the bars take to open, and to close
local PACE <const> = 3   -- frames a letter
local BEAT <const> = 40  -- frames from one light to the next
local BAR <const> = 3    -- rows of a bar: WARNING in its middle
local SHARE <const>, DIM <const> = 0.22, 0.45 -- of the light, of the dark behind

local COL <const>, COLS <const> = hud.place.col, hud.place.cols
local MIDDLE <const> = (rom.field.y + rom.field.h * 2 // 5) // 8
local LINE <const>, FIRST <const>, LAST <const> = hud.glyph(141, "-"), hud.glyph(142, "-"), hud.glyph(143, "-")

-- n characters of s from the i-th on.
local function part(s, i, n) return s:sub(utf8.offset(s, i), (utf8.offset(s, i + n) or #s + 1) - 1) end

-- Its rounded ends are off the screen where the field goes to the screen's edge; nothing of it lies beside the field.
local BEYOND <const> = 8
local BAR_X <const> = rom.field.x > 0 and rom.field.x or -BEYOND
local BAR_END <const> = rom.field.x + rom.field.w
local BAR_W <const> = (BAR_END < rom.screen.w and BAR_END or BAR_END + BEYOND) - BAR_X

local function bar(row)
  return sprite.plate { x = BAR_X, y = row * 8 + 4, w = BAR_W, h = 8, bank = hud.banks.alarm, stay = true }
end

-- Of its height so much is open. Where there was no room for it, there is none.
local function open_bar(plate, row, share)
  if not plate.alive then return end
  plate.h = math.max(8, math.floor((BAR * 8 - 4) * share))
  plate.y = row * 8 + (BAR * 8 - plate.h) // 2
end

-- A line that has grown so far from the middle.
local function rule(row, share)
  local n = math.floor((COLS - 6) * share)
  if n > 2 then hud.put(COL + (COLS - n) // 2, row, FIRST .. LINE:rep(n - 2) .. LAST, hud.banks.alarm) end
end

-- The lines of the name in large letters where all its words have room, else in small ones: lines, size.
local function lines_of(name)
  local lines = hud.wrap(name, (COLS - 2) // 2)
  local whole = table.concat(lines, " ") == name and #lines <= 2
  if whole then return lines, 2 end
  return hud.wrap(name, COLS - 2), 1
end

-- What stands between the bars, and how many rows it has.
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
    hud.put(COL + (COLS - card.size * sys.cells(line)) // 2, row, line, hud.banks.bright, card.size)
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
  hud.banner() -- the stage's name would stand across it
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

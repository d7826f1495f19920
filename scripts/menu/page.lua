-- menu/page.lua - what all screens share: where a page lies, its rules and frames, and lists to choose from.
--
-- A page lies over the field, a cell off its edges, whatever else is on the screen. What moves on it is for the eye: a
-- press counts from a page's second frame on, and nobody waits for a picture.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = {}

local IDLE = 30 * 60 -- frames after which a page that nobody answers gives up
local COMING = 4     -- frames a row is faint when it comes
local BLINK = 16     -- frames the arrows stay as they are
local GROWING = 8    -- frames a window grows
local DIM = 0.45     -- of what is behind a page
local BANNER = 6     -- rows that the hud's banner takes

local LEFT, RIGHT, UP, DOWN = hud.glyph(139, "<"), hud.glyph(140, ">"), hud.glyph(150, "^"), hud.glyph(151, "v")
local LINE, FIRST, LAST, JEWEL = hud.glyph(141, "-"), hud.glyph(142, "-"), hud.glyph(143, "-"), hud.glyph(144, "-")

page.col, page.row = (rom.field.x + 7) // 8, (rom.field.y + 7) // 8
page.cols = (rom.field.x + rom.field.w) // 8 - page.col
page.rows = (rom.field.y + rom.field.h) // 8 - page.row
page.x = rom.field.x + rom.field.w // 2 -- its middle, px
page.low = page.rows < 36               -- there is no room between rows
page.IDLE = IDLE

-- Column i of n side by side: its first column of cells and how many it has, at most `widest`.
function page.column(i, n, widest)
  local room = page.cols // n
  local cols = math.min(room, widest)
  return page.col + (i - 1) * (page.cols - room) + (room - cols) // 2, cols
end

-- ---- who presses what ----

-- Did player p (nil: one of the players) press the button in this frame? An earlier press was not meant for this
-- page. The press is taken, so that the game does not see it as well.
function page.pressed(button, p)
  if p then return pad.take(button, 0, p) end
  return pad.take(button, 0, 1) or pad.take(button, 0, 2)
end

function page.stepped(button, p)
  if page.pressed(button, p) then return true end
  if p then return pad.repeated(button, p) end
  return pad.repeated(button, 1) or pad.repeated(button, 2)
end

function page.accepted(p) return page.pressed("fire", p) or page.pressed("start", p) end

-- -1, 0 or 1: where two buttons step to.
function page.step(less, more, p)
  return (page.stepped(more, p) and 1 or 0) - (page.stepped(less, p) and 1 or 0)
end

-- ---- what stands on a page ----

-- Empties n rows of the page from `row` on, or of a part of it.
function page.clear(row, n, col, cols)
  if n > 0 then text.clear { col = col or page.col, row = row, w = cols or page.cols, h = n } end
end

-- Puts s in the middle, in the language of the run, and returns the row below.
function page.centre(row, s, bank, col, cols)
  return hud.centre(row, s, bank, (col or page.col) + 1, (cols or page.cols) - 2)
end

-- The same with lines `apart` rows apart; nil: as a page has room.
function page.text(row, s, bank, col, cols, apart)
  col, cols = (col or page.col) + 1, (cols or page.cols) - 2
  for _, line in ipairs(hud.wrap(text.lang(s), cols)) do
    hud.put(col + (cols - sys.cells(line)) // 2, row, line, bank)
    row = row + (apart or page.low and 1 or 2)
  end
  return row
end

-- A line across, `age` frames after it came: it grows from its middle.
function page.rule(row, age, col, cols)
  col, cols = col or page.col + 1, cols or page.cols - 2
  local n = math.min(cols, cols % 2 + 4 + 4 * age)
  hud.put(col + (cols - n) // 2, row, FIRST .. JEWEL .. LINE:rep(n - 4) .. JEWEL .. LAST, hud.banks.faint)
end

-- A window in cells, which grows from its middle: page.grow in each frame.
function page.window(col, row, w, h)
  local y = (row + h // 2) * 8
  local plate = sprite.plate { x = col * 8, y = y, w = w * 8, h = 8, bank = hud.banks.plain, stay = true }
  return { plate = plate, middle = row * 8 + h * 4, h = h * 8, col = col, row = row, w = w }
end

function page.grow(window, age)
  if age > GROWING then return end
  local h = math.max(8, window.h * age // GROWING)
  window.plate.y, window.plate.h = window.middle - h // 2, h
end

-- A window over what is played, which gets darker. No half of a line is to look out behind it, so its rows and the
-- banner's are emptied; boot.lua brings back what stood there.
function page.over(col, row, w, h)
  page.clear(row, h)
  page.clear(hud.rows // 3, BANNER)
  local window = page.window(col, row, w, h)
  window.dim = screen.dim { share = 0.55, over = 6 } -- a talk's, or none
  return window
end

function page.close(window)
  if window.dim then screen.dim { share = window.dim, over = 6 } end
  window.plate:remove()
  page.clear(window.row, window.h // 8, window.col, window.w)
end

-- An empty page of its own over what is behind it, and back.
function page.begin()
  text.clear()
  screen.dim { share = DIM, over = GROWING }
end

function page.done()
  if page.plate then page.plate:remove() end
  page.plate = nil
  text.clear()
  screen.dim { share = 0, over = GROWING }
end

-- What the page is, above a rule; returns the first row for what is on it.
function page.head(s, age)
  local row = page.centre(page.row + (page.low and 1 or 3), s, hud.banks.bright)
  page.rule(row + (page.low and 0 or 1), age)
  return row + (page.low and 2 or 4)
end

-- Which buttons do what, above the page's lower edge.
function page.foot(s, age)
  local row = page.row + page.rows - (page.low and 2 or 4)
  if age then page.rule(row - 1, age) end
  page.centre(row, s, hud.banks.faint)
end

-- Does a page that is `age` frames old with `n` rows still change by itself?
function page.opening(age, n) return age <= math.max(2 * n + COMING, GROWING, page.cols // 4) end

-- In what bank is row i drawn that will be in `bank`? Rows come one after the other, faint at first. nil: not yet.
function page.bank(i, age, bank)
  local here = age - 2 * (i - 1)
  if here < 0 then return nil end
  return here < COMING and hud.banks.faint or bank
end

-- ---- lists ----

-- An item in the middle of its list, in the k-th row that is seen: by a line of text, which stands at any pixel, where
-- the board has room for one; in cells one of another parity than the list stands half a cell off.
local function put_item(l, k, item, bank)
  local row = l.row + (k - 1) * l.gap
  local line = l.lines and l.lines[k]
  if l.lines and not (line and line.alive) then
    line = text.line {
      x = l.col * 8 + l.width * 4, y = row * 8, text = item, align = "center", screen = true, stay = true,
    }
    l.lines[k] = line
  end
  if not (line and line.alive) then
    return bank and hud.put(l.col + (l.width - sys.cells(item)) // 2, row, item, bank)
  end
  if line.text ~= item then line.text = item end
  line.hidden = not bank
  if bank then line.bank = bank end
end

-- Scrolls until the chosen one is seen, and shows where there are more.
local function scroll(l, chosen)
  l.first = math.max(chosen - l.seen + 1, math.min(l.first, chosen))
  if l.seen == #l.items then return end
  local up, down = l.first > 1 and UP or " ", l.first + l.seen <= #l.items and DOWN or " "
  hud.put(l.more.col, l.more.up, up, hud.banks.faint)
  hud.put(l.more.col, l.more.down, down, hud.banks.faint)
end

local function draw(l, a, chosen, age)
  local blink = age // BLINK % 2 == 0 and hud.banks.bright or hud.banks.plain
  page.clear(l.row, (l.seen - 1) * l.gap + 1, l.col - 2, l.width + 4)
  scroll(l, chosen)
  for k = 1, l.seen do
    local i = l.first + k - 1
    local word = a.closed and a.closed[i] and "faint" or i == chosen and "bright" or "plain"
    put_item(l, k, l.items[i], page.bank(k, age, hud.banks[word]))
  end
  local at = l.row + (chosen - l.first) * l.gap
  hud.put(l.col - 2, at, RIGHT, blink)
  hud.put(l.col + l.width + 1, at, LEFT, blink)
  if a.note then
    page.clear(l.below, a.notes)
    a.note(chosen, l.below)
  end
end

local function lay_out(a)
  local widest = 1
  for _, item in ipairs(a.items) do widest = math.max(widest, sys.cells(item)) end
  local cols, gap = a.cols or page.cols, a.gap or 2
  widest = math.min(cols, widest + (cols - widest) % 2) -- so that it has as many columns at each side
  local seen = math.min(#a.items, a.most or #a.items)
  local l = {
    items = a.items, row = a.row, gap = gap, width = widest, col = (a.col or page.col) + (cols - widest) // 2,
    first = 1, seen = seen, below = a.row + seen * gap + (page.low and 0 or 1), lines = sys.on("text.line") and {},
  }
  -- Where it says that there is more: beside it, in the empty rows above and below if there are such.
  local off, last = gap > 1 and 1 or 0, a.row + (seen - 1) * gap
  l.more = { col = l.col + widest + (gap > 1 and 1 or 3), up = a.row - off, down = last + off }
  local beyond = math.max(0, math.min(3, l.col - page.col - 1)) -- columns of the bar beside the widest item
  l.bar = sprite.plate {
    x = (l.col - beyond) * 8, y = l.row * 8, w = (widest + 2 * beyond) * 8, h = gap > 1 and 16 or 10, stay = true,
    bank = hud.banks.bright, front = a.front,
  }
  return l
end

-- The bar glides to behind the chosen row: a third of the way in each frame.
local function glide(l, chosen, age)
  local to = (l.row + (chosen - l.first) * l.gap) * 8 + 4 - l.bar.h // 2
  local way = to - l.bar.y
  l.bar.y = (age == 0 or way * way < 1) and to or l.bar.y + way / 3
end

-- Shows items, texts in the language of the run, from `row` on, until one is chosen. If wanted: chosen, p (whose
-- switches), limit (frames; else IDLE), back (what bomb answers; false: nothing), gap (rows from one to the next), col
-- and cols (where on the page), most (items that are seen at a time; the list scrolls), front (true: its bar lies over
-- all plates), closed (of those that cannot be chosen, true), draw(age) for what else is on the page while it opens,
-- keys (true: the cabinet is to tell them), note(chosen, row) for what stands below the list and notes, its rows. Returns
-- the number, or nil.
function page.list(a)
  local l, chosen, answer = lay_out(a), a.chosen or 1, nil
  local idle, age, limit = 0, 0, a.limit or IDLE
  while idle < limit do
    if l.bar.alive then glide(l, chosen, age) end
    if a.draw and page.opening(age, 0) then a.draw(age) end
    if idle < 2 or age % BLINK == 0 or page.opening(age, #a.items) then draw(l, a, chosen, age) end
    if a.keys then sys.tell_keys() end
    wait(1) -- the press that opened this list is not meant for it
    idle, age = idle + 1, age + 1
    local step = page.step("up", "down", a.p)
    if step ~= 0 then
      chosen, idle = (chosen - 1 + step) % #a.items + 1, 0
      sys.cue("menu")
    end
    if page.accepted(a.p) then
      local open = not (a.closed and a.closed[chosen])
      sys.cue(open and "select" or "wrong")
      answer = open and chosen or nil
      if open then break end
    end
    if a.back ~= false and page.pressed("bomb", a.p) then
      sys.cue("back")
      answer = a.back
      break
    end
  end
  l.bar:remove()
  for _, line in pairs(l.lines or {}) do line:remove() end
  page.clear(l.row, (l.seen - 1) * l.gap + 1, l.col - 2, l.width + 4)
  if l.seen < #l.items then
    page.clear(l.more.up, 1, l.more.col, 1)
    page.clear(l.more.down, 1, l.more.col, 1)
  end
  if a.note then page.clear(l.below, a.notes) end
  return answer
end

-- How many rows the longest of these texts takes below a list; some may be missing.
function page.notes(texts, n)
  local most = 0
  for i = 1, n do
    local lines = texts[i] and #hud.wrap(text.lang(texts[i]), page.cols - 2) or 0
    most = math.max(most, page.low and lines or 2 * lines)
  end
  return most
end

-- A plate behind n rows from `row` on, a row off them; it goes with page.done.
function page.frame(row, n)
  page.plate = sprite.plate {
    x = page.col * 8 + 4, y = row * 8 - 8, w = page.cols * 8 - 8, h = n * 8 + 16, bank = hud.banks.plain, stay = true,
  }
end

-- A page of its own with a list: head, and what page.list takes but for its row; the texts of items are names.
function page.ask(head, a)
  page.begin()
  local top, gap = page.head(head, 0), a.gap or 2
  local room = page.row + page.rows - (page.low and 3 or 7) - top
  a.most = math.max(1, math.min(#a.items, (room - (a.notes or 0) - 1) // gap))
  local rows = gap * a.most + (a.notes or 0)
  a.row = top + math.max(page.low and 0 or 1, (room - rows) // 3)
  if not page.low then page.frame(a.row - 1, rows + 2) end
  a.keys = true
  a.draw = function(age)
    page.head(head, age)
    page.foot("FIRE: OK  BOMB: BACK", age)
  end
  local answer = page.list(a)
  page.done()
  return answer
end

return page

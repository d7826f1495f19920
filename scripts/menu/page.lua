-- menu/page.lua - what all screens share: the layout of a page, its heading, rules and frames, and lists to choose from.
--
-- A page uses the whole screen, except for a column at each side. Animations never delay input: a press counts from a
-- page's second frame on. Rows can be fractions of a cell: half a row is 4 px.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = {}

local IDLE = 30 * 60 -- frames without input after which a page closes
local FAINT = 4      -- frames that a new row is faint
local BLINK = 16     -- frames that the arrow keeps its colour
local GROWING = 8    -- frames in which a window grows
local DIM = 0.45     -- share of black behind a page
local BANNER = 6     -- rows of the HUD's banner
local FOOT = hud.rows - (hud.full and 1.25 or 1.5) -- the row of what the buttons do, below the program's band

local RIGHT, UP, DOWN = hud.glyph(140, ">"), hud.glyph(150, "^"), hud.glyph(151, "v")
local LINE, FIRST, LAST, JEWEL = hud.glyph(141, "-"), hud.glyph(142, "-"), hud.glyph(143, "-"), hud.glyph(144, "-")

if not hud.is_playing() then sys.show_whole(true) end

page.col, page.row = 0, 0
page.cols, page.rows = hud.cols, hud.rows
page.x = rom.screen.w // 2              -- its middle, px
page.low = page.rows < 36               -- no empty rows between rows
page.first = page.low and 4 or 6        -- the first row below a heading of one line
page.bottom = page.rows - (page.low and 2 or 4) -- the row below a page's content
page.pitch = hud.full and 1.75 or page.low and 1.25 or 1.5 -- rows from one line of a paragraph to the next
page.IDLE, page.GROWING = IDLE, GROWING

-- What the buttons do on a page, for page.foot and page.tell: a button, what it does, the next button ...
page.SELECT, page.BACK = { "fire", "Select", "bomb", "Back" }, { "bomb", "Back" }

-- Returns the first cell and the width, at most `widest`, of column i of n columns side by side.
function page.column(i, n, widest)
  local room = page.cols // n
  local cols = math.min(room, widest)
  return page.col + (i - 1) * (page.cols - room) + (room - cols) // 2, cols
end

-- ---- buttons ----

-- Returns whether player p (nil: either player) pressed the button in this frame. Takes the press, so the game doesn't
-- see it.
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

-- Returns -1, 0 or 1: the step of two buttons.
function page.step(less, more, p)
  return (page.stepped(more, p) and 1 or 0) - (page.stepped(less, p) and 1 or 0)
end

-- ---- text and plates ----

-- Clears n rows from `row` on, in the whole page or in some columns. A row that is a fraction is in the cell above.
function page.clear(row, n, col, cols)
  local h = math.floor(row + n - 1) - math.floor(row) + 1
  if n > 0 then text.clear { col = col or page.col, row = row, w = cols or page.cols, h = h } end
end

page.wrap = hud.balance

-- A number on a page: "1,234,567". The HUD and numbers in the field have no commas.
function page.number(n)
  local digits, many = tostring(n), 1
  while many > 0 do digits, many = digits:gsub("^(%-?%d+)(%d%d%d)", "%1,%2") end
  return digits
end

-- A result of a mission: an amount, or a time in minutes, seconds and hundredths.
function page.amount(by, value)
  if by ~= "time" then return page.number(value) end
  local minutes, seconds = value // 3600, ("%d.%02d"):format(value // 60 % 60, value % 60 * 100 // 60)
  return minutes == 0 and seconds or ("%d:%s"):format(minutes, value // 60 % 60 < 10 and "0" .. seconds or seconds)
end

-- The name of what a mission counts.
function page.measure(by) return by == "time" and text.lang("Time") or menu.label(by) end

-- Translates and centres s; returns the row below.
function page.centre(row, s, bank, col, cols)
  return hud.centre(row, s, bank, (col or page.col) + 1, (cols or page.cols) - 2)
end

-- Translates s and centres it as a paragraph, a column off the edges; returns the first row below. apart: rows from one
-- line to the next.
function page.text(row, s, bank, col, cols, apart)
  col, cols = (col or page.col + 1) + 1, (cols or page.cols - 2) - 2
  for _, line in ipairs(page.wrap(text.lang(s), math.max(1, cols))) do
    hud.put(col + (cols - sys.cells(line)) / 2, row, line, bank)
    row = row + (apart or page.pitch)
  end
  return math.ceil(row)
end

-- n stars out of `most`, from `col` on, those that are missing as dots.
local STAR <const>, DOT <const> = hud.glyph(138, "*"), hud.glyph(183, ".")
function page.stars(col, row, n, most, bank)
  hud.put(col, row, STAR:rep(n), bank or hud.banks.bright)
  hud.put(col + n, row, DOT:rep(most - n), hud.banks.faint)
end

-- Draws a line that grows from its middle, `age` frames after it appeared.
function page.rule(row, age, col, cols)
  col, cols = col or page.col + 2, cols or page.cols - 4
  local n = math.min(cols, cols % 2 + 4 + 4 * age)
  hud.put(col + (cols - n) // 2, row, FIRST .. JEWEL .. LINE:rep(n - 4) .. JEWEL .. LAST, hud.banks.faint)
end

-- Opens a window, in cells, that grows from its middle; call page.grow in each frame.
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

-- Opens a window over the game, which darkens. Clears the window's rows and the banner's, so that no part of a line
-- shows next to the window; boot.lua restores them.
function page.over(col, row, w, h)
  page.clear(row, h)
  page.clear(hud.rows // 3, BANNER)
  local window = page.window(col, row, w, h)
  window.dim = screen.dim { share = 0.55, over = 6 } -- the dim before: that of a dialogue, or none
  sys.hide_rows() -- a side panel is in the way
  return window
end

function page.close(window)
  if window.dim then
    screen.dim { share = window.dim, over = 6 }
    sys.hide_rows(false, true)
  end
  window.plate:remove()
  page.clear(window.row, window.h // 8, window.col, window.w)
end

-- page.begin opens an empty page over a darkened picture; page.done closes it.
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

-- Draws the heading above a rule, as on the program's screens; returns the first row below.
function page.head(s, age)
  local row = page.centre(page.row + (page.low and 1 or 3.375), s, hud.banks.bright)
  page.rule(row + (page.low and 0 or 0.625), age)
  return math.ceil(row + 2)
end

-- Tells the program what the buttons of player 1, or of n players, do; to be called in each frame.
function page.tell(keys, n)
  for p = 1, n or 1 do
    for i = 1, #keys, 2 do sys.tell_key(keys[i], keys[i + 1], p) end
  end
end

-- Writes the same in the last row, for machines without a program: "Fire: Select  Bomb: Back". A program that shows the
-- keys covers this line. Buttons that don't fit are left out, and so are those with their own name.
function page.foot(keys)
  local s = ""
  for i = 1, #keys, 2 do
    local name, meaning = menu.label(keys[i]), text.lang(keys[i + 1])
    local longer = (s == "" and "" or s .. "  ") .. name .. ": " .. meaning
    if name ~= meaning and sys.cells(longer) <= page.cols - 2 then s = longer end
  end
  page.clear(FOOT, 1)
  page.centre(FOOT, s, hud.banks.faint)
end

-- Returns whether a page that is `age` frames old and has n rows is still opening.
function page.opening(age, n) return age <= math.max(2 * n + FAINT, GROWING, page.cols // 4) end

-- Returns the bank in which to draw row i, which ends up in `bank`: rows appear one after the other, faint at first.
-- nil: the row isn't shown yet.
function page.bank(i, age, bank)
  local here = age - 2 * (i - 1)
  if here < 0 then return nil end
  return here < FAINT and hud.banks.faint or bank
end

-- ---- lists ----

-- The bar behind the chosen row of a list, and how it glides there: a third of the way in each frame. Its height is odd,
-- as that of capitals, so that these are in its middle.
function page.bar(col, row, cols, gap, front)
  return sprite.plate {
    x = col * 8, y = row * 8, w = cols * 8, h = gap <= 1 and 11 or hud.full and 17 or 15, stay = true, bank = hud.banks.bright,
    front = front,
  }
end

local CAPITALS <const> = 7 -- height of capitals, px

function page.glide(bar, row, at_once)
  if not bar.alive then return end
  local to = row * 8 - (bar.h - CAPITALS) // 2 + (hud.full and 1 or 0) -- full-width letters are 1 px lower
  local way = to - bar.y
  bar.y = (at_once or way * way < 1) and to or bar.y + way / 3
end

-- Says how to open what is locked, given the hint of its unlock.
function page.how_to_unlock(hint)
  return hint == "" and "" or text.lang("To unlock: %s"):format(text.lang(hint))
end

-- The arrow before the chosen row.
function page.cursor(col, row, age)
  hud.put(col, row, RIGHT, age // BLINK % 2 == 0 and hud.banks.bright or hud.banks.plain)
end

-- Scrolls to the chosen item, and shows where more items are.
local function scroll(l, chosen)
  l.first = math.max(chosen - l.seen + 1, math.min(l.first, chosen))
  if l.seen == #l.items then return end
  local up, down = l.first > 1 and UP or " ", l.first + l.seen <= #l.items and DOWN or " "
  hud.put(l.more.col, l.more.up, up, hud.banks.faint)
  hud.put(l.more.col, l.more.down, down, hud.banks.faint)
end

local function draw(l, a, chosen, age)
  page.clear(l.row, (l.seen - 1) * l.gap + 1, l.col - 2, l.width + 4)
  scroll(l, chosen)
  for k = 1, l.seen do
    local i = l.first + k - 1
    local word = a.closed and a.closed[i] and "faint" or i == chosen and "bright" or "plain"
    local item, bank = l.items[i], page.bank(k, age, hud.banks[word])
    if bank then hud.put(l.col + (l.width - sys.cells(item)) / 2, l.row + (k - 1) * l.gap, item, bank) end
  end
  page.cursor(l.col - 2, l.row + (chosen - l.first) * l.gap, age)
  if a.note then
    page.clear(l.below, a.notes)
    a.note(chosen, l.below)
  end
end

local function lay_out(a)
  local widest = 1
  for _, item in ipairs(a.items) do widest = math.max(widest, math.ceil(sys.cells(item))) end
  local cols, gap = a.cols or page.cols, a.gap or 2
  widest = math.min(cols, widest + (cols - widest) % 2) -- equal columns on both sides
  local seen = math.min(#a.items, a.most or #a.items)
  local l = {
    items = a.items, row = a.row, gap = gap, width = widest, col = (a.col or page.col) + (cols - widest) // 2,
    first = 1, seen = seen, below = math.ceil(a.row + seen * gap) + (page.low and 0 or 1),
  }
  -- The marks for more items: above and below the list; next to it if it has no empty rows.
  local off, last = gap > 1 and gap * 0.75 or 0, a.row + (seen - 1) * gap
  l.more = { col = l.col + (gap > 1 and (widest - 1) / 2 or widest + 3), up = a.row - off, down = last + off }
  local beyond = math.max(0, math.min(3, l.col - page.col - 1)) -- columns of the bar on each side of the widest item
  l.bar = page.bar(l.col - beyond, l.row, widest + 2 * beyond, gap, a.front)
  return l
end

-- Shows a list of translated items, from `row` on, until one is chosen. Optional: chosen; p (the player who chooses);
-- limit (frames, default IDLE); back (the result of bomb; false: bomb does nothing); gap (rows from one item to the
-- next); col and cols (part of the page); most (items shown at a time; the list scrolls); front (the bar is over all
-- plates); closed (true for items that can't be chosen); draw(age), called while the page opens; keys (what the program
-- shows about the buttons: page.SELECT); note(chosen, row), which draws below the list, and notes, its rows. Returns the
-- number of the item, or nil.
function page.list(a)
  local l, chosen, answer = lay_out(a), a.chosen or 1, nil
  local idle, age, limit = 0, 0, a.limit or IDLE
  while idle < limit do
    page.glide(l.bar, l.row + (chosen - l.first) * l.gap, age == 0)
    if a.draw and page.opening(age, 0) then a.draw(age) end
    if idle < 2 or age % BLINK == 0 or page.opening(age, #a.items) then draw(l, a, chosen, age) end
    if a.keys then page.tell(a.closed and a.closed[chosen] and page.BACK or a.keys) end
    wait(1) -- the press that opened this list doesn't count
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
  page.clear(l.row, (l.seen - 1) * l.gap + 1, l.col - 2, l.width + 4)
  if l.seen < #l.items then
    page.clear(l.more.up, 1, l.more.col, 1)
    page.clear(l.more.down, 1, l.more.col, 1)
  end
  if a.note then page.clear(l.below, a.notes) end
  return answer
end

-- Returns the rows of the longest of n texts, some of which may be nil.
function page.notes(texts, n)
  local most = 0
  for i = 1, n do
    if texts[i] then most = math.max(most, #hud.wrap(text.lang(texts[i]), page.cols - 4)) end
  end
  return math.ceil(most * page.pitch)
end

-- Puts a panel over the top of the screen, down to `row`; entities pass behind it. page.done removes it.
function page.panel(row)
  local x, y = page.low and 0 or 8, page.low and 0 or 8
  page.plate = sprite.plate {
    x = x, y = y, w = rom.screen.w - 2 * x, h = row * 8 - y, stay = true, bank = hud.banks.plain,
  }
end

-- Puts a plate behind the page, as on the program's screens: 8 px from the edges and from the keys at the lower edge. A
-- low page has no room for it. page.done removes it.
function page.frame()
  if page.low then return end
  page.plate = sprite.plate {
    x = 8, y = 8, w = rom.screen.w - 16, h = rom.screen.h - 29, bank = hud.banks.plain, stay = true,
  }
end

-- Shows a page with a heading and a list: a is as for page.list, without row; keys: page.SELECT by default.
function page.ask(head, a)
  page.begin()
  local top, gap = page.head(head, 0), a.gap or 2
  local room = page.bottom - top
  a.most = math.max(1, math.min(#a.items, (room - (a.notes or 0) - 2) // gap))
  local rows = gap * a.most + (a.notes or 0)
  a.row = top + math.max(page.low and 0 or 1, (room - rows) // 3)
  page.frame()
  a.keys = a.keys or page.SELECT
  a.draw = function(age)
    page.head(head, age)
    page.foot(a.keys)
  end
  local answer = page.list(a)
  page.done()
  return answer
end

return page

-- talk/box.lua - the look of a dialogue: a plate at the bottom of the screen with the words, on its upper edge a tag
-- with the speaker's name, two portraits behind them, and a list to choose from. Returns a function that opens one.
local sys = ... -- functions for the standard library only; documented in src/script/api/api_sys.c

local ROWS = 3   -- rows of words, two cells apart
local APART = hud.full and 2 or 1 -- cells from one row of an item of a list to the next
local TALL = 15  -- rows of cells that a portrait takes above the first row
local HELD = 20  -- frames that special is held before it skips the talk
local HURRY = 30 -- frames that fire is held before it repeats,
local QUICK = 6  -- and from then on from one repetition to the next
local AWAY = 40  -- px that a portrait enters from
local BLINK = 32 -- frames from one blink of the arrow to the next,
local SHOWN = 22 -- in which it is shown for this long
local BEEP = 4   -- frames from one beep of a voice to the next, at least
local PAN = 0.3  -- pan of a voice towards its speaker's side

-- Cells: the middle of the screen, at most 40 wide.
local cols = math.max(8, math.min(hud.cols - 4, 40))
local left = (hud.cols - cols) // 2
local last = hud.rows - 5 -- the plate ends above the program's keys
local first = last - 2 * (ROWS - 1)
local plate = { x = 8 * left - 10, y = 8 * first - 16, w = 8 * cols + 20, h = 16 * ROWS + 19 }
local NAME_ROW = plate.y / 8 - 0.5 -- the tag's middle is on the plate's upper edge
local ARROW, MORE = hud.glyph(140, ">"), hud.glyph(151, "v")

-- Breaks words into rows of at most `width` cells; a newline starts a row.
local function rows_of(words, width)
  local rows = {}
  for line in (words .. "\n"):gmatch("(.-)\n") do
    for _, row in ipairs(hud.wrap(line, width)) do rows[#rows + 1] = row end
  end
  return rows
end

local function pressed(how, button, p)
  if p then return sys.pad(how, button, p) end
  return sys.pad(how, button, 1) or sys.pad(how, button, 2)
end

return function(look, may_skip, fire)
  local t = {}
  local sides, parts = {}, {} -- "left" or "right" -> { sprite, talker, x, y: its target }; plates by name
  local mark -- age of the arrow that shows that a button continues; nil: no arrow
  local lines = {} -- words in a font
  local dimmed = screen.dim { share = look.dim, over = 12 }
  sys.hide_rows() hud.banner() -- they would be over the plates

  -- Shows a plate. It outlives the scene in which it is made, because the text on it does.
  local function put_plate(key, x, y, w, h)
    local p = parts[key]
    if p then
      p.x, p.y, p.w, p.h, p.hidden = x, y, w, h, false
    else
      parts[key] = sprite.plate { x = x, y = y, w = w, h = h, bank = look.bank, front = true, stay = true }
    end
  end

  local function write(col, row, words, bank)
    text.put { col = col, row = row, text = words, bank = bank, full_width = true }
  end

  local function wipe_words()
    for _, line in ipairs(lines) do line:remove() end
    lines, mark = {}, nil
    text.clear { col = left, row = first, w = cols, h = 2 * ROWS }
  end

  -- ---- portraits ----

  -- Sets the target of a portrait: behind the plate, moved inwards while its character speaks.
  local function aim(side, speaks)
    local s = sides[side]
    local w, h, x, y = sys.size(s.sprite.sprite)
    local forward = speaks and 8 or 0
    s.x = side == "left" and plate.x + 2 + forward + x or plate.x + plate.w - 2 - forward - (w - x)
    s.y = plate.y + 4 - (h - y) + (speaks and 0 or 5)
    s.sprite.layer = speaks and "over" or "front" -- the dim darkens what is in front
  end

  local function enter(talker, side)
    local s = sides[side]
    if s and s.talker == talker then return s end
    if s then s.sprite:remove() end
    s = { talker = talker, sprite = sprite.put { sprite = talker.faces[talker.face], x = 0, y = 0, bank = talker.bank,
                                                 screen = true, flip_x = side == "right", stay = true } }
    if not s.sprite.alive then return nil end
    sides[side] = s
    aim(side, true)
    s.sprite.x, s.sprite.y = s.x + (side == "left" and -AWAY or AWAY), s.y
    return s
  end

  -- Shows the speaker's portrait with its face and moves the other one back.
  local function show(talker, a)
    local side = talker and (a.side or talker.side)
    if talker and talker.faces then
      talker.face = a.face or talker.face
      local other = side == "left" and "right" or "left"
      if sides[other] and sides[other].talker == talker then
        sides[other].sprite:remove()
        sides[other] = nil
      end
      local s = enter(talker, side)
      if s then s.sprite.sprite = talker.faces[talker.face] end
    end
    for key, s in pairs(sides) do aim(key, s.talker == talker) end
  end

  local function step()
    for _, s in pairs(sides) do
      local p = s.sprite
      if p.alive then p.x, p.y = p.x + (s.x - p.x) * 0.25, p.y + (s.y - p.y) * 0.25 end
    end
  end

  -- ---- words ----

  local function show_name(talker, side)
    if parts.name then parts.name.hidden = true end
    text.clear { col = left, row = NAME_ROW // 1, w = cols, h = 1 }
    if not talker then return end
    local name = hud.wrap(text.lang(talker.name), cols - 2)[1] -- of a long name, the words that fit
    local n = sys.cells(name)
    local col = left + (side == "right" and cols - 1 - n or 1) -- over the portrait's lower edge
    put_plate("name", 8 * col - 9, plate.y - 8, 8 * n + 18, 16)
    write(col, NAME_ROW, name, hud.banks.bright)
  end

  local function hurries(p) return fire[p] and fire[p] >= HURRY and (fire[p] - HURRY) % QUICK == 0 end

  -- Waits n frames. Returns true as soon as fire is pressed or repeats.
  local function answered(n)
    for _ = 1, n do
      wait(1)
      if sys.skipping() or pressed("pressed", "fire") or hurries(1) or hurries(2) then return true end
    end
    return false
  end

  -- Beeps with each letter, but at most once in BEEP frames.
  local function speak(a, n)
    local every = a.letter < BEEP and -(-BEEP // math.max(a.letter, 1)) or 1
    if a.beep and n % every == 0 then sys.cue(a.beep, a.pan) end
  end

  -- Types the rows, a letter every a.letter frames; fire shows the rest at once.
  local function come(a, rows)
    local hurry, letter, n = a.letter == 0, a.letter, 0
    for i, row in ipairs(rows) do
      local y, x = first + 2 * (i - 1), left
      for _, code in utf8.codes(hurry and "" or row) do
        local letter_of_row = utf8.char(code)
        write(x, y, letter_of_row, hud.banks.plain)
        x = x + sys.cells(letter_of_row)
        if code ~= 32 then
          speak(a, n)
          n = n + 1
        end
        hurry = hurry or code ~= 32 and answered(letter)
        if hurry then break end
      end
      if hurry then write(left, y, row, hud.banks.plain) end
    end
  end

  local function come_in_font(a, words)
    local frames = 0
    local put = { x = 8 * left, y = 8 * first - 2, text = words, width = 8 * cols, font = look.font, screen = true,
                  bank = hud.banks.plain, letter = a.letter, stay = true }
    local line = text.line(put)
    lines[1] = line
    while line.alive and not line.done do
      if frames % math.max(a.letter, 1) == 0 then speak(a, frames // math.max(a.letter, 1)) end
      frames = frames + 1
      if answered(1) then
        line:remove()
        put.letter = 0
        lines[1] = text.line(put)
      end
    end
  end

  local function page(a, rows, words)
    wipe_words()
    if look.font then come_in_font(a, words) else come(a, rows) end
    if sys.skipping() then return end
    mark = 0
    local left_over = a.limit or forever
    while left_over > 0 and not answered(1) do left_over = left_over - 1 end
    mark = nil
  end

  function t.say(talker, words, a)
    put_plate("words", plate.x, plate.y, plate.w, plate.h)
    show(talker, a)
    show_name(talker, talker and (a.side or talker.side))
    local voice = a.voice or talker and talker.voice
    a.beep, a.pan = not a.voice and voice, talker and ((a.side or talker.side) == "left" and -PAN or PAN) or 0
    if voice and (a.voice or a.letter == 0) then sys.cue(voice, a.pan) end
    local rows = look.font and {} or rows_of(words, cols)
    if look.font then page(a, nil, words) end
    for from = 1, #rows, ROWS do
      if not sys.skipping() then page(a, { table.unpack(rows, from, from + ROWS - 1) }) end
    end
    if a.voice then sound.stop(a.voice) end
  end

  -- ---- a list ----

  local function stepped(button, p) return pressed("repeated", button, p) end

  -- Returns the list's place in cells, and each item's rows of text and its first row.
  local function lay_out(items, title)
    local l = { items = {}, w = 0, h = 0 }
    for i, item in ipairs(items) do
      local rows = rows_of(item, cols - 2)
      l.items[i] = { rows = rows, row = l.h }
      l.h = l.h + APART * (#rows - 1) + 2
      for _, row in ipairs(rows) do l.w = math.max(l.w, math.ceil(sys.cells(row))) end
    end
    l.h, l.w = l.h - 1, l.w + 2
    l.title = title and rows_of(title, cols) or {}
    for _, row in ipairs(l.title) do l.w = math.max(l.w, math.ceil(sys.cells(row))) end
    local above = #l.title > 0 and APART * (#l.title - 1) + 2 or 0
    l.col = left + (cols - l.w) // 2
    l.rows = above + l.h
    l.top = math.max(5, math.min((hud.rows - l.rows) // 2, first - TALL - l.rows)) -- above the heads, if it fits
    for _, item in ipairs(l.items) do item.row = item.row + l.top + above end
    return l
  end

  local function draw_list(l, chosen)
    for i, row in ipairs(l.title) do write(l.col + (l.w - sys.cells(row)) // 2, l.top + APART * (i - 1), row, hud.banks.bright) end
    for i, item in ipairs(l.items) do
      local bank = i == chosen and hud.banks.bright or hud.banks.plain
      write(l.col, item.row, i == chosen and ARROW or " ", bank)
      for k, row in ipairs(item.rows) do write(l.col + 2, item.row + APART * (k - 1), row, bank) end
    end
  end

  local function ask(l, a, n)
    local chosen, over = a.chosen, a.limit or forever
    while over > 0 do
      draw_list(l, chosen)
      wait(1)
      over = over - 1
      if sys.skipping() then return a.chosen end
      if pressed("pressed", "fire", a.p) then return chosen end
      if a.back and pressed("pressed", "bomb", a.p) then return a.back end
      local by = (stepped("down", a.p) and 1 or 0) - (stepped("up", a.p) and 1 or 0)
      chosen = (chosen - 1 + by) % n + 1
    end
    return chosen
  end

  function t.choose(items, a)
    local l = lay_out(items, a.title)
    put_plate("list", 8 * l.col - 11, 8 * l.top - 9, 8 * l.w + 22, 8 * l.rows + 18)
    sys.hold_players(2) -- up and down are the list's
    local answer = ask(l, a, #items)
    sys.hold_players(t.hold)
    text.clear { col = l.col, row = l.top, w = l.w, h = l.rows }
    parts.list.hidden = true
    return answer
  end

  -- ---- its task ----

  local function blink()
    if not mark then return end
    if mark % BLINK == 0 then write(left + cols - 1, last + 1, MORE, hud.banks.bright) end
    if mark % BLINK == SHOWN then write(left + cols - 1, last + 1, " ", hud.banks.bright) end
    mark = mark + 1
  end

  local watch = task.go(function()
    local held = 0
    while true do
      step()
      blink()
      local follows_talk = fire.seen == sys.clock() - 1 -- the talk before ended in this frame
      fire.seen = sys.clock()
      for p = 1, 2 do
        local since = sys.pad("pressed", "fire", p) and 0 or follows_talk and fire[p]
        fire[p] = since and sys.pad("down", "fire", p) and since + 1 or nil
      end
      if mark then
        sys.tell_key("fire", "Next")
        if may_skip then sys.tell_key("special", "Hold to Skip") end
      end
      held = pressed("down", "special") and held + 1 or 0
      if may_skip and held == HELD then
        t.skipped = true
        sys.skip(true, t.task)
      end
      wait(1)
    end
  end)

  -- Removes everything, unless the screen was wiped: then other text may be there. last_one: the dim is this talk's.
  function t.close(last_one)
    task.stop(watch)
    local there = not parts.words or parts.words.alive
    if parts.words and there then
      wipe_words()
      show_name()
    end
    for _, p in pairs(parts) do p:remove() end
    for _, s in pairs(sides) do s.sprite:remove() end
    sys.hide_rows(false, true)
    if last_one and there then screen.dim { share = dimmed, over = 12 } end
  end

  return t
end

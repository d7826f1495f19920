-- boss/rows.lua - what the hud shows of a fight: bars with a pip for each phase to come, the clock in large digits, the
-- title, a mark below at the field's edge, and a spell's name, which is declared in the middle of the field and slides up
-- to its place, with its bonus and how often it was captured. Over the field all that is three rows and no more.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local LEFT <const>, WIDTH <const> = hud.place.left, hud.place.width
local CLOCK <const> = 4                -- columns of two large digits
local NARROW <const> = WIDTH < 20      -- the title stands below the clock, not beside it, and several bars below that
local SHORT <const> = WIDTH - CLOCK - (NARROW and 1 or 2)
local PIP <const>, RULE <const> = hud.glyph(152, "*"), hud.glyph(141, "-")
local FEW <const> = 6                  -- so many pips stand side by side
local FILLS <const> = 30               -- frames a bar takes to fill
local DOWN <const> = 4                 -- a bar is of alarm when less than one part in so many is left
local MARK <const> = "boss_marker"     -- a sprite of this name, if the game has it, stands below the boss
local MARGIN <const> = 3               -- px below that sprite, so that it is seen whole
local LATE <const>, LAST <const> = 10, 5 -- seconds from which on the clock is bright, and blinks

-- A spell's name, in frames of its phase: it is written, stands, and slides.
local WRITTEN <const>, STANDS <const>, SLIDES <const> = 14, 36, 30
local VERDICT <const> = 7             -- rows that the verdict on a phase stands above the next name
local COL <const>, COLS <const> = hud.place.col + 1, hud.place.cols - 2
local HIGH <const>, LOW <const> = rom.field.y // 8 + 1, (rom.field.y + rom.field.h * 5 // 8) // 8

local top           -- the first row, nil: nothing is shown
local height = 0    -- rows from there on
local bars = {}     -- of the phase: e, full, name and row
local phase         -- the one that is shown
local spell         -- lines of its name, and short, the one that is left of them in the end; row, where they stand;
                    -- rest, their row in the end
local pips          -- how many phases are to come, of those that are shown
local seen = {}     -- what is on the screen, by what it is
local past          -- how often the spell was captured, of how many times
local mark          -- the sprite below
local told          -- the banner may tell how the phase before ended

local function new(what, value)
  if seen[what] == value then return false end
  seen[what] = value
  return true
end

-- The first n characters of s.
local function cut(s, n)
  local to = utf8.offset(s, n + 1)
  return to and s:sub(1, to - 1) or s
end

local function right(row, s, bank, from, cols) hud.put(from + math.max(0, cols - sys.cells(s)), row, s, bank) end

-- Lines above and below the name while it stands in the middle, growing from there.
local function draw_rules(age)
  local n = math.min(COLS - 2, 2 + 2 * age)
  local line = age <= STANDS and RULE:rep(n) or ""
  for _, row in ipairs { LOW - 2, LOW + #spell + 1 } do
    if line == "" then text.clear { col = COL, row = row, w = COLS, h = 1 } end
    hud.put(COL + (COLS - n) // 2, row, line, hud.banks.faint)
  end
end

local function wipe_spell()
  if not (spell and spell.row) then return end
  text.clear { col = COL, row = spell.row, w = COLS, h = spell.h + 1 }
  if not spell.there then draw_rules(STANDS + 1) end
  seen.bonus, spell.row = nil, nil
end

local function forget() top, phase, spell, seen = nil, nil, nil, {} end

local function draw_mark(b)
  if not rom.has(MARK) then return end
  local e
  for _, one in ipairs(b and b.team or {}) do e = e or one.alive and one end
  if not e then
    if mark and mark.alive then mark:remove() end
    mark = nil
    return
  end
  local x, y = math.max(0, math.min(rom.field.w, e.x)), rom.field.h - MARGIN
  if mark and mark.alive then mark.x = x
  else mark = sprite.put { sprite = MARK, x = x, y = y, layer = "front", stay = true } end
end

local function wipe()
  if not top then return end
  text.clear { col = LEFT, row = top, w = WIDTH, h = height }
  wipe_spell()
  forget()
end

-- s in one row of `width` cells: what is before a colon goes first, then whole words at its end.
local function in_a_row(s, width)
  if sys.cells(s) > width then s = s:match(":%s*(.+)") or s end
  return hud.wrap(s, width)[1] or ""
end

-- What is declared stands whole: the word before its colon in a row of its own, if one row has no room for all.
local function lines_of(name, width)
  local word, rest = name:match("^(.-:)%s*(.+)$")
  if not word or sys.cells(name) <= width then return hud.wrap(name, width) end
  local lines = hud.wrap(rest, width)
  table.insert(lines, 1, word)
  return lines
end

-- A bar each for those who have one: of all together in the top row; of several each in a row, its name before it, in a
-- narrow panel above. Returns the row below them.
local function list_bars(b, row)
  local hp, label = phase and not phase.survive and phase.hp, 0
  local cols = SHORT - (not NARROW and pips > 0 and pips + 1 or 0)
  bars = {}
  if type(hp) ~= "table" then
    if hp then bars[1] = { e = b.team[1], full = hp, row = top, col = LEFT, cols = cols } end
    return NARROW and row or row + 1
  end
  for i, m in ipairs(b.boss.cast) do
    local name = cut(text.lang(m.title), NARROW and WIDTH or SHORT // 3)
    if hp[m.name] then bars[#bars + 1] = { e = b.team[i], full = hp[m.name], name = name } end
    label = NARROW and 0 or math.max(label, sys.cells(name) + 1)
  end
  for i, bar in ipairs(bars) do
    hud.put(LEFT, row, bar.name)
    bar.row, bar.col, bar.cols = NARROW and row + 1 or row, LEFT + label, NARROW and WIDTH or cols - label
    row = bar.row + 1
  end
  return row
end

-- The title: over the field one row beside the clock, and none where bars have names; in a narrow panel as many rows as
-- it needs, then the pips and the bars. Returns the row below.
local function put_title(b, row)
  if not NARROW then
    hud.put(LEFT + SHORT - pips, top, PIP:rep(pips))
    if bars[1] and bars[1].name then return row end
    hud.put(LEFT, row, in_a_row(text.lang(b.boss.title), SHORT + 1))
    return row + 1
  end
  local last = 0
  for _, line in ipairs(hud.wrap(text.lang(b.boss.title), WIDTH)) do
    hud.put(LEFT, row, line)
    row, last = row + 1, sys.cells(line)
  end
  if pips > 0 and last + 1 + pips > WIDTH then row = row + 1 end
  hud.put(LEFT + WIDTH - pips, row - 1, PIP:rep(pips))
  return list_bars(b, row)
end

-- Writes what stays as it is in a phase, and finds the places of all else.
local function lay_out(b, row)
  wipe()
  top, phase = row, b.phase
  pips = math.min(b.left or 0, FEW)
  row = put_title(b, NARROW and row + 2 or list_bars(b, row))
  height = math.max(row - top, 2)
  if phase and phase.spell then
    local name = text.lang(phase.spell)
    spell = lines_of(name, COLS)
    spell.short = in_a_row(name, COLS)
    local tries, captures = sys.history(b.boss.name, phase.id, 0)
    past = tries > 0 and ("%d/%d"):format(captures, tries) or ""
    spell.rest = hud.place.panel and HIGH or top + height
  end
end

local function draw_bars(age)
  for i, bar in ipairs(bars) do
    local hp = bar.e.hp or 0
    if age < FILLS then hp = math.min(hp, bar.full * age // FILLS) end
    if new(i, hp) then
      local s, bank = hud.bar(hp, bar.full, bar.cols), hud.banks.bright
      if age >= FILLS and hp * DOWN < bar.full then bank = hud.banks.alarm end
      if new(-i, s .. bank) then hud.put(bar.col, bar.row, s, bank) end
    end
  end
end

local function draw_clock(left)
  local n, bank = math.min((left + 59) // 60, 99), hud.banks.plain
  if n <= LATE and (n > LAST or left // 15 % 2 == 0) then bank = hud.banks.alarm end
  if n <= LATE and n > 0 and new("second", n) then sys.cue("time") end
  if new("clock", n * 16 + bank) then hud.put(LEFT + WIDTH - CLOCK, top, ("%2d"):format(n), bank, 2) end
end

-- How much of its way up is still before it, 1 to 0: fast first.
local function way(age)
  local k = 1 - math.min(math.max(age - STANDS, 0), SLIDES) / SLIDES
  return k * k
end

local function draw_name(age)
  if spell.there then return end
  if age <= STANDS + 1 then draw_rules(age) end
  local k = way(age)
  spell.there = k == 0
  if told and age >= STANDS then -- the name slides over where the phase before is told
    told = false
    hud.banner()
  end
  local row = spell.rest + math.floor((LOW - spell.rest) * k + 0.5)
  local letters = age < WRITTEN and age or -1
  if not new("name", row * 64 + math.floor(k * 32) + (letters << 20)) then return end
  wipe_spell()
  local lines = age <= STANDS and spell or { spell.short }
  spell.row, spell.h = row, #lines
  for i, line in ipairs(lines) do
    local room = COLS - sys.cells(line)
    local col = hud.place.panel and room - math.floor((room - room // 2) * k) or math.floor(room // 2 * k)
    if letters >= 0 then line = cut(line, sys.cells(line) * letters // WRITTEN) end
    hud.put(COL + col, row + i - 1, line, hud.banks.bright)
  end
end

-- What it is worth and how often it was captured, as much of it as the row has room for: below the name in a panel's
-- game, else beside it.
local function draw_bonus(b, age)
  if age < STANDS + SLIDES then return end
  local n = not b.missed and b.worth()
  if not new("bonus", n) then return end
  local row, room, worth = spell.rest, COLS, ""
  if phase.bonus > 0 then worth = n and ("%07d"):format(n) or text.lang("FAILED") end
  if hud.place.panel then row = row + 1 else room = math.max(0, COLS - sys.cells(spell.short) - 1) end
  local word = n and worth ~= "" and text.lang("BONUS") .. " " or ""
  local gap = worth ~= "" and past ~= "" and "  " or ""
  local long = past ~= "" and text.lang("CAPTURED") .. " " .. past or ""
  text.clear { col = COL + COLS - room, row = row, w = room, h = 1 }
  for _, s in ipairs { long .. gap .. word .. worth, past .. gap .. word .. worth, word .. worth, worth } do
    if sys.cells(s) <= room then return right(row, s, n and hud.banks.plain or hud.banks.faint, COL, COLS) end
  end
end

local function tell(verdict)
  told = true
  local lines = verdict.bonus and { verdict.spell and "CAPTURED" or "BONUS", tostring(verdict.bonus) }
  hud.banner(lines or { "BONUS FAILED" }, 100, LOW - VERDICT)
end

return function(b, row, again, verdict)
  if verdict then tell(verdict) end
  draw_mark(b)
  if not b and again then forget() end -- whatever stands there now is another's
  if not b then return wipe() end
  if row ~= top or again or new("phase", b.phase or b.left or 0) then
    lay_out(b, row)
    seen.phase = b.phase or b.left or 0
  end
  if not phase then return end
  local age = sys.clock() - b.began
  draw_bars(age)
  draw_clock(phase.time - age)
  if spell then
    draw_name(age)
    draw_bonus(b, age)
  end
end

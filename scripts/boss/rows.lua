-- boss/rows.lua - what the hud shows of a fight: bars, the clock in large digits, the title with a pip for each phase to
-- come, and a spell's name, which is declared in the middle of the field and slides up to its place, with its bonus.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each

local LEFT <const>, WIDTH <const> = hud.place.left, hud.place.width
local CLOCK <const> = 4                -- columns of two large digits
local NARROW <const> = WIDTH < 20      -- the title stands below the clock, not beside it, and several bars below that
local SHORT <const> = WIDTH - CLOCK - 1
local PIP <const> = hud.glyph(138, "*")
local FEW <const> = 6                  -- so many pips stand side by side
local FILLS <const> = 30               -- frames a bar takes to fill
local LATE <const>, LAST <const> = 10, 5 -- seconds from which on the clock is bright, and blinks

-- A spell's name, in frames of its phase: it is written, stands, and slides.
local WRITTEN <const>, STANDS <const>, SLIDES <const> = 14, 36, 30
local COL <const>, COLS <const> = hud.place.col + 1, hud.place.cols - 2
local HIGH <const>, LOW <const> = rom.field.y // 8 + 1, (rom.field.y + rom.field.h * 5 // 8) // 8

local top           -- the first row, nil: nothing is shown
local height = 0    -- rows from there on
local bars = {}     -- of the phase: e, full, name and row
local phase         -- the one that is shown
local spell         -- lines of its name; col, row, where they stand; rest, their row in the end
local seen = {}     -- what is on the screen, by what it is
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

local function wipe_spell()
  if not (spell and spell.row) then return end
  text.clear { col = COL, row = spell.row, w = COLS, h = #spell + 1 }
  seen.bonus, spell.row = nil, nil
end

local function forget() top, phase, spell, seen = nil, nil, nil, {} end

local function wipe()
  if not top then return end
  text.clear { col = LEFT, row = top, w = WIDTH, h = height }
  wipe_spell()
  forget()
end

-- A bar each for those who have one: of all together in the top row; of several each in a row, its name before it, in a
-- narrow panel above. Returns the row below them.
local function list_bars(b, row)
  local hp, label = phase and not phase.survive and phase.hp, 0
  bars = {}
  if type(hp) ~= "table" then
    if hp then bars[1] = { e = b.team[1], full = hp, row = top, col = LEFT, cols = SHORT } end
    return NARROW and row or row + 1
  end
  for i, m in ipairs(b.boss.cast) do
    local name = cut(text.lang(m.title), NARROW and WIDTH or SHORT // 3)
    if hp[m.name] then bars[#bars + 1] = { e = b.team[i], full = hp[m.name], name = name } end
    label = NARROW and 0 or math.max(label, sys.cells(name) + 1)
  end
  for i, bar in ipairs(bars) do
    hud.put(LEFT, row, bar.name)
    bar.row, bar.col, bar.cols = NARROW and row + 1 or row, LEFT + label, NARROW and WIDTH or SHORT - label
    row = bar.row + 1
  end
  return row
end

-- Writes what stays as it is in a phase, and finds the places of all else.
local function lay_out(b, row)
  wipe()
  top, phase = row, b.phase
  row = NARROW and row + 2 or list_bars(b, row)
  local pips, last = PIP:rep(math.min(b.left or 0, FEW))
  for _, line in ipairs(hud.wrap(text.lang(b.boss.title), NARROW and WIDTH or SHORT)) do
    hud.put(LEFT, row, line)
    row, last = row + 1, sys.cells(line)
  end
  local function room() return row - 1 < top + 2 and not NARROW and SHORT or WIDTH end
  if #pips > 0 and last + 1 + #pips > room() then row = row + 1 end
  hud.put(LEFT + room() - #pips, row - 1, pips)
  if NARROW then row = list_bars(b, row) end
  height = math.max(row - top, 2)
  if phase and phase.spell then
    spell = hud.wrap(text.lang(phase.spell), COLS)
    spell.rest = hud.place.panel and HIGH or top + height
  end
end

local function draw_bars(age)
  for i, bar in ipairs(bars) do
    local hp = bar.e.hp or 0
    if age < FILLS then hp = math.min(hp, bar.full * age // FILLS) end
    if new(i, hp) then
      local s = hud.bar(hp, bar.full, bar.cols)
      if new(-i, s) then hud.put(bar.col, bar.row, s) end
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
  spell.row = row
  for i, line in ipairs(spell) do
    local room = COLS - sys.cells(line)
    local col = room - math.floor((room - room // 2) * k)
    if letters >= 0 then line = cut(line, sys.cells(line) * letters // WRITTEN) end
    hud.put(COL + col, row + i - 1, line, hud.banks.bright)
  end
end

local function draw_bonus(b, age)
  if phase.bonus == 0 or age < STANDS + SLIDES then return end
  local n = not b.missed and b.worth()
  if not new("bonus", n) then return end
  text.clear { col = COL, row = spell.rest + #spell, w = COLS, h = 1 }
  right(spell.rest + #spell, n and ("%s %07d"):format(text.lang("BONUS"), n) or text.lang("FAILED"),
        n and hud.banks.plain or hud.banks.faint, COL, COLS)
end

local function tell(verdict)
  told = true
  if not verdict.bonus then return hud.banner({ "BONUS FAILED" }, 100) end
  hud.banner({ verdict.spell and "CAPTURED" or "BONUS", tostring(verdict.bonus) }, 100)
end

return function(b, row, again, verdict)
  if verdict then tell(verdict) end
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

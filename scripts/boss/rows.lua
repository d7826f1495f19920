-- boss/rows.lua - what the HUD shows of a fight: bars, a pip for each phase to come, the clock, the name, the spell
-- with its history and bonus, and a mark at the field's lower edge. A spell's name is declared in the middle of the
-- field; then it appears in the panel, or slides to the boss's row over the field, in place of the boss's name. Over the
-- field, it and the history stay for READ frames; then the boss's name returns.
local sys = ... -- functions for the standard library only; documented in src/script/api/api_sys.c

local PIP <const>, STAR <const>, RULE <const> = hud.glyph(152, "*"), hud.glyph(138, "*"), hud.glyph(141, "-")
local MOST_PIPS <const> = 6
local FILLS <const> = 30                 -- frames a bar takes to fill
local DOWN <const> = 4                   -- a bar has the alarm colour below one part in DOWN of its hit points
local MARK <const> = "boss_marker"       -- the sprite below the boss, if the game has one of this name
local MARGIN <const> = 3                 -- px from that sprite's middle to the field's lower edge
local LATE <const>, LAST <const> = 10, 5 -- seconds left from which the clock has the alarm colour, and blinks

-- A spell's name, in frames of its phase: it is typed, stays, and slides.
local TYPED <const>, STAYS <const> = 14, 36
local SLIDES <const> = hud.panel and 0 or 30
local READ <const>, FADES <const> = 120, 12 -- in its place, faint at last
local COL <const>, COLS <const> = hud.field.col + 1, hud.field.cols - 2
local DECLARED <const> = hud.declared
local VERDICT <const> = 7 -- rows from a verdict's first row to DECLARED

local at                   -- the places of the rows; nil: nothing is shown
local bars = {}            -- of the phase: e, full and place
local phase                -- the phase that is shown
local spell                -- its lines as declared, and the size of their letters; name; history; col, row, w, h: the
                           -- cells of the name on its way to its place; done: it is there
local seen = {}            -- values that are on the screen, by name
local mark                 -- the sprite below the boss
local shows_verdict        -- the banner may be the verdict on the phase before

local function changed(what, value)
  if seen[what] == value then return false end
  seen[what] = value
  return true
end

-- The first n characters of s.
local function first(s, n)
  local to = utf8.offset(s, n + 1)
  return to and s:sub(1, to - 1) or s
end

-- The lines of s for rows of the HUD. If it is too long, without the part before its colon.
local function fit(places, s)
  local lines = hud.wrap(s, places[1].cols)
  return #lines > #places and hud.wrap(s:match(":%s*(.+)") or s, places[1].cols) or lines
end

local function show_lines(places, s, bank)
  local lines = places[1] and fit(places, s)
  for i, p in ipairs(places) do hud.show(p, lines[i] or "", bank) end
end

-- Lines above and below the declared name, growing from the middle.
local function draw_rules(age)
  local n = math.min(COLS, 4 + 8 * age)
  for _, y in ipairs { DECLARED - 16, DECLARED + hud.pitch(spell.size) * #spell + 6 } do
    if age <= STAYS then hud.put(COL + (COLS - n) / 2, y / 8, RULE:rep(n), hud.banks.faint)
    else text.clear { col = COL, row = y // 8, w = COLS, h = 1 } end
  end
end

-- Removes the declared or sliding name.
local function wipe_name()
  if not (spell and spell.row) then return end
  text.clear { col = spell.col, row = spell.row, w = spell.w, h = spell.h }
  spell.row = nil
end

local function forget() at, phase, spell, seen = nil, nil, nil, {} end

local function wipe()
  if not at then return end
  if spell and not spell.done then
    wipe_name()
    draw_rules(STAYS + 1)
  end
  for _, p in ipairs { at.clock, at.pips, at.history, at.bonus } do hud.show(p, "") end
  for _, list in ipairs { at.name, at.spell } do show_lines(list, "") end
  for _, bar in ipairs(at.bars) do
    if bar.name then hud.show(bar.name, "") end
    hud.show(bar.bar, "")
  end
  forget()
end

local function draw_mark(b)
  if not rom.has(MARK) then return end
  local e
  for _, one in ipairs(b and b.team or {}) do e = e or one.alive and one end
  if not e then
    if mark and mark.alive then mark:remove() end
    mark = nil
    return
  end
  local left = sys.to_field(rom.view.x, 0)
  local right, bottom = sys.to_field(rom.view.x + rom.view.w, rom.view.y + rom.view.h)
  local x, y = math.max(left, math.min(right, e.x)), bottom - MARGIN
  if mark and mark.alive then
    mark.x = x
    if mark.y ~= y then mark.y = y end
  else mark = sprite.put { sprite = MARK, x = x, y = y, layer = "front", stay = true } end
end

-- The name's lines when it is declared. Its part before the colon has a line of its own unless all fits in one.
local function lines_of(name)
  local word, rest = name:match("^(.-:)%s*(.+)$")
  if not word or sys.cells(name) <= COLS then return hud.wrap(name, COLS) end
  local lines = hud.wrap(rest, COLS)
  table.insert(lines, 1, word)
  return lines
end

-- Finds the bars of the phase. Returns their names if the cast has a bar each, otherwise an empty list.
local function find_bars(b)
  local hp, names = phase and not phase.survive and phase.hp, {}
  bars = {}
  if type(hp) ~= "table" then
    if hp then bars[1] = { e = b.team[1], full = hp } end
    return names
  end
  for i, m in ipairs(b.boss.cast) do
    if hp[m.name] then
      bars[#bars + 1] = { e = b.team[i], full = hp[m.name] }
      names[#bars] = text.lang(m.title)
    end
  end
  return names
end

-- Finds the places of a phase and writes what stays the same in it.
local function lay_out(b)
  wipe()
  local pips = math.min(b.left or 0, MOST_PIPS)
  phase = b.phase
  local names = find_bars(b)
  local title, name = text.lang(b.boss.title), phase and phase.spell and text.lang(phase.spell)
  at = hud.boss_places(names, pips)
  hud.show(at.pips, PIP:rep(pips))
  show_lines(at.name, title)
  for i, bar in ipairs(bars) do
    local places = at.bars[i]
    if places and names[i] then hud.show(places.name, hud.wrap(names[i], places.name.cols)[1]) end
    bar.place = places and places.bar
  end
  if not name then return end
  spell = lines_of(name)
  spell.name, spell.size = name, hud.full and 1 or 2 -- large letters if they fit; not kanji of 8 px
  for _, line in ipairs(spell) do
    if sys.cells(line, 2) > COLS then spell.size = 1 end
  end
  local tries, captures = sys.history(b.boss.name, phase.id, 0)
  spell.history = tries > 0 and ("%d/%d"):format(captures, tries)
end

local function draw_bars(age)
  for i, bar in ipairs(bars) do
    local hp = bar.e.hp or 0
    if age < FILLS then hp = math.min(hp, bar.full * age // FILLS) end
    if bar.place and changed(i, hp) then
      local low = age >= FILLS and hp * DOWN < bar.full
      hud.show(bar.place, hud.bar(hp, bar.full, bar.place.cols), low and hud.banks.alarm or hud.banks.bright)
    end
  end
end

local function draw_clock(left)
  local n, bank = math.min((left + 59) // 60, 99), hud.banks.plain
  if n <= LATE and (n > LAST or left // 15 % 2 == 0) then bank = hud.banks.alarm end
  if n <= LATE and n > 0 and changed("second", n) then sys.cue("time") end
  if changed("clock", n * 16 + bank) then hud.show(at.clock, ("%2d"):format(n), bank) end
end

-- The name while it is declared, and on its way: first in the middle of the field, then in its place.
local function draw_name(age)
  if spell.done then return end
  if age <= STAYS + 1 then draw_rules(age) end
  local k = 1 - math.min(math.max(age - STAYS, 0), SLIDES) / math.max(SLIDES, 1)
  local left = k * k -- part of its way
  if not hud.panel and age >= STAYS then show_lines(at.name, "") end
  if shows_verdict and age >= STAYS then -- the name slides over the verdict
    shows_verdict = false
    hud.banner()
  end
  if age >= STAYS + SLIDES and age > STAYS then
    wipe_name()
    spell.done = true
    return
  end
  local lines = age <= STAYS and spell or { fit(at.spell, spell.name)[1] }
  local y = at.spell[1].y + math.floor((DECLARED - at.spell[1].y) * left + 0.5)
  if not changed("name", y * 64 + math.min(age, TYPED)) then return end
  wipe_name()
  local declared = age <= STAYS
  local size = declared and spell.size or 1
  local pitch = hud.pitch(size)
  spell.row, spell.h = y // 8, (y + pitch * (#lines - 1)) // 8 - y // 8 + size
  spell.col, spell.w = COL, COLS
  for i, line in ipairs(lines) do
    local middle, last = COL + (COLS - sys.cells(line, size)) / 2, at.spell[1].col
    local col = (last * 8 + math.floor((middle - last) * 8 * left)) / 8
    if age > STAYS then spell.col, spell.w = math.floor(col), math.ceil(sys.cells(line)) + 1 end -- other rows are next to it
    if age < TYPED then line = first(line, utf8.len(line) * age // TYPED) end
    hud.put(col, y / 8 + (i - 1) * pitch / 8, line, hud.banks.bright, size)
  end
end

-- The name in its place, and how often the spell was captured.
local function draw_history(b, age)
  local left = hud.panel and READ or STAYS + SLIDES + READ - age
  local bank = left > FADES and "bright" or left > 0 and "faint" or nil
  if not changed("history", bank or "gone") then return end
  show_lines(at.spell, bank and spell.name or "", hud.banks[bank])
  if not bank then show_lines(at.name, text.lang(b.boss.title)) end -- the boss's name returns
  if not spell.history then return end
  local words = bank and hud.labelled(at.history, text.lang("CAPTURED"), spell.history, STAR) or ""
  hud.show(at.history, words, hud.banks[bank == "bright" and "plain" or bank])
end

-- What the spell is worth; over the field only at first, and when the bonus is lost.
local function draw_bonus(b, age)
  if changed("missed", b.missed) then seen.bonus_ends = age + READ end
  local n = not b.missed and b.worth()
  local worth = n and tostring(n) or text.lang("FAILED")
  local words = hud.labelled(at.bonus, text.lang("BONUS"), worth)
  if phase.bonus == 0 or not hud.panel and age >= seen.bonus_ends then words = "" end
  if changed("bonus", words) then hud.show(at.bonus, words, n and hud.banks.plain or hud.banks.faint) end
end

local function show_verdict(verdict)
  shows_verdict = true
  local lines = verdict.bonus and { verdict.spell and "CAPTURED" or "BONUS", tostring(verdict.bonus) }
  hud.banner(lines or { "BONUS FAILED" }, 100, DECLARED // 8 - VERDICT)
end

return function(b, again, verdict, has_dialogue)
  if verdict then show_verdict(verdict) end
  draw_mark(not has_dialogue and b)
  if not b and again then forget() end -- the screen was emptied
  if not b then return wipe() end
  if again or changed("phase", b.phase or b.left or 0) then
    lay_out(b)
    seen.phase = b.phase or b.left or 0
  end
  if not phase then return show_lines(at.name, has_dialogue and "" or text.lang(b.boss.title)) end -- the box names it
  local age = sys.clock() - b.began
  draw_bars(age)
  draw_clock(phase.time - age)
  if spell then draw_name(age) end
  if not (spell and spell.done) then return end
  draw_history(b, age)
  draw_bonus(b, age)
end

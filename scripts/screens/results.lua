-- screens/results.lua - the results of a stage, over its last picture: values count up one after the other, and then
-- each player's grade appears below them, if the game gives grades.
local sys = ... -- functions for the standard library only; documented in src/script/api/api_sys.c
local page = sys.read("menu/page")

local SHORTEST, LONGEST = 30, 150 -- frames; fire is ignored at first, because players still press it when a boss dies;
                                  -- the page ends this long after its last value
local RUN, NEXT = 36, 10          -- frames that a value counts up, and from the start of one to that of the next
local STAMP = 8                   -- frames that a grade flashes
local KEYS <const> = { "fire", "Next" }
local GRADE, SIZE = 5, 3          -- rows of the grades, size of their letters

-- Columns between the page's edge and the words.
local function inset(players) return players == 1 and 3 or 2 end

-- The rows if the game gives none: { word, player 1's value, player 2's value } each. A value may be a function that
-- returns it.
local function usual(players)
  local rows = { { "Score" }, { "Graze" }, { "Lives" } }
  for p = 1, players do
    local ship = player.get(p)
    rows[1][p + 1], rows[2][p + 1], rows[3][p + 1] = hud.score(p), ship.grazes or 0, ship.lives or 0
  end
  return rows
end

local function value(n, age)
  if type(n) == "function" then n = n() end
  if math.type(n) ~= "integer" then return tostring(n or "") end
  return page.number(n * math.max(0, math.min(age, RUN)) // RUN)
end

-- The first words of `word` that fit next to the values.
local function beside(word, r, players, cols)
  local widest = 0
  for p = 1, players do widest = math.max(widest, sys.cells(value(r[p + 1], RUN))) end
  return hud.wrap(word, math.max(1, cols - players * (widest + 1)))[1]
end

-- One player: words at the left, values at the right. Two: words in the middle, values at both sides.
local function draw_row(at, i, r, players, age)
  age = age - NEXT * (i - 1)
  local bank = age < RUN and hud.banks.plain or hud.banks.bright
  local edge = inset(players)
  local col, cols = page.col + edge, page.cols - 2 * edge
  local word = beside(text.lang(r[1]), r, players, cols)
  page.clear(at, 1)
  hud.put(players == 1 and col or col + (cols - sys.cells(word)) // 2, at, word, hud.banks.plain)
  local last = value(r[players + 1], age)
  hud.put(col + cols - sys.cells(last), at, last, bank)
  if players > 1 then hud.put(col, at, value(r[2], age), bank) end
end

local function draw_players(row)
  local words = { text.lang("Player %d"):format(1), text.lang("Player %d"):format(2) }
  hud.put(page.col + inset(2), row, words[1], hud.banks.bright)
  hud.put(page.col + page.cols - inset(2) - sys.cells(words[2]), row, words[2], hud.banks.bright)
end

-- What was unlocked, each in a row below the others.
local function draw_new(row, gap, n, new, age)
  for i, title in ipairs(new) do
    local bank, words = page.bank(1, age - NEXT * (n + i) - RUN, hud.banks.bright), text.lang("Unlocked: %s"):format(title)
    if sys.cells(words) > page.cols - 6 then words = title end
    if bank then page.centre(row + (n + i - 1) * gap, words, bank) end
  end
end

-- The frame in which the grades appear: after the last value.
local function stamped(rows) return NEXT * (#rows - 1) + RUN + 10 end

-- The grades: one at the right, or each player's at their side.
local function draw_grades(row, grades, age)
  if age < 0 then return end
  if age == 0 then
    sys.cue("bonus")
    screen.flash { share = 0.3, over = 2 * STAMP }
  end
  local bank = age < STAMP and hud.banks.plain or hud.banks.bright
  page.rule(row, age, page.col + 2, page.cols - 4)
  local word = text.lang("Grade")
  for p, s in ipairs(grades) do
    local n = sys.cells(s)
    local edge = inset(#grades)
    local col = page.col + page.cols - edge - SIZE * n
    if p == 1 and #grades > 1 then col = page.col + edge end
    hud.put(col, row + 2, s, bank, SIZE)
  end
  if #grades > 1 then return page.centre(row + 3, word, hud.banks.faint) end
  hud.put(page.col + 3, row + 3, word, hud.banks.faint)
end

local function draw_page(title, rows, players, new, top, gap, age)
  local row = page.centre(top + 1, title, hud.banks.bright)
  page.rule(row, age, page.col + 2, page.cols - 4)
  row = row + 2
  if players > 1 then
    draw_players(row)
    row = row + 2
  end
  for i, r in ipairs(rows) do draw_row(row + (i - 1) * gap, i, r, players, age) end
  draw_new(row, gap, #rows, new, age)
  return row + (#rows + #new) * gap
end

-- Clears the rows that the growing window has not reached.
local function trim(window)
  local plate = window.plate
  if not plate.alive then return end -- there was no room for it
  local first, last = (plate.y + 15) // 8, (plate.y + plate.h - 8) // 8
  page.clear(window.row, first - window.row, window.col, window.w)
  page.clear(last, window.row + window.h // 8 - last, window.col, window.w)
end

-- title: a text; players: how many; stopped(): whether to end at once; rows: see `usual`; new: titles of what was
-- unlocked; grades: a text for each player, or nil.
return function(title, players, stopped, rows, new, grades)
  rows, new = rows or usual(players), new or {}
  local words = hud.wrap(title, page.cols - 6)
  local n = #rows + #new
  local gap = 2 * n + 12 <= page.rows and 2 or 1
  local h = n * gap + #words + (players > 1 and 6 or 4) + (grades and GRADE or 0)
  local top = page.row + math.max(3, (page.rows - h) // 3)
  local window = page.window(page.col + 1, top, page.cols - 2, h)
  sys.hide_rows(true)
  screen.dim { share = 0.45, over = 12 }
  local at = stamped(rows)
  for age = 0, at + LONGEST do
    page.grow(window, age)
    hud.banner() -- a boss's verdict can appear after the stage has ended
    local row = draw_page(title, rows, players, new, top, gap, age) -- every frame: a pause erases it
    if grades then draw_grades(row, grades, age - at) end
    if age < page.GROWING then trim(window) end
    page.tell(KEYS)
    wait(1)
    if stopped() or age > SHORTEST and page.pressed("fire") then break end
  end
  page.close(window)
  sys.hide_rows(true, true)
  screen.dim { share = 0, over = 12 }
end

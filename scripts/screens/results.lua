-- screens/results.lua - what a stage brought, over its last picture; values run up to what they are.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local page = sys.read("menu/page")

local SHORTEST, LONGEST = 60, 300 -- frames; in the first, fire is not asked: players still press it when a boss bursts
local RUN = 40                    -- frames that a value runs

-- What stands there when nobody gives rows: { word, value of the first, value of the second } each.
local function usual(players)
  local rows = { { "SCORE" }, { "GRAZE" }, { "LIVES" } }
  for p = 1, players do
    local ship = player.get(p)
    rows[1][p + 1], rows[2][p + 1], rows[3][p + 1] = hud.score(p), ship.grazes or 0, ship.lives or 0
  end
  return rows
end

local function value(n, age)
  if math.type(n) ~= "integer" then return tostring(n or "") end
  return tostring(n * math.min(age, RUN) // RUN)
end

-- What of a word fits beside the values, whole words of it.
local function beside(word, r, players, cols)
  local widest = 0
  for p = 1, players do widest = math.max(widest, sys.cells(value(r[p + 1], RUN))) end
  return hud.wrap(word, math.max(1, cols - players * (widest + 1)))[1]
end

-- One player: words at the left, values at the right. Two: words in the middle, values at both sides.
local function draw_row(at, i, r, players, age)
  local bank = page.bank(i, age, hud.banks.plain)
  if not bank then return end
  local col, cols = page.col + 3, page.cols - 6
  local word = beside(text.lang(r[1]), r, players, cols)
  local last = value(r[players + 1], age - 2 * i)
  page.clear(at, 1)
  hud.put(col + cols - sys.cells(last), at, last, bank)
  if players == 1 then return hud.put(col, at, word, hud.banks.faint) end
  hud.put(col, at, value(r[2], age - 2 * i), bank)
  hud.put(col + (cols - sys.cells(word)) // 2, at, word, hud.banks.faint)
end

local function draw_players(row)
  local words = { text.lang("PLAYER %d"):format(1), text.lang("PLAYER %d"):format(2) }
  hud.put(page.col + 3, row, words[1], hud.banks.bright)
  hud.put(page.col + page.cols - 3 - sys.cells(words[2]), row, words[2], hud.banks.bright)
end

-- What was unlocked, each in a row of its own below the others.
local function draw_new(row, gap, n, new, age)
  for i, title in ipairs(new) do
    local bank, words = page.bank(n + i + 4, age, hud.banks.bright), text.lang("UNLOCKED: %s"):format(title)
    if sys.cells(words) > page.cols - 6 then words = title end
    if bank then page.centre(row + (n + i - 1) * gap, words, bank) end
  end
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
end

-- title: a text; players: how many; stopped(): must it end at once? rows: see `usual`; nil: these. new:
-- titles of what was unlocked.
return function(title, players, stopped, rows, new)
  rows, new = rows or usual(players), new or {}
  local words = hud.wrap(title, page.cols - 6)
  local n = #rows + #new
  local gap = 2 * n + 12 <= page.rows and 2 or 1
  local h = n * gap + #words + (players > 1 and 6 or 4)
  local top = page.row + math.max(3, (page.rows - h) // 3)
  local window = page.window(page.col + 1, top, page.cols - 2, h)
  screen.dim { share = 0.3, over = 12 }
  for age = 0, LONGEST do
    page.grow(window, age)
    draw_page(title, rows, players, new, top, gap, age) -- each frame, for a pause takes away what it stands on
    wait(1)
    if stopped() or age > SHORTEST and page.pressed("fire") then break end
  end
  page.close(window)
  screen.dim { share = 0, over = 12 }
end

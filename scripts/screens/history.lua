-- screens/history.lua - the spells of all bosses: how often each was tried and captured. A chapter for each difficulty,
-- a page or more for each boss; a spell has its name once it was tried.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page, book = sys.read("menu/page"), sys.read("menu/book")

local STAR = hud.glyph(138, "*")

-- The spells of a boss as { lines, tries, captures }.
local function spells(b, difficulty, cols)
  local list = {}
  for _, phase in ipairs(b.phases) do
    if phase.spell then
      local tries, captures = sys.history(b.name, phase.id, 0, difficulty)
      local lines = tries > 0 and hud.wrap(text.lang(phase.spell), cols) or { "? ? ?" }
      list[#list + 1] = { lines = lines, tries = tries, captures = captures }
    end
  end
  return list
end

local STEP <const> = 2 -- rows from one line to the next

local function numbers(s) return ("%d/%d"):format(s.captures, s.tries) end

-- Its name, and behind it, or below, how often it was captured of all tries.
local function height(s, cols)
  local last = sys.cells(s.lines[#s.lines]) + 1 + #numbers(s) > cols
  return #s.lines + (last and 1 or 0)
end

local function bank_of(s) return s.captures > 0 and "bright" or s.tries > 0 and "plain" or "faint" end

local function draw(list, first, last, row, age, cols)
  local col = page.col + (page.cols - cols) // 2 + 1
  for i = first, last do
    local s = list[i]
    local bank, h = page.bank(i - first + 1, age, hud.banks[bank_of(s)]), height(s, cols)
    if bank then
      for k, line in ipairs(s.lines) do hud.put(col, row + (k - 1) * STEP, line, bank) end
      if s.captures > 0 then hud.put(col - 2, row, STAR, bank) end
      hud.put(col + cols - #numbers(s), row + (h - 1) * STEP, numbers(s), hud.banks.faint)
    end
    row = row + h * STEP + 1
  end
end

local function pages_of(b, difficulty)
  local cols = math.min(page.cols - 6, 36)
  local list = spells(b, difficulty, cols)
  local _, room = book.room(#sys.difficulties())
  local pages = book.split(#list, room, function(i) return height(list[i], cols) * STEP + 1 end)
  for i, p in ipairs(pages) do
    local first, last = p[1], p[2]
    pages[i] = {
      title = text.lang(b.title), count = last - first + 1,
      draw = function(row, _, age) draw(list, first, last, row, age, cols) end,
    }
  end
  return pages
end

-- difficulty: where it begins; over: frames until it ends by itself, or nil. Returns whether somebody pressed.
return function(difficulty, over)
  local names, labels, here = sys.difficulties(), {}, 1
  for i, name in ipairs(names) do
    labels[i] = menu.label(name)
    if name == difficulty then here = i end
  end
  return book.show {
    head = "SPELLS", chapters = labels, chapter = here, limit = over,
    pages = function(c)
      local list = {}
      boss.each(function(b)
        for _, p in ipairs(pages_of(b, names[c])) do list[#list + 1] = p end
      end)
      return list
    end,
  }
end

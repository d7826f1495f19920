-- screens/history.lua - the spells of all bosses: how often each was tried and captured. A chapter for each difficulty,
-- a page or more for each boss; a spell has its name once it was tried.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
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

local gap <const> = page.low and 0 or 1

-- Name, and in the row below at the right the numbers; in a low page behind it, where there is room.
local function height(s) return #s.lines + (page.low and 0 or 1) + gap end

local function draw(list, first, last, row, age, cols)
  local col = page.col + (page.cols - cols) // 2
  for i = first, last do
    local s = list[i]
    local bank = page.bank(i - first + 1, age, s.captures > 0 and hud.banks.bright or s.tries > 0 and hud.banks.plain or hud.banks.faint)
    if bank then
      local numbers = ("%d/%d"):format(s.captures, s.tries)
      for k, line in ipairs(s.lines) do hud.put(col, row + k - 1, line, bank) end
      if s.captures > 0 then hud.put(col - 2, row, STAR, bank) end
      local at = row + #s.lines - (page.low and 1 or 0)
      hud.put(col + cols - #numbers, at, numbers, page.bank(i - first + 1, age, hud.banks.plain))
    end
    row = row + height(s)
  end
end

local function pages_of(b, difficulty)
  local cols = math.min(page.cols - 6, 36)
  local list = spells(b, difficulty, page.low and cols - 8 or cols)
  local _, room = book.room(2)
  local pages = book.split(#list, room, function(i) return height(list[i]) end)
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

-- screens/history.lua - the spells of all bosses: how often each was captured and tried. There is a chapter for each
-- difficulty, and a page or more for each boss. The name of a spell is shown once it has been tried.
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

local HEAD <const> = page.low and 1.5 or 2 -- rows of the column's heading

local function numbers(s) return ("%d/%d"):format(s.captures, s.tries) end

-- The lines of a spell: its name, then captures and tries, on a line of their own if the name's last line has no space.
local function height(s, cols)
  local last = sys.cells(s.lines[#s.lines]) + 1 + #numbers(s) > cols
  return #s.lines + (last and 1 or 0)
end

local function bank_of(s) return s.captures > 0 and "bright" or s.tries > 0 and "plain" or "faint" end

local function draw(list, first, last, row, age, cols)
  local col = page.col + (page.cols - cols) // 2 + 1
  local heading = text.lang("Captured/Tried")
  hud.put(col + cols - sys.cells(heading), row, heading, hud.banks.faint)
  row = row + HEAD
  for i = first, last do
    local s = list[i]
    local bank, h = page.bank(i - first + 1, age, hud.banks[bank_of(s)]), height(s, cols)
    if bank then
      for k, line in ipairs(s.lines) do hud.put(col, row + (k - 1) * page.pitch, line, bank) end
      if s.captures > 0 then hud.put(col - 2, row, STAR, bank) end
      hud.put(col + cols - #numbers(s), row + (h - 1) * page.pitch, numbers(s), hud.banks.faint)
    end
    row = row + h * page.pitch + 1
  end
end

local function pages_of(b, difficulty)
  local cols = math.min(page.cols - 6, 36)
  local list = spells(b, difficulty, cols)
  local _, room = book.room(#sys.difficulties())
  room = room - HEAD
  local pages = book.split(#list, room, function(i) return height(list[i], cols) * page.pitch + 1 end)
  for i, p in ipairs(pages) do
    local first, last = p[1], p[2]
    pages[i] = {
      title = text.lang(b.title), count = last - first + 1,
      draw = function(row, _, age) draw(list, first, last, row, age, cols) end,
    }
  end
  return pages
end

-- difficulty: the first chapter shown; over: frames until the screen closes by itself, or nil. Returns whether a player
-- closed it.
return function(difficulty, over)
  local names, labels, here = sys.difficulties(), {}, 1
  for i, name in ipairs(names) do
    labels[i] = menu.label(name)
    if name == difficulty then here = i end
  end
  return book.show {
    head = "Spells", chapters = labels, chapter = here, limit = over,
    pages = function(c)
      local list = {}
      boss.each(function(b)
        for _, p in ipairs(pages_of(b, names[c])) do list[#list + 1] = p end
      end)
      return list
    end,
  }
end

-- menu/book.lua - a screen of several pages: left and right turn them, up and down change the chapter. After the last
-- page of a chapter is the first of the next. The score tables, the spell history and the list of unlocks use it.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local LEFT <const>, RIGHT <const> = hud.glyph(139, "<"), hud.glyph(140, ">")
local UP <const>, DOWN <const> = hud.glyph(150, "^"), hud.glyph(151, "v")

local NEXT <const> = { "fire", "Next", "bomb", "Back" } -- after a run

local book = {}

-- Returns the first row of a page's content and the number of its rows. chapters: how many there are.
function book.room(chapters)
  local row = page.first + (page.low and 2 or chapters > 1 and 5 or 3)
  return row, page.bottom - row
end

-- Distributes n entries of height(i) rows each over pages; returns the first and the last of each.
function book.split(n, rows, height)
  local pages, used = {}, rows + 1
  for i = 1, n do
    local h = height(i)
    if used + h > rows then
      pages[#pages + 1], used = { i, i }, 0
    end
    pages[#pages][2], used = i, used + h
  end
  return pages
end

local function between_arrows(name) return LEFT .. " " .. name .. " " .. RIGHT end

-- Draws the titles above a page, between arrows that show which keys change them. On a low page the chapter is in the
-- heading's row.
local function titles(a, c, name, n, age)
  local chapter = #a.chapters > 1 and (n > 1 and UP .. " " .. a.chapters[c] .. " " .. DOWN or between_arrows(a.chapters[c]))
  local head = text.lang(a.head)
  local row
  if page.low and chapter then
    local both = head .. "  " .. chapter
    row = page.head(sys.cells(both) <= page.cols - 2 and both or chapter, age)
  else
    row = page.head(a.head, age)
    if chapter then
      page.centre(row, chapter, hud.banks.bright)
      row = row + 2
    end
  end
  page.centre(row, n > 1 and between_arrows(name) or name, hud.banks.plain)
end

local function turn(at, n, step) return (at - 1 + step) % n + 1 end

-- head: the heading of all pages; chapters: their names, which can be ""; pages(c): the pages of chapter c, a list of
-- { title, count, draw(row, rows, age), every? }: count rows appear one after the other, and are drawn again each `every`
-- frames. Starts at `chapter` and `at`. Returns true if a player closed it, false if nobody pressed for `limit` frames.
function book.show(a)
  local c, i, age, idle, answered = a.chapter or 1, a.at or 1, 0, 0, false
  local list, row, rows = a.pages(c), book.room(#a.chapters)
  local keys = a.limit and NEXT or page.BACK
  page.begin()
  page.frame()
  while idle < (a.limit or page.IDLE) and not answered do
    local p = list[i]
    if page.opening(age, p.count) or p.every and age % p.every == 0 then
      titles(a, c, p.title, #list, idle)
      p.draw(row, rows, age)
      page.foot(keys)
    end
    page.tell(keys)
    wait(1)
    age, idle = age + 1, idle + 1
    local up, right = #a.chapters > 1 and page.step("up", "down") or 0, page.step("left", "right")
    local other = up ~= 0 and up or #a.chapters > 1 and not list[i + right] and right or 0 -- the step to a chapter
    if other ~= 0 then
      c = turn(c, #a.chapters, other)
      list = a.pages(c)
      i = up == 0 and right < 0 and #list or 1
    else
      i = turn(i, #list, right)
    end
    if other ~= 0 or right ~= 0 and #list > 1 then
      age, idle = 0, page.cols -- the rule has its full length
      page.clear(page.row, page.rows)
    end
    answered = page.accepted() or page.pressed("bomb")
  end
  page.done()
  return answered
end

return book

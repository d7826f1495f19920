-- menu/book.lua - pages that are turned: left and right lead to the next, up and down to another chapter. The score
-- tables, the history and the list of unlocks are such.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local page = sys.read("menu/page")

local LEFT, RIGHT, UP, DOWN = hud.glyph(139, "<"), hud.glyph(140, ">"), hud.glyph(150, "^"), hud.glyph(151, "v")

local book = {}

local lines = page.low and 1 or 2 -- from a title to the next

-- The first row of what stands on a page, below its titles, and how many there are down to the foot.
function book.room(titles)
  local row = page.row + (page.low and 4 or 8) + titles * lines
  return row, page.row + page.rows - (page.low and 3 or 6) - row
end

-- Distributes entries of `height` rows each (height(i) of entry i) over pages; returns the first and the last of each.
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

-- A name, with arrows if there are more of them.
local function title(row, name, n, before, behind, bank)
  page.clear(row, 1)
  page.centre(row, n > 1 and before .. " " .. name .. " " .. behind or name, bank)
end

local function turn(at, n, step) return (at - 1 + step) % n + 1 end

-- head: above all pages; chapters: names of these, one may be ""; pages(c): those of chapter c, a list of { title, count,
-- draw(row, rows, age), every? }: count rows come one after the other, all are drawn again each `every` frames. Begins at `chapter` and `at`, ends when somebody presses (true)
-- or nobody did for `limit` frames.
function book.show(a)
  local c, i, age, idle, answered = a.chapter or 1, a.at or 1, 0, 0, false
  local titles = (#a.chapters > 1 and 1 or 0)
  local list = a.pages(c)
  page.begin()
  while idle < (a.limit or page.IDLE) and not answered do
    local p = list[i]
    local row = page.head(a.head, math.max(age, idle)) -- it stands when pages are turned
    if #a.chapters > 1 then title(row, a.chapters[c], #a.chapters, UP, DOWN, hud.banks.bright) end
    if p.title ~= "" then title(row + titles * lines, p.title, #list, LEFT, RIGHT, hud.banks.plain) end
    if page.opening(age, p.count) or p.every and age % p.every == 0 then
      local first, room = book.room(titles + 1)
      p.draw(first, room, age)
    end
    page.foot("FIRE: BACK", idle)
    wait(1)
    age, idle = age + 1, idle + 1
    local up, right = page.step("up", "down"), page.step("left", "right")
    if #a.chapters > 1 and up ~= 0 then
      c, i, age, idle = turn(c, #a.chapters, up), 1, 0, page.cols
      list = a.pages(c)
    elseif #list > 1 and right ~= 0 then
      i, age, idle = turn(i, #list, right), 0, page.cols
    end
    if age == 0 then page.clear(row, page.row + page.rows - row) end
    answered = page.accepted() or page.pressed("bomb")
  end
  page.done()
  return answered
end

return book

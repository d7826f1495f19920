-- screens/pause.lua - the game's own pause, which stands in the demo too: a window over a darker picture.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local ROOM = 8 -- columns beside the widest item

-- p: who pressed START; items: texts, the first of which goes on; last: the number of the one that was chosen before.
-- Returns the number of one.
return function(p, items, last)
  local words, widest = {}, sys.cells(text.lang("PAUSE"))
  for i, item in ipairs(items) do
    words[i] = text.lang(item)
    widest = math.max(widest, sys.cells(words[i]))
  end
  local w, h = math.min(page.cols - 2, widest + ROOM), 2 * #items + 5
  local col, row = page.col + (page.cols - w) // 2, page.row + (page.rows - h) // 2
  local window = page.over(col, row, w, h)
  local function draw(age)
    page.grow(window, age)
    page.centre(row + 1, "PAUSE", hud.banks.bright, col, w)
    page.rule(row + 2, age, col + 1, w - 2)
  end
  local i = page.list {
    items = words, row = row + 4, col = col, cols = w, p = p, chosen = last, back = 1, limit = forever, draw = draw,
  }
  page.close(window)
  return i
end

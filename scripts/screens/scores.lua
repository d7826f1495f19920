-- screens/scores.lua - the score tables: a chapter for each difficulty, a page for the best of all and one for each ship.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page, book = sys.read("menu/page"), sys.read("menu/book")

local RANKS <const> = 10 -- rows of a table
local ARROW = hud.glyph(140, ">")

-- How far a score went, in `cells` at most: the words that there is room for. many: the table is of several ships.
local function how_far(r, many, cells)
  local words = {}
  if many and r.ship then words[1] = menu.label(r.ship) end
  if r.clear then
    words[#words + 1] = text.lang("ALL CLEAR")
  elseif r.stage then
    words[#words + 1] = text.lang("STAGE %d"):format(r.stage)
  end
  if r.continues > 0 then words[#words + 1] = text.lang("CONTINUES %d"):format(r.continues) end
  local s = table.concat(words, " ")
  while #words > 0 and sys.cells(s) > cells do
    words[#words] = nil
    s = table.concat(words, " ")
  end
  return s
end

local WIDTH <const> = math.min(page.cols - (page.low and 3 or 6), 30) -- of a row
local COL <const> = page.col + (page.cols - WIDTH) // 2
local TURN <const> = 120 -- frames that a row shows a name, and then how far it went

-- Row i of a table.
local function draw_row(i, r, row, bank, marked, far)
  local points = r and tostring(r.score) or "0"
  local words = r and (far and how_far(r, far == "ship", WIDTH - 4 - #points) or r.name) or "--------"
  page.clear(row, 1)
  if marked then hud.put(COL - 1, row, ARROW, hud.banks.bright) end
  hud.put(COL, row, ("%2d"):format(i), hud.banks.faint)
  hud.put(COL + 3, row, words, r and far and hud.banks.faint or bank)
  hud.put(COL + WIDTH - #points, row, points, bank)
end

-- many: it is of several ships.
local function table_page(name, rows, mark, many)
  return {
    title = name, count = RANKS, every = TURN,
    draw = function(row, room, age)
      local gap = math.max(1, math.min(3, room // RANKS))
      local far = age // TURN % 2 == 1 and (many and "ship" or "stage")
      for i = 1, RANKS do
        local r = rows[i]
        local bank = page.bank(i, age, hud.banks[i == mark and "bright" or r and "plain" or "faint"])
        if bank then draw_row(i, r, row + (i - 1) * gap, bank, i == mark, far) end
      end
    end,
  }
end

-- The tables of a difficulty; where the ship's own is among them.
local function tables(difficulty, ship, mark)
  local all, list, at = score.rows(difficulty), {}, 1
  for _, kind in ipairs(sys.kinds("player")) do
    local rows = score.rows(difficulty, kind)
    if rows[1] then
      list[#list + 1] = table_page(menu.label(kind), rows, kind == ship and mark)
      if kind == ship then at = #list + 1 end
    end
  end
  if #list < 2 then return { table_page("", all, mark) }, 1 end
  table.insert(list, 1, table_page(text.lang("ALL SHIPS"), all, not ship and mark, true))
  return list, at
end

-- difficulty: where it begins; over: frames until it ends by itself; mark: a row to show bright, of the table of `ship`
-- if there is one. Returns whether somebody pressed.
return function(difficulty, over, mark, ship)
  local names, labels, here = sys.difficulties(), {}, 1
  for i, name in ipairs(names) do
    labels[i] = menu.label(name)
    if name == difficulty then here = i end
  end
  local _, at = tables(difficulty, ship, mark)
  return book.show {
    head = "BEST SCORES", chapters = labels, chapter = here, at = at, limit = over,
    pages = function(c)
      local own = names[c] == difficulty
      return (tables(names[c], own and ship, own and mark))
    end,
  }
end

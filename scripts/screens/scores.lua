-- screens/scores.lua - the score tables: a chapter for each difficulty, a page for the best of all and one for each ship.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local page, book = sys.read("menu/page"), sys.read("menu/book")

local RANKS <const> = 10 -- rows of a table
local ARROW = hud.glyph(140, ">")

-- How far a score went, in `cells` at most: the words that there is room for.
local function how_far(r, ship, cells)
  local words = {}
  if ship and r.ship then words[1] = menu.label(r.ship) end
  if r.clear then
    words[#words + 1] = text.lang("ALL CLEAR")
  elseif r.stage then
    words[#words + 1] = text.lang("STAGE %d"):format(r.stage)
  end
  if r.continues > 0 then words[#words + 1] = text.lang("CONTINUES %d"):format(r.continues) end
  local s = table.concat(words, "  ")
  while sys.cells(s) > cells do
    words[#words] = nil
    s = table.concat(words, " ")
  end
  return s
end

local function short(r) return r.clear and text.lang("ALL") or r.stage and "ST" .. r.stage or "" end

local WIDTH <const> = math.min(page.cols - 3, 30) -- of a row
local FAR <const> = 4 -- of that what stands behind a score in a low page

-- Row i of a table at `row`: place, name, score, and how far it went: below, or in a low page behind it.
local function draw_row(i, r, row, bank, marked, many)
  local col = page.col + (page.cols - WIDTH) // 2
  local name, points = r and r.name or "--------", r and tostring(r.score) or "0"
  local behind = page.low and WIDTH >= 23 + FAR and FAR or 0
  page.clear(row, page.low and 1 or 2)
  hud.put(col - 1, row, marked and ARROW or " ", hud.banks.bright)
  hud.put(col, row, ("%2d"):format(i), hud.banks.faint)
  hud.put(col + 3, row, name, bank)
  hud.put(col + WIDTH - behind - #points, row, points, bank)
  if not r then return end
  if not page.low then
    hud.put(col + 3, row + 1, how_far(r, many, WIDTH - 3), hud.banks.faint)
  elseif behind > 0 then
    hud.put(col + WIDTH - sys.cells(short(r)), row, short(r), hud.banks.faint)
  end
end

local function table_page(name, rows, mark, many)
  return {
    title = name, count = RANKS,
    draw = function(row, room, age)
      local gap = math.max(1, math.min(3, room // RANKS))
      for i = 1, RANKS do
        local r, bank = rows[i], nil
        bank = page.bank(i, age, hud.banks[i == mark and "bright" or r and "plain" or "faint"])
        if bank then draw_row(i, r, row + (i - 1) * gap, bank, i == mark, many) end
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

-- screens/scores.lua - the score tables: a chapter for each difficulty, with a page for each mode and all ships and one
-- for each ship.
-- A row has two lines: rank, name and score, then ship and how far the run got. If there is room for one line only, names
-- alternate with the rest.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page, book = sys.read("menu/page"), sys.read("menu/book")

local RANKS <const> = 10 -- rows of a table
local ARROW = hud.glyph(140, ">")

-- Returns how far the run of a score got, in at most `cells` cells.
local function how_far(r, cells)
  local words = {}
  if r.clear then
    words[1] = text.lang("All Clear")
  elseif r.stage then
    words[1] = text.lang("Stage %d"):format(r.stage)
  end
  if r.continues > 0 then words[#words + 1] = text.lang("Continues %d"):format(r.continues) end
  local s = table.concat(words, " ")
  while #words > 0 and sys.cells(s) > cells do
    words[#words] = nil
    s = table.concat(words, " ")
  end
  return s
end

local WIDTH <const> = math.min(page.cols - (page.low and 3 or 6), 30) -- of a row
local COL <const> = page.col + (page.cols - WIDTH) // 2
local TURN <const> = 120 -- frames that one-line rows show names, then ships if the table has several, then how far the
                         -- runs got
local TALL <const> = 2.5 -- rows of cells that a row of two lines takes
local BELOW <const> = 1.125 -- and from its first line to its second

-- Draws row i of a table. what: "name", "ship", "far" or "all".
local function draw_row(i, r, row, bank, marked, what)
  local points = r and page.number(r.score) or ""
  local words = r and r.name or "--------"
  local ship = r and r.ship and menu.label(r.ship) or ""
  if r and what == "ship" then words = ship end
  if r and what == "far" then words = how_far(r, WIDTH - 4 - #points) end
  page.clear(row, 1)
  if marked then hud.put(COL - 1, row, ARROW, hud.banks.bright) end
  hud.put(COL, row, ("%2d"):format(i), hud.banks.faint)
  hud.put(COL + 3, row, words, r and (what == "ship" or what == "far") and hud.banks.faint or bank)
  hud.put(COL + WIDTH - #points, row, points, bank)
  if not r or what ~= "all" then return end
  local far = how_far(r, WIDTH - 4 - sys.cells(ship))
  hud.put(COL + 4, row + BELOW, ship, hud.banks.faint)
  hud.put(COL + WIDTH - sys.cells(far), row + BELOW, far, hud.banks.faint)
end

-- many: the table has several ships.
local function table_page(name, rows, mark, many)
  return {
    title = name, count = RANKS, every = TURN,
    draw = function(row, room, age)
      if not rows[1] then return page.centre(row + room // 3, "No scores yet.", hud.banks.plain) end
      local gap = math.max(1, math.min(TALL, room * 4 // RANKS / 4))
      local views = gap == TALL and not hud.full and { "all" } or many and { "name", "ship", "far" } or { "name", "far" }
      local what = views[age // TURN % #views + 1]
      for i = 1, RANKS do
        local r = rows[i]
        local bank = page.bank(i, age, hud.banks[i == mark and "bright" or r and "plain" or "faint"])
        if bank then draw_row(i, r, row + (i - 1) * gap, bank, i == mark, what) end
      end
    end,
  }
end

-- Adds a mode's tables of a difficulty to a list. Returns the index of the ship's own.
local function add_tables(list, difficulty, mode, ship, mark)
  local name = sys.score_table(difficulty, mode.name)
  local all, first, at = score.rows(name), #list + 1, #list + 1
  local function title(s) return mode.name and menu.label(mode.name) .. (s == "" and "" or ": ") .. s or s end
  for _, kind in ipairs(sys.kinds("player")) do
    local rows = score.rows(name, kind)
    if rows[1] then
      list[#list + 1] = table_page(title(menu.label(kind)), rows, kind == ship and mark)
      if kind == ship then at = #list + 1 end
    end
  end
  if #list <= first then
    list[first] = table_page(title "", all, mark)
    return first
  end
  table.insert(list, first, table_page(title(text.lang("All Ships")), all, not ship and mark, true))
  return at
end

-- The modes that can be played.
local function open_modes()
  local list, closed = {}, sys.read("boot/records").closed
  for _, mode in ipairs(rawget(sys, "modes") or { {} }) do
    if not closed(mode.needs) then list[#list + 1] = mode end
  end
  return list
end

-- difficulty: the first chapter shown; over: frames until the screen closes by itself; mark: a row to show bright, of the
-- table of `ship` if there is one, in `mode` (default: the first). Returns whether a player closed it.
return function(difficulty, over, mark, ship, mode)
  local names, labels, here, modes = sys.difficulties(), {}, 1, open_modes()
  mode = mode or modes[1].name
  for i, name in ipairs(names) do
    labels[i] = menu.label(name)
    if name == difficulty then here = i end
  end
  local function pages(c)
    local list, at = {}, 1
    for _, m in ipairs(modes) do
      local own = names[c] == difficulty and m.name == mode
      local i = add_tables(list, names[c], m, own and ship, own and mark)
      if own then at = i end
    end
    return list, at
  end
  local _, at = pages(here)
  return book.show { head = "Scores", chapters = labels, chapter = here, at = at, limit = over, pages = pages }
end

-- screens/unlocks.lua - the unlocks: titles of those that have been earned, and how to earn the others.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page, book = sys.read("menu/page"), sys.read("menu/book")

-- Each unlock as { lines, has }: its title, or question marks and the hint.
local function entries(cols)
  local list, got = {}, 0
  sys.unlock.each(function(u, has)
    local lines = { has and text.lang(u.title or menu.label(u.name)) or "? ? ?" }
    for _, s in ipairs(not has and u.hint and page.wrap(text.lang(u.hint), cols) or {}) do lines[#lines + 1] = s end
    list[#list + 1], got = { lines = lines, has = has }, got + (has and 1 or 0)
  end)
  return list, got
end

local function height(e) return #e.lines * page.pitch + 1 end

local function draw(list, first, last, row, age, cols)
  local col = page.col + (page.cols - cols) // 2 + 1
  for i = first, last do
    local e = list[i]
    local bank = page.bank(i - first + 1, age, e.has and hud.banks.bright or hud.banks.faint)
    for k, s in ipairs(bank and e.lines or {}) do
      hud.put(col, row + (k - 1) * page.pitch, s, k == 1 and bank or hud.banks.plain)
    end
    if bank then page.stars(col - 2, row, e.has and 1 or 0, 1, bank) end
    row = row + height(e)
  end
end

-- over: frames until the screen closes by itself, or nil. Returns whether a player closed it.
return function(over)
  local cols = math.min(page.cols - 6, 32)
  local list, got = entries(cols)
  local _, room = book.room(1)
  local pages = book.split(#list, room, function(i) return height(list[i]) end)
  local title = text.lang("Unlocked: %s"):format(text.lang("%d of %d"):format(got, #list))
  for i, p in ipairs(pages) do
    local first, last = p[1], p[2]
    pages[i] = {
      title = title, count = last - first + 1,
      draw = function(row, _, age) draw(list, first, last, row, age, cols) end,
    }
  end
  return book.show { head = "Extras", chapters = { "" }, pages = function() return pages end, limit = over }
end

-- screens/title.lua - the title: a logo, a line that asks for START, and then a list of where one can go.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local WORDS = {
  missions = "MISSIONS",
  scores = "SCORES", history = "SPELLS", music = "MUSIC", unlocks = "EXTRAS", replays = "REPLAYS", settings = "SETTINGS",
}
local UNDER = page.low and 5 or 9 -- rows from the middle of the logo to the first of the list, at least
local SHINES <const>, AGAIN <const> = 24, 200 -- frames that a light runs over the logo, and from one to the next
local DROP = 24 -- px from above that the logo comes
local LEAST <const> = 4 -- items that are seen with an empty row between them; where there is no room for so many, none is
local LIFT <const> = 8  -- frames in which the logo makes room for a long list

-- The name of a game without a logo, its letters apart where there is room.
local function draw_name(row, age)
  local name = rom.title:upper()
  local apart = name:gsub("[%g]", "%0 "):gsub(" $", "")
  if #name == sys.cells(name) and #apart <= page.cols - 4 then name = apart end
  page.rule(row - 2, age)
  local below = page.centre(row, name, hud.banks.bright)
  page.rule(below + 1, age)
end

local function put_logo(row)
  if not rom.has("logo") then return nil end
  return sprite.put { sprite = "logo", x = page.x, y = row * 8 - DROP, screen = true }
end

-- Light that runs over the logo: a sprite of several frames, logo_light, of the logo's size. It is there while its
-- frames play once.
local function put_light(logo)
  if not (logo and rom.has("logo_light")) then return nil end
  return sprite.put { sprite = "logo_light", x = logo.x, y = logo.y, screen = true, hidden = true }
end

local function shine(light, logo, age)
  if not light then return end
  light.y, light.hidden = logo.y, age % AGAIN >= SHINES
  if age % AGAIN == 0 then light.sprite = "logo_light" end -- from its first frame on
end

local function draw_best()
  local top = score.rows(board.difficulty())[1]
  if top then page.centre(page.row + 1, text.lang("HI %09d"):format(top.score)) end
end

-- Waits for a press; false when nobody came.
local function wait_for_start(row, third, logo, light, limit)
  for age = 0, limit - 1 do
    if logo then
      logo.y = third * 8 - DROP * math.max(0, 16 - age) // 16
      shine(light, logo, age + AGAIN - DROP)
    elseif page.opening(age, 0) then
      draw_name(third, age)
    end
    if age % 60 == 0 then page.centre(row, "PRESS START", hud.banks.bright) end
    if age % 60 == 40 then page.clear(row, 1) end
    sys.tell_keys()
    wait(1)
    if page.accepted() then
      page.clear(row, 1)
      if logo then logo.y = third * 8 end
      if light then light.hidden = true end
      return true
    end
  end
  return false
end

-- What can be chosen, as { what, players } each, and the words for it.
local function entries(words)
  local list, items = {}, {}
  for _, what in ipairs(words) do
    if what == "start" and sys.players() > 1 then
      list[1], list[2] = { what, 1 }, { what, 2 }
      items[1], items[2] = text.lang("1 PLAYER"), text.lang("2 PLAYERS")
    else
      list[#list + 1] = { what, 1 }
      local word = what == "start" and "START" or WORDS[what]
      items[#items + 1] = word and text.lang(word) or menu.label(what)
    end
  end
  return list, items
end

local function index_of(list, what)
  for i, entry in ipairs(list) do
    if entry[1] == what then return i end
  end
end

-- Where a list of n items lies below a logo in row `third`: its first row, rows from one to the next, how many of them
-- are seen, and how many rows higher the logo stands then.
local function lay_out(n, row, third, logo)
  local top, last = row - (page.low and 2 or 0), page.row + page.rows - 3 -- the cabinet says the keys below
  local free = logo and math.max(0, third - page.row - UNDER) or 0        -- rows between the best score and the logo
  top = math.max(math.min(top, third + UNDER, last - 2 * (n - 1)), third + UNDER - free)
  local lift, seen = math.max(0, third + UNDER - top), math.min(n, (last - top) // 2 + 1)
  if seen >= math.min(n, LEAST) then return top, 2, seen, lift end
  return math.min(top, last - n + 1), 1, n, lift
end

-- The number of what is chosen from the list; 0: back, nil: nobody answers.
local function choose(items, row, chosen, third, logo)
  if #items == 1 then return 1 end
  local top, gap, seen, lift = lay_out(#items, row, third, logo)
  local function draw(age)
    if logo then logo.y = (third - lift * math.min(age, LIFT) / LIFT) * 8 end
  end
  return page.list {
    items = items, row = top, chosen = chosen, back = 0, gap = gap, most = seen, draw = draw, keys = true,
  }
end

-- words: where one can go, "start" first; last: where one comes from, or nil. Returns where to, and how many play; nil
-- when nobody came for `limit` frames.
return function(limit, words, last)
  text.clear()
  local third = page.row + page.rows // 3
  local row, logo = page.row + 2 * (page.rows // 3), put_logo(third)
  local light = put_light(logo)
  local list, items = entries(words)
  local here, back = 0, last and index_of(list, last)
  draw_best()
  if back then
    if logo then logo.y = third * 8 else draw_name(third, page.cols) end
    here = choose(items, row, back, third, logo)
  end
  while here == 0 do
    local came = wait_for_start(row, third, logo, light, limit)
    here = came and choose(items, row, 1, third, logo)
  end
  text.clear()
  if logo then logo:remove() end
  if light then light:remove() end
  if here then return table.unpack(list[here]) end
end

-- screens/title.lua - the title: a logo and "Press Start", then the main menu.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local LABELS <const> = {
  start = "Start", practice = "Practice", missions = "Missions", replays = "Replays", scores = "Scores",
  history = "Spells", music = "Music", unlocks = "Extras", settings = "Settings", how_to_play = "How to Play",
  quit = "Quit Game",
}
local KEYS <const> = { "start", "Start" }
local UNDER <const> = page.low and 5 or 9 -- rows from the name of a game without a logo to the menu, at least
local BEST <const> = 2.5 -- rows that the best score takes above the logo
local SHINE <const>, SHINE_AGAIN <const> = 24, 200 -- frames that the light on the logo takes, and from one to the next
local DROP <const> = 24     -- px that the logo falls when the title opens
local GAPS <const> = { 2, 1.75, 1.5 } -- rows from one entry to the next; the first with which all entries fit
local FEWEST <const> = 4    -- a menu that can't show this many entries at the last of these shows them a row apart
local LIFT_TIME <const> = 8 -- frames in which the logo moves up for a long menu

-- Draws the name of a game without a logo, spaced out if there is room.
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

-- The light that runs over the logo: the sprite logo_light, of the logo's size. It plays its frames once.
local function put_light(logo)
  if not (logo and rom.has("logo_light")) then return nil end
  return sprite.put { sprite = "logo_light", x = logo.x, y = logo.y, screen = true, hidden = true }
end

local function shine(light, logo, age)
  if not light then return end
  light.y, light.hidden = logo.y, age % SHINE_AGAIN >= SHINE
  if age % SHINE_AGAIN == 0 then light.sprite = "logo_light" end -- restarts its frames
end

local function draw_best()
  local top = score.rows(board.difficulty())[1]
  if top then page.centre(page.row + 1, text.lang("HI %s"):format(page.number(top.score))) end
end

-- Waits for fire or START. Returns false if nobody pressed one for `limit` frames.
local function wait_for_start(row, third, logo, light, limit)
  for age = 0, limit - 1 do
    if logo then
      logo.y = third * 8 - DROP * math.max(0, 16 - age) // 16
      shine(light, logo, age + SHINE_AGAIN - DROP)
    elseif page.opening(age, 0) then
      draw_name(third, age)
    end
    if age % 60 == 0 then page.centre(row, "Press Start", hud.banks.bright) end
    if age % 60 == 40 then page.clear(row, 1) end
    page.tell(KEYS)
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

-- Returns the entries of the menu, each { name, players }, and their labels.
local function entries(names)
  local list, items = {}, {}
  local function add(name, players, label)
    list[#list + 1], items[#items + 1] = { name, players }, label
  end
  for _, name in ipairs(names) do
    if name == "start" and sys.players() > 1 then
      add(name, 1, text.lang("1 Player"))
      add(name, 2, text.lang("2 Players"))
    else
      add(name, 1, LABELS[name] and text.lang(LABELS[name]) or menu.label(name))
    end
  end
  return list, items
end

local function index_of(list, name, players)
  local first
  for i, entry in ipairs(list) do
    if entry[1] == name then
      first = first or i
      if entry[2] == players then return i end
    end
  end
  return first
end

-- Returns the layout of a menu of n items below a logo at row `third`: its first row, the rows from one item to the
-- next, the items shown at a time, and the rows by which the logo moves up. Items move together before the menu scrolls.
local function lay_out(n, row, third, logo)
  local under, free, last = third + UNDER, 0, page.rows - 3.5 -- the bar of row `last` is above the program's keys
  if logo then
    local _, h, _, above = sys.size("logo")
    under, free = third + (h - above + 15) // 8, math.max(0, third - BEST - above / 8)
  end
  for i, gap in ipairs(GAPS) do
    local top = math.max(math.min(row, under, last - gap * (n - 1)), under - free)
    local seen = math.min(n, math.floor((last - top) / gap) + 1)
    if seen == n or i == #GAPS and seen >= FEWEST then return top, gap, seen, math.max(0, under - top) end
  end
  return math.max(0, math.min(under, last - n + 1)), 1, n, 0
end

-- Returns the number of the chosen item; 0: back; nil: nobody chose.
local function choose(items, row, chosen, third, logo)
  local top, gap, seen, lift = lay_out(#items, row, third, logo)
  local function draw(age)
    if logo then logo.y = (third - lift * math.min(age, LIFT_TIME) / LIFT_TIME) * 8 end
  end
  return page.list {
    items = items, row = top, chosen = chosen, back = 0, gap = gap, most = seen, draw = draw,
    keys = page.SELECT,
  }
end

-- names: the entries, "start" first. last, players: the entry that the player returns from, or nil. Returns the
-- chosen entry and the number of players; nil if nobody pressed a button for `limit` frames.
return function(limit, names, last, players)
  text.clear()
  local third = page.row + page.rows // 3
  local row, logo = page.row + 2 * (page.rows // 3), put_logo(third)
  local light = put_light(logo)
  local list, items = entries(names)
  local chosen, back = 0, last and index_of(list, last, players)
  draw_best()
  if back then
    if logo then logo.y = third * 8 else draw_name(third, page.cols) end
    chosen = choose(items, row, back, third, logo)
  end
  while chosen == 0 do
    local is_here = wait_for_start(row, third, logo, light, limit)
    chosen = is_here and choose(items, row, 1, third, logo)
  end
  text.clear()
  if logo then logo:remove() end
  if light then light:remove() end
  if chosen then return table.unpack(list[chosen]) end
end

-- boot.lua - replaces the standard boot.lua: a book instead of a title. It repeats one recipe at a time and shows the
-- description next to the field. The arrows turn pages while the list is open, and fly the ship while it is closed.
local sys = ... -- functions for the standard library only
local boot = {}

local LENGTH <const> = 900 -- frames until a recipe restarts
local COL <const>, WIDTH <const>, LIST <const> = 1, 20, 13
local ROWS <const> = rom.screen.h // 8

local pages            -- a list of { name, recipe, title, words }
local at, open = 1, true
local difficulty       -- from the start of the run; recipes can change it
local turned           -- the player has turned the page or restarted it

-- One line per page: "name|title|words".
local function read(book)
  local by = {}
  for name, title, words in book:gmatch("([^|\n]*)|([^|\n]*)|([^\n]*)\n") do by[name] = { title, words } end
  for _, page in ipairs(pages) do
    local found = by[page.name] or { page.name, "" }
    page.title, page.words = found[1], found[2]
  end
end

local function put(row, s, bank)
  text.put { col = COL, row = row, text = s .. (" "):rep(WIDTH - #s), bank = bank or 0 }
end

local function paragraph(row, s, bank)
  for _, line in ipairs(sys.wrap(s, WIDTH)) do
    put(row, line, bank)
    row = row + 1
  end
  return row
end

local function draw_list()
  local first = math.max(1, math.min(at - LIST // 2, #pages - LIST + 1))
  for i = first, math.min(first + LIST - 1, #pages) do
    put(ROWS - 8 - LIST + i - first, (i == at and ">" or " ") .. pages[i].title:sub(1, WIDTH - 1), i == at and 3 or 6)
  end
end

local function draw()
  local page = pages[at]
  text.clear { w = COL + WIDTH + 1 }
  put(1, ("COOKBOOK       %2d/%2d"):format(at, #pages), 5)
  paragraph(paragraph(3, page.title, 3) + 1, page.words)
  if open then draw_list() end
  local help = open and { "ARROWS  pages", "FIRE  restart", "START     fly" } or
    { "START    list", "SPECIAL  next", "SELECT   back" }
  for i, line in ipairs(help) do put(ROWS - 6 + 2 * (i - 1), line, 6) end
end

local function go_to(i)
  at, turned = (i - 1) % #pages + 1, true
end

local function repeated(button) return pad.pressed(button) or pad.repeated(button) end

-- Handles the buttons of the book. While the list is open, the ship stays in place.
local function read_buttons()
  if pad.take("start", 0) then
    open = not open
    draw()
  elseif not open then
    if pad.take("special", 0) then go_to(at + 1) elseif pad.take("select", 0) then go_to(at - 1) end
  else
    for button, step in pairs { left = -1, right = 1, up = -10, down = 10 } do
      if repeated(button) then go_to(at + step) end
    end
    if pad.take("fire", 0) then turned = true end
  end
end

-- Declares a page as a stage that runs its recipe for LENGTH frames.
local function stage_of(page)
  local r = page.recipe
  if type(r) == "function" then r = { run = r } end
  page.ship, page.hud = r.ship or "ship", r.hud
  stage.def(page.name, function()
    local e = not r.alone and enemy.spawn { kind = "jelly", x = 120, y = 80 } or nil
    if e then
      e.safe = r.mortal and 0 or forever
      task.own(e, r.run, player.get(1))
    else
      task.go(r.run, nil, player.get(1))
    end
    wait(LENGTH)
  end)
end

-- Plays page `at` until it ends or the player turns the page.
local function play()
  local page, game = pages[at], sys.scope()
  sys.wipe()
  board.difficulty(difficulty)
  sys.join(1, page.ship)
  sys.start(game)
  if page.hud then hud.start(game, 1) end
  draw()
  turned = false
  local part, p = stage.play(page.name, game), player.get(1)
  local x, y = p.x, p.y
  wait_until(function()
    read_buttons()
    if open then p.x, p.y = x, y else x, y = p.x, p.y end
    return turned or not task.alive(part)
  end)
  task.stop(game)
  sys.wipe()
  sys.leave(1)
end

-- Lists what can be practised, for the cabinet.
local function tell()
  sys.mark("ship", "ship", "", "", 3)
  for _, page in ipairs(pages) do
    sys.mark("stage", page.name)
    wait(1)
  end
  sys.mark("listed", "")
end

function boot.run(list, book)
  pages = list
  read(book)
  local first = sys.practice()
  difficulty = board.difficulty()
  for i, page in ipairs(pages) do
    stage_of(page)
    if page.name == first then at, open = i, false end
  end
  if first == "?" then return task.go(tell) end
  if first ~= "" then stage.expect("boot.run", first) end
  task.go(function()
    while true do
      if first ~= "" then sys.mark("start", "") end
      play()
      wait(1) -- a press turns one page
    end
  end)
end

return boot

-- menu.lua - the screens around the game. Each is a plain function, called in a task, that returns what was chosen.
-- To change one, put a std/menu.lua into the game; boot.lua says when each is shown.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local menu = {}

local ARROW = hud.glyph(140, ">")
local IDLE = 30 * 60 -- frames after which a screen that nobody answers gives up
local RANKS = 10     -- rows of the score table

-- Did player p (nil: one of the players) press the button in this frame? An earlier press was not meant for this
-- screen. The press is taken, so that the game does not see it as well.
local function pressed(button, p)
  if p then return pad.take(button, 0, p) end
  return pad.take(button, 0, 1) or pad.take(button, 0, 2)
end

local function stepped(button, p)
  if pressed(button, p) then return true end
  if p then return pad.repeated(button, p) end
  return pad.repeated(button, 1) or pad.repeated(button, 2)
end

local function accepted(p) return pressed("fire", p) or pressed("start", p) end

-- A declared name as a line of text: "rose_red" is ROSE RED.
function menu.label(name) return text.lang((name:gsub("_", " "):upper())) end

local function draw_items(items, col, row, chosen)
  for i, item in ipairs(items) do
    local mine = i == chosen
    hud.put(col - 2, row, mine and ARROW or " ", hud.banks.bright)
    hud.put(col, row, item, mine and hud.banks.bright or hud.banks.plain)
    row = row + 2
  end
end

-- Shows a list to choose from: items, row, and if wanted title, chosen, p (whose switches), limit (frames), back (the
-- number bomb answers; false: bomb does nothing). Returns the number chosen, or nil for bomb or when nobody answers.
function menu.choose(a)
  local n, chosen, longest, items = #a.items, a.chosen or 1, 0, {}
  for i, item in ipairs(a.items) do
    items[i] = text.lang(item)
    longest = math.max(longest, sys.cells(items[i]))
  end
  local col = math.max(2, (hud.cols - longest) // 2)
  local top = a.row
  if a.title then top = hud.centre(a.row, a.title, hud.banks.bright) + 1 end
  local answer, idle = nil, 0
  while idle < (a.limit or IDLE) do
    draw_items(items, col, top, chosen)
    wait(1) -- the press that opened this list is not meant for it
    idle = idle + 1
    local step = (stepped("down", a.p) and 1 or 0) - (stepped("up", a.p) and 1 or 0)
    if step ~= 0 then
      chosen, idle = (chosen - 1 + step) % n + 1, 0
      sys.cue("menu")
    end
    if accepted(a.p) then
      answer = chosen
      break
    end
    if a.back ~= false and pressed("bomb", a.p) then
      answer = a.back
      break
    end
  end
  text.clear { col = 0, row = a.row, w = hud.cols, h = math.min(hud.rows, top + 2 * n) - a.row }
  return answer
end

-- True for start, false when nobody came.
function menu.title(over)
  text.clear()
  local third, logo = hud.rows // 3, nil
  if rom.has("logo") then
    logo = sprite.put { sprite = "logo", x = rom.screen.w // 2, y = third * 8, screen = true }
  else
    hud.centre(third - 1, rom.title:upper(), hud.banks.bright)
  end
  local top = score.rows(board.difficulty())[1]
  if top then hud.centre(1, text.lang("HI %09d"):format(top.score)) end
  local started = wait_until(function()
    if board.frame() % 60 < 40 then
      hud.centre(2 * third, "PRESS START", hud.banks.bright)
    else
      text.clear { col = 0, row = 2 * third, w = hud.cols, h = 1 }
    end
    return accepted()
  end, over)
  text.clear()
  if logo then logo:remove() end
  return started
end

-- How many play; nil: back.
function menu.players()
  return menu.choose { title = "HOW MANY PLAYERS?", items = { "1 PLAYER", "2 PLAYERS" }, row = hud.rows // 3 }
end

-- The ship of player p, by name; nil: back.
function menu.ship(p, kinds, many)
  local items = {}
  for i, kind in ipairs(kinds) do items[i] = menu.label(kind) end
  local title = many and text.lang("PLAYER %d, YOUR SHIP?"):format(p) or "YOUR SHIP?"
  return kinds[menu.choose { title = title, items = items, row = hud.rows // 3, p = many and p or nil } or 0]
end

-- A difficulty, by name; nil: back.
function menu.difficulty(names, present)
  local items, chosen = {}, 1
  for i, name in ipairs(names) do
    items[i] = menu.label(name)
    if name == present then chosen = i end
  end
  return names[menu.choose { title = "DIFFICULTY?", items = items, chosen = chosen, row = hud.rows // 3 } or 0]
end

-- The game's own pause: 1 goes on, 2 is the other item.
function menu.pause(p, other)
  local row = hud.rows // 2 - 4
  return menu.choose { title = "PAUSE", items = { "GO ON", other }, row = row, p = p, back = 1, limit = forever }
end

local function tally(row, i, many)
  local p = player.get(i)
  if many then row = hud.centre(row, text.lang("PLAYER %d"):format(i), hud.banks.bright) + 1 end
  row = hud.centre(row, text.lang("SCORE  %09d"):format(hud.score(i)))
  row = hud.centre(row + 1, text.lang("GRAZE  %9d"):format(p.grazes or 0))
  row = hud.centre(row + 1, text.lang("LIVES  %9d"):format(p.lives or 0))
  return row + 2
end

-- What a stage brought; over when somebody says so, or by itself, or when stopped() holds.
function menu.results(title, players, stopped)
  local top = hud.rows // 3
  local row = hud.centre(top, title, hud.banks.bright) + 2
  for i = 1, players do row = tally(row, i, players > 1) end
  wait_until(stopped, 60) -- a second in which fire is not asked: players still press it quickly when the boss bursts
  wait_until(function() return stopped() or pressed("fire") end, 240)
  text.clear { col = 0, row = top, w = hud.cols, h = hud.rows - top }
end

-- The score table; mark is a row to show bright. Over when somebody presses, or after so many frames.
function menu.scores(name, over, mark)
  text.clear()
  local rows, row = score.rows(name), math.max(1, hud.rows // 2 - RANKS - 2)
  hud.centre(row, text.lang("BEST OF %s"):format(menu.label(name)), hud.banks.bright)
  for i = 1, RANKS do
    local r = rows[i] or { name = "--------", score = 0 }
    local line = ("%2d %-8s %09d"):format(i, r.name, r.score)
    local bank = i == mark and "bright" or rows[i] and "plain" or "faint"
    hud.centre(row + 1 + 2 * i, line, hud.banks[bank])
  end
  wait(1)
  local answered = wait_until(accepted, over)
  text.clear()
  return answered
end

-- The row a score would take in its table, or nil.
function menu.rank(name, points)
  if points <= 0 then return nil end
  for i, r in ipairs(score.rows(name)) do
    if points > r.score then return i <= RANKS and i or nil end
  end
  local n = #score.rows(name)
  return n < RANKS and n + 1 or nil
end

local MIN, MAX = 3, 8 -- letters of a name

local function letter(n) return string.char(65 + n % 26) end

local function draw_name(name, row)
  local col = math.max(0, (hud.cols - 2 * MAX) // 2)
  for i = 1, MAX do
    local at = i == #name
    hud.put(col + 2 * i - 1, row, name[i] and letter(name[i]) or "_", at and hud.banks.bright or hud.banks.plain)
    hud.put(col + 2 * i - 1, row + 1, at and "^" or " ", hud.banks.bright)
  end
  hud.centre(row + 9, #name >= MIN and "START: DONE" or "           ", hud.banks.faint)
end

-- One frame of name entry on a list of letter numbers, the last being chosen; true when it is finished.
local function edit(name, p)
  local n = #name
  local step = (stepped("up", p) and 1 or 0) - (stepped("down", p) and 1 or 0)
  name[n] = (name[n] + step) % 26
  if pressed("start", p) and n >= MIN then return true end
  if pressed("fire", p) or pressed("right", p) then
    if n == MAX then return true end
    name[n + 1] = name[n]
  elseif (pressed("bomb", p) or pressed("left", p)) and n > 1 then
    name[n] = nil
  end
end

-- The name player p enters for a score: 3 to 8 letters; AAA when nobody is there.
function menu.name(p, points)
  text.clear()
  local row = hud.rows // 3
  hud.centre(row - 4, text.lang("PLAYER %d  %09d"):format(p, points), hud.banks.bright)
  hud.centre(row - 2, "YOUR NAME?", hud.banks.bright)
  hud.centre(row + 5, "UP DOWN: LETTER", hud.banks.faint)
  hud.centre(row + 7, "FIRE: NEXT  BOMB: BACK", hud.banks.faint)
  local name, idle, s = { 0 }, 0, ""
  repeat
    draw_name(name, row + 1)
    wait(1)
    idle = idle + 1
  until edit(name, p) or idle >= 2 * IDLE
  text.clear()
  for _, n in ipairs(name) do s = s .. letter(n) end
  return s .. ("A"):rep(MIN - #s)
end

return menu

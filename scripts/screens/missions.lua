-- screens/missions.lua - the list of missions: the stars of each, and below it what the chosen one asks for and how well
-- it was done.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local STAR = hud.glyph(138, "*")
local LEFT <const>, RIGHT <const> = hud.glyph(139, "<"), hud.glyph(140, ">")
local NOTES <const> = page.low and 8 or 11 -- rows below the list: two of which page it is, and of words
local COLS <const> = math.min(page.cols - 5, 34)
local COL <const> = page.col + (page.cols - COLS + 1) // 2 -- an arrow stands two before it

-- Each mission as { m, title, stars, value, ship, closed }.
local function entries()
  local list, closed = {}, sys.read("boot/records").closed
  sys.missions.each(function(m, i)
    local value, stars, ship = sys.missions.best(m)
    local hint = closed(m.needs)
    list[i] = { m = m, title = hint and "? ? ?" or text.lang(m.title), stars = stars, value = value, ship = ship, closed = hint }
  end)
  return list
end

-- What a value of a measure reads.
local function measure(by, value)
  if by ~= "time" then return menu.label(by) .. " " .. value end
  return text.lang("TIME %d.%02d"):format(value // 60, value % 60 * 100 // 60)
end

local function draw_row(e, i, row, chosen, age)
  local bank = page.bank(1, age, hud.banks[chosen and "bright" or e.closed and "faint" or "plain"])
  page.clear(row, 1)
  local words = ("%2d %s"):format(i, hud.wrap(e.title, COLS - 7)[1])
  if chosen then hud.put(COL - 2, row, RIGHT, hud.banks.bright) end
  hud.put(COL, row, words, bank)
  if e.stars > 0 then hud.put(COL + COLS - 3, row, STAR:rep(e.stars), hud.banks.bright) end
end

-- What stands below the list: what is asked, of whom, the best so far.
local function draw_note(e, row)
  local m, apart = e.m, page.low and 1 or 2
  page.clear(row, NOTES - 2)
  row = page.text(row, e.closed or m.text or "", hud.banks.plain, page.col, page.cols)
  if e.closed then return end
  local words = {}
  if m.ship then words[1] = menu.label(m.ship) end
  if m.difficulty then words[#words + 1] = menu.label(m.difficulty) end
  if #words > 0 then
    page.centre(row, table.concat(words, "  "), hud.banks.faint)
    row = row + apart
  end
  if e.value then
    page.centre(row, text.lang("BEST: %s"):format(measure(m.by, e.value)), hud.banks.bright)
    if not m.ship then page.centre(row + apart, menu.label(e.ship), hud.banks.faint) end
  end
end

-- The rows of the page that the chosen one is on, and below them which page of how many that is.
local function draw_list(list, at, top, rows, gap, age)
  local first, pages = (at - 1) // rows * rows, (#list + rows - 1) // rows
  if pages > 1 then
    local words = LEFT .. (" %d/%d "):format(first // rows + 1, pages) .. RIGHT
    page.clear(top + rows * gap, 1)
    page.centre(top + rows * gap, words, hud.banks.faint)
  end
  for k = 1, rows do
    local e = list[first + k]
    if e then draw_row(e, first + k, top + (k - 1) * gap, first + k == at, age) else page.clear(top + (k - 1) * gap, 1) end
  end
end

local function draw_head(age)
  local got, all = sys.missions.total()
  local top = page.head("MISSIONS", age)
  page.centre(top - 1, ("%s %d/%d"):format(STAR, got, all), hud.banks.faint)
  page.foot("FIRE: OK  BOMB: BACK", age)
  return top + (page.low and 1 or 2)
end

-- Where the buttons lead from there.
local function move(at, n, rows)
  local down, right = page.step("up", "down"), page.step("left", "right")
  if down ~= 0 then return (at - 1 + down) % n + 1 end
  if right ~= 0 then return math.max(1, math.min(n, at + right * rows)) end
  return at
end

-- last: the name of the one that was played before, or nil. Returns a name; nil: back.
return function(last)
  local list = entries()
  local at = last and sys.missions.place(last) or 1
  page.begin()
  local top = draw_head(0)
  local room = page.row + page.rows - (page.low and 3 or 6) - top - NOTES
  local gap = page.low and 1 or 2
  if not page.low then page.frame(top, room + NOTES - 1) end
  local rows, age, idle, answer = math.max(1, math.min(#list, room // gap)), 0, 0, nil
  while idle < page.IDLE do
    if page.opening(age, 0) then
      draw_head(idle)
      draw_list(list, at, top, rows, gap, age)
      draw_note(list[at], top + rows * gap + 2)
    end
    sys.tell_keys()
    wait(1)
    age, idle = age + 1, idle + 1
    local to = move(at, #list, rows)
    if to ~= at then
      at, age, idle = to, 5, page.cols
      draw_list(list, at, top, rows, gap, age)
      draw_note(list[at], top + rows * gap + 2)
      sys.cue("menu")
    end
    if page.accepted() then
      sys.cue(list[at].closed and "wrong" or "select")
      if not list[at].closed then
        answer = list[at].m.name
        break
      end
    elseif page.pressed("bomb") then
      sys.cue("back")
      break
    end
  end
  page.done()
  return answer
end

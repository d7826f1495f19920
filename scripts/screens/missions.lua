-- screens/missions.lua - the list of missions with their stars. Below the list are the goal of the chosen mission and its
-- best result.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local STAR = hud.glyph(138, "*")
local LEFT <const>, RIGHT <const> = hud.glyph(139, "<"), hud.glyph(140, ">")
local NOTES <const> = page.low and 8 or 11 -- rows below the list: of the page number and of the note
local COLS <const> = math.min(page.cols - 6, 34)
local COL <const> = page.col + (page.cols - COLS) // 2
local STARS <const> = 3

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

-- The values that earn the second and the third star.
local function medals(m)
  local s = page.measure(m.by)
  for i, v in ipairs(m.medals or {}) do s = ("%s %s %s"):format(s, STAR:rep(i + 1), page.amount(m.by, v)) end
  return s
end

local function draw_row(e, i, row, chosen, age)
  local bank = page.bank(1, age, hud.banks[chosen and "bright" or e.closed and "faint" or "plain"])
  page.clear(row, 1)
  local words = ("%2d %s"):format(i, hud.wrap(e.title, COLS - 8)[1])
  hud.put(COL + 1, row, words, bank)
  if not e.closed then page.stars(COL + COLS - STARS, row, e.stars, STARS) end
end

-- Draws what is below the list: the goal, the ship and difficulty, the best result.
local function draw_note(e, row)
  local m, apart = e.m, page.pitch
  page.clear(row, math.floor(NOTES) - 2)
  row = page.text(row, e.closed and page.how_to_unlock(e.closed) or m.text or "", hud.banks.plain)
  if e.closed then return end
  local words = {}
  if m.ship then words[1] = menu.label(m.ship) end
  if m.difficulty then words[#words + 1] = menu.label(m.difficulty) end
  if #words > 0 then
    page.centre(row, table.concat(words, "  "), hud.banks.faint)
    row = row + apart
  end
  if m.medals then
    page.centre(row, medals(m), hud.banks.plain)
    row = row + apart
  end
  if e.value then
    local best = text.lang("Best: %s"):format(page.measure(m.by) .. " " .. page.amount(m.by, e.value))
    page.centre(row, m.ship and best or best .. "  " .. menu.label(e.ship), hud.banks.bright)
  end
end

-- Draws the page of the list that has the chosen mission, and the number of the page below it.
local function draw_list(list, at, top, rows, gap, age)
  local first, pages = (at - 1) // rows * rows, (#list + rows - 1) // rows
  if pages > 1 then
    local words = LEFT .. (" %d/%d "):format(first // rows + 1, pages) .. RIGHT
    page.clear(top + rows * gap + 0.5, 1)
    page.centre(top + rows * gap + 0.5, words, hud.banks.faint)
  end
  for k = 1, rows do
    local e = list[first + k]
    if e then draw_row(e, first + k, top + (k - 1) * gap, first + k == at, age) else page.clear(top + (k - 1) * gap, 1) end
  end
end

local function draw_head(age)
  local got, all = sys.missions.total()
  local top = page.head("Missions", age)
  page.centre(top, ("%s %d/%d"):format(STAR, got, all), hud.banks.faint)
  page.foot(page.SELECT)
  return top + (page.low and 2 or 3)
end

-- Returns the mission that the buttons lead to from mission `at`.
local function move(at, n, rows)
  local down, right = page.step("up", "down"), page.step("left", "right")
  if down ~= 0 then return (at - 1 + down) % n + 1 end
  if right ~= 0 then return math.max(1, math.min(n, at + right * rows)) end
  return at
end

-- last: the name of the mission that was played before, or nil. Returns a name, or nil for back.
return function(last)
  local list = entries()
  local at = last and sys.missions.place(last) or 1
  page.begin()
  local top = draw_head(0)
  local room = page.bottom - top - NOTES
  local gap = page.low and 1.5 or 1.75
  page.frame()
  local rows, age, idle, answer = math.max(1, math.min(#list, math.floor(room / gap))), 0, 0, nil
  local below = math.ceil(top + rows * gap)
  local bar = page.bar(COL - 1, top, COLS + 2, gap)
  while idle < page.IDLE do
    if page.opening(age, 0) then
      draw_head(idle)
      draw_list(list, at, top, rows, gap, age)
      draw_note(list[at], below + 2.5)
    end
    page.glide(bar, top + (at - 1) % rows * gap, age == 0)
    page.cursor(COL - 0.5, top + (at - 1) % rows * gap, age)
    page.tell(list[at].closed and page.BACK or page.SELECT)
    wait(1)
    age, idle = age + 1, idle + 1
    local to = move(at, #list, rows)
    if to ~= at then
      at, age, idle = to, 5, page.cols
      draw_list(list, at, top, rows, gap, age)
      draw_note(list[at], below + 2.5)
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
  bar:remove()
  page.done()
  return answer
end

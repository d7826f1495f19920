-- screens/mission.lua - how a mission went, over its last picture, and whether it is tried again.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local STAR, DOT = hud.glyph(138, "*"), "-"
local SHORTEST <const> = 30 -- frames in which nothing is chosen: players still press fire
local BETWEEN <const> = 12  -- frames from one star to the next
local MOST <const> = 3

local function measure(by, value)
  if by ~= "time" then return menu.label(by) .. " " .. value end
  return text.lang("TIME %d.%02d"):format(value // 60, value % 60 * 100 // 60)
end

local function draw(r, row, age)
  row = page.centre(row, r.done and "MISSION CLEAR" or "MISSION FAILED", hud.banks[r.done and "bright" or "alarm"])
  page.rule(row, age, page.col + 2, page.cols - 4)
  row = page.centre(row + 2, r.title, hud.banks.plain) + 1
  local here = r.done and math.min(r.stars, age // BETWEEN) or 0
  for i = 1, MOST do
    local lit = i <= here
    hud.put(page.col + page.cols // 2 - 5 + 2 * i + 1, row, lit and STAR or DOT, hud.banks[lit and "bright" or "faint"])
  end
  row = row + 2
  if r.done then page.centre(row, measure(r.by, r.value), hud.banks.bright) end
  row = row + 2
  if r.new then
    page.centre(row, "NEW BEST", hud.banks.bright)
  elseif r.best then
    page.centre(row, text.lang("BEST: %s"):format(measure(r.by, r.best)), hud.banks.faint)
  end
end

-- r: mission, title, done, by and value (what is measured), stars, new (it is the best), best. Returns "again", or "list".
return function(r)
  local h = 16
  local top = page.row + math.max(3, (page.rows - h) // 3)
  local window = page.over(page.col + 1, top, page.cols - 2, h)
  for age = 0, SHORTEST + BETWEEN do
    page.grow(window, age)
    draw(r, top + 1, age)
    wait(1)
  end
  local items = { text.lang("RETRY"), text.lang("MISSIONS") }
  local i = page.list {
    items = items, row = top + h - 4, gap = 2, chosen = r.done and 2 or 1, back = 2, keys = true, front = true,
  }
  page.close(window)
  return i == 1 and "again" or "list"
end

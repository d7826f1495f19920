-- screens/mission.lua - the result of a mission, over its last picture, with the choice to retry.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local SHORTEST <const> = 30 -- frames in which buttons are ignored, because players still press fire
local BETWEEN <const> = 12  -- frames from one star to the next
local MOST <const> = 3

local function measure(by, value) return page.measure(by) .. " " .. page.amount(by, value) end

local function draw(r, row, age)
  row = page.centre(row, r.done and "Mission Clear" or "Mission Failed", hud.banks[r.done and "bright" or "alarm"])
  page.rule(row, age, page.col + 2, page.cols - 4)
  row = page.centre(row + 2, r.title, hud.banks.plain) + 1
  if r.done then
    page.stars(page.col + (page.cols - MOST) / 2, row, math.min(r.stars, age // BETWEEN), MOST)
    page.centre(row + 2, measure(r.by, r.value), hud.banks.bright)
  else
    page.centre(row, r.goal, hud.banks.plain, page.col + 2, page.cols - 4)
    page.centre(row + 1.75, r.reason, hud.banks.plain)
    page.centre(row + 3.5, r.progress, hud.banks.bright)
  end
  row = row + (r.done and 4 or 5.25)
  if r.new then
    page.centre(row, "New Best", hud.banks.bright)
  elseif r.best then
    page.centre(row, text.lang("Best: %s"):format(measure(r.by, r.best)), hud.banks.faint)
  end
end

-- r: mission, title, goal (its text), reason (why it failed), progress, done, by and value (what is measured), stars,
-- new (whether it is the best), best. Returns "again" or "list".
return function(r)
  local h = 16
  local top = page.row + math.max(3, (page.rows - h) // 3)
  local window = page.over(page.col + 1, top, page.cols - 2, h)
  for age = 0, SHORTEST + BETWEEN do
    page.grow(window, age)
    draw(r, top + 1, age)
    wait(1)
  end
  local items = { text.lang("Restart"), text.lang("Back to Missions") }
  local i = page.list {
    items = items, row = top + h - 4, gap = 2, chosen = r.done and 2 or 1, back = 2, keys = page.SELECT, front = true,
  }
  page.close(window)
  return i == 1 and "again" or "list"
end

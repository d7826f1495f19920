-- screens/ending.lua - the ending of a game that declares none.
local sys = ... -- functions for the standard library only; documented in src/script/api/api_sys.c
local page = sys.read("menu/page")

local OVER = 12 * 60 -- frames
local SOON = 60      -- frames in which buttons are ignored

-- Puts the ships side by side, below the screen's middle.
local function put_ships(ships, row)
  local list = {}
  for i, kind in ipairs(ships) do
    local x = page.x + (#ships > 1 and (i == 1 and -32 or 32) or 0)
    list[i] = sprite.put { sprite = sys.ship(kind).sprite, x = x, y = row * 8 + 80, screen = true, layer = "over" }
  end
  return list
end

-- run: the run that was cleared: mode, difficulty, ships, scores, stages.
return function(run)
  local row = page.row + page.rows // 2
  page.begin()
  local ships = put_ships(run.ships, row)
  for age = 0, OVER do
    if page.opening(age, 6) then
      local top = page.head("All Stages Clear", age)
      if not page.low then top = top + 2 end
      page.centre(top, "Congratulations!", page.bank(1, age, hud.banks.bright) or hud.banks.faint)
      page.centre(top + 2, menu.label(run.difficulty), hud.banks.plain)
      for p, points in ipairs(run.scores) do
        local line = text.lang("Player %d  %s"):format(p, page.number(points))
        page.centre(row + 4 + 2 * p, line, hud.banks.plain)
      end
    end
    for _, ship in ipairs(ships) do
      ship.y = row * 8 + math.max(0, 80 - 2 * age) + 3 * angle.sin(3 * age)
    end
    wait(1)
    if age > SOON and page.accepted() then break end
  end
  for _, ship in ipairs(ships) do ship:remove() end
  page.done()
end

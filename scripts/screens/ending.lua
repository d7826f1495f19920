-- screens/ending.lua - what stands there when all stages are cleared and the game has no ending of its own.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local OVER = 12 * 60 -- frames
local SOON = 60      -- the first, in which nothing is asked

-- The ships, side by side, coming up from below.
local function put_ships(ships, row)
  local list = {}
  for i, kind in ipairs(ships) do
    local x = page.x + (#ships > 1 and (i == 1 and -32 or 32) or 0)
    list[i] = sprite.put { sprite = sys.ship(kind).sprite, x = x, y = row * 8 + 80, screen = true, layer = "over" }
  end
  return list
end

-- run: what was played: mode, difficulty, ships, scores, stages.
return function(run)
  local row = page.row + page.rows // 2
  page.begin()
  local ships = put_ships(run.ships, row)
  for age = 0, OVER do
    if page.opening(age, 6) then
      local top = page.head("ALL STAGES CLEAR", age)
      if not page.low then top = top + 2 end
      page.centre(top, "CONGRATULATIONS!", page.bank(1, age, hud.banks.bright) or hud.banks.faint)
      page.centre(top + 2, menu.label(run.difficulty), hud.banks.plain)
      for p, points in ipairs(run.scores) do
        local line = text.lang("PLAYER %d  %09d"):format(p, points)
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

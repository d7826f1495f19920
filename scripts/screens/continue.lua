-- screens/continue.lua - shall player p go on? Ten seconds, shorter by one with each bomb.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local SECONDS = 9
local W <const>, H <const> = 22, 11 -- cells of the window

-- left: how many continues there are. Returns true for yes.
return function(p, left)
  local col, row = page.col + (page.cols - W) // 2, page.row + (page.rows - H) // 2
  local answer = false
  local window = page.over(col, row, W, H)
  page.centre(row + 1, text.lang("PLAYER %d"):format(p), hud.banks.plain, col, W)
  page.centre(row + 3, "CONTINUE?", hud.banks.bright, col, W)
  page.centre(row + 9, text.lang("START: %d LEFT"):format(left), hud.banks.plain, col, W)
  local frame = 0
  while frame < (SECONDS + 1) * 60 and not answer do
    page.grow(window, frame)
    page.centre(row + 6, tostring(SECONDS - frame // 60), hud.banks.bright, col, W)
    wait(1)
    frame = frame + 1
    if page.pressed("bomb", p) then frame = (frame // 60 + 1) * 60 end
    answer = page.pressed("start", p)
  end
  page.close(window)
  return answer
end

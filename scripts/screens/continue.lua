-- screens/continue.lua - asks player p whether to continue, for ten seconds; each press of bomb takes one off.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local SECONDS = 9
local W <const>, H <const> = 22, 15 -- cells of the window
local SIZE <const> = 3              -- of the digit

-- left: the number of continues. Returns true for yes.
return function(p, left)
  local col, row = page.col + (page.cols - W) // 2, page.row + (page.rows - H) // 2
  local answer = false
  local window = page.over(col, row, W, H)
  page.centre(row + 1, text.lang("Player %d"):format(p), hud.banks.plain, col, W)
  page.centre(row + 3, "Continue?", hud.banks.bright, col, W)
  page.centre(row + 12, text.lang("Continues Left: %d"):format(left), hud.banks.plain, col, W)
  local frame = 0
  while frame < (SECONDS + 1) * 60 and not answer do
    page.grow(window, frame)
    page.clear(row + 6, SIZE, col, W)
    hud.put(col + (W - SIZE) / 2, row + 6, tostring(SECONDS - frame // 60), hud.banks.bright, SIZE)
    sys.tell_key("start", "Continue", p)
    sys.tell_key("bomb", "Faster", p)
    wait(1)
    frame = frame + 1
    if page.pressed("bomb", p) then frame = (frame // 60 + 1) * 60 end
    answer = page.pressed("start", p)
  end
  page.close(window)
  return answer
end

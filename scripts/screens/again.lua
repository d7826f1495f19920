-- screens/again.lua - asks after a game whether to play it again with the same choices.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local W <const>, H <const> = 24, 9 -- cells of the window

-- run: the game that ended. Returns true to play again.
return function(run)
  page.begin()
  local col, row = page.col + (page.cols - W) // 2, page.row + (page.rows - H) // 2
  local window = page.window(col, row, W, H)
  for age = 0, page.GROWING do
    page.grow(window, age)
    page.tell(page.SELECT)
    wait(1)
  end
  page.centre(row + 1, run.clear and "All Clear" or "Game Over", hud.banks.bright)
  page.rule(row + 2.5, W, col + 1, W - 2)
  local items = { text.lang("Restart"), text.lang("Quit to Title") }
  local i = page.list { items = items, row = row + 4.5, col = col, cols = W, back = 2, keys = page.SELECT, front = true }
  page.close(window)
  page.done()
  return i == 1
end

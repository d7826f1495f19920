-- screens/scores.lua - the score table. mark is a row to show bright. Over when somebody presses, or after so many
-- frames.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local page = sys.read("menu/page")

local RANKS = 10 -- rows of the table

return function(name, over, mark)
  page.begin()
  local rows, row = score.rows(name), math.max(1, hud.rows // 2 - RANKS - 2)
  page.centre(row, text.lang("BEST OF %s"):format(menu.label(name)), hud.banks.bright)
  for i = 1, RANKS do
    local r = rows[i] or { name = "--------", score = 0 }
    local line = ("%2d %-8s %09d"):format(i, r.name, r.score)
    local bank = i == mark and "bright" or rows[i] and "plain" or "faint"
    page.centre(row + 1 + 2 * i, line, hud.banks[bank])
  end
  wait(1)
  local answered = wait_until(page.accepted, over)
  page.done()
  return answered
end

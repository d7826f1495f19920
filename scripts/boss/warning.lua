-- boss/warning.lua - the band that announces a boss: its title between two rows of WARNING that run to and fro.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local BAND <const> = 8  -- rows
local OPENS <const> = 16 -- frames the band takes to open, and to close
local PACE <const> = 3  -- frames a letter

local COL <const>, COLS <const> = hud.place.col, hud.place.cols
local ROW <const> = (rom.field.y + rom.field.h // 2) // 8 - BAND // 2

-- n characters of s from the i-th on.
local function part(s, i, n) return s:sub(utf8.offset(s, i), (utf8.offset(s, i + n) or #s + 1) - 1) end

return function(b)
  local word = text.lang("WARNING")
  local letters = utf8.len(word)
  local row = (word .. "  "):rep(COLS // (letters + 2) + 2)
  local tidy <close> = setmetatable({}, { __close = function() text.clear { col = COL, row = ROW, w = COLS, h = BAND } end })
  hud.banner() -- the stage's name would stand across the band
  sys.cue("warning")
  for t = 1, b.warning do
    local open = math.min(t, b.warning - t + 1, OPENS)
    local cols, step = COLS * open // OPENS, t // PACE % (letters + 2)
    local from = COL + (COLS - cols) // 2
    if open < OPENS then text.clear { col = COL, row = ROW, w = COLS, h = BAND } end
    if t % PACE == 0 or open < OPENS then
      hud.put(from, ROW, part(row, 1 + step, cols), hud.banks.alarm)
      hud.put(from, ROW + BAND - 1, part(row, letters + 3 - step, cols), hud.banks.alarm)
    end
    if open == OPENS and t % OPENS == 0 then
      local bank = t // OPENS % 2 == 0 and hud.banks.plain or hud.banks.alarm
      hud.put(COL + COLS // 2 - letters, ROW + 2, word, bank, 2)
      hud.centre(ROW + 5, b.title, hud.banks.bright, COL, COLS)
    end
    wait(1)
  end
end

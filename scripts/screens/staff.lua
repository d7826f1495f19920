-- screens/staff.lua - the staff roll: it scrolls if the board has lines of text; otherwise each part is a page.
local sys = ... -- functions for the standard library only; documented in src/script/api/api_sys.c
local page = sys.read("menu/page")

local ROW = 12       -- px from one row to the next
local GAP = 28       -- px between parts
local SPEED = 0.5    -- px a frame
local FASTER = 4     -- times as fast while fire is held
local STAY = 240     -- frames that a page is shown

local function over() return page.pressed("start") end

local function hurried() return pad.down("fire", 1) or pad.down("fire", 2) end

-- The rows of a roll: text, y from its top, bank. Returns its height, too.
local function rows_of(parts)
  local rows, y = {}, 0
  for _, part in ipairs(parts) do
    for i, s in ipairs(part) do
      rows[#rows + 1] = { text = s, y = y, bank = i == 1 and hud.banks.bright or hud.banks.plain }
      y = y + ROW + (i == 1 and #part > 1 and 4 or 0)
    end
    y = y + GAP
  end
  return rows, y - GAP
end

local function put_line(row)
  row.line = text.line {
    x = page.x, y = rom.screen.h, text = text.lang(row.text), align = "center", bank = row.bank, screen = true,
    full_width = true,
  }
end

-- Only the lines on the screen exist.
local function roll(parts)
  local rows, height = rows_of(parts)
  local first, last, y = 1, 0, 0
  while y < height + rom.screen.h + 2 * ROW and not over() do
    while rows[last + 1] and rows[last + 1].y <= y do
      last = last + 1
      put_line(rows[last])
    end
    for i = first, last do
      rows[i].line.y = rom.screen.h + rows[i].y - y
      if rows[i].line.y < -ROW then
        rows[i].line:remove()
        first = i + 1
      end
    end
    wait(1)
    y = y + SPEED * (hurried() and FASTER or 1)
  end
  for i = first, last do rows[i].line:remove() end
end

local function show_page(part)
  local row = page.row + (page.rows - 2 * #part) // 2
  local age = 0
  while age < STAY do
    for i, s in ipairs(part) do
      local bank = page.bank(i, age, i == 1 and hud.banks.bright or hud.banks.plain)
      if bank then page.centre(row + 2 * (i - 1), s, bank) end
    end
    wait(1)
    if over() then return false end
    age = age + (hurried() and FASTER or 1)
  end
  text.clear()
  return true
end

-- parts: a list of { heading, name, ... } each. START ends the roll; fire makes it faster.
return function(parts)
  page.begin()
  if sys.on("text.line") then
    roll(parts)
  else
    for _, part in ipairs(parts) do
      if not show_page(part) then break end
    end
  end
  page.done()
end

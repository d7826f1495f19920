-- main.lua - the test card. It shows:
--   every colour except column 0, one row per bank; the letter F plain, mirrored, upside down, and both; sixteen rotations of
--   an arrow, and one arrow that keeps turning; a box that crosses the screen one pixel per frame; boxes clipped at every
--   edge and corner; the complete font in three banks; every button of both players, bright while held.

local BUTTONS = { "up", "down", "left", "right", "fire", "bomb", "focus", "special", "start", "select" }
local SHORT = { "UP", "DN", "LT", "RT", "FI", "BO", "FO", "SP", "ST", "SE" }
local HELD, FREE, DIM = 3, 6, 13 -- banks of text

bullet.def("arrow", { sprite = "arrow", hit = "none", turns = true })

local function colours(x, y)
  for bank = 0, 15 do
    text.put { col = x // 8 - 2, row = y // 8 + bank, text = ("%X"):format(bank) }
    for shade = 1, 15 do sprite.put { sprite = "shade" .. shade, x = x + 8 * (shade - 1), y = y + 8 * bank, bank = bank } end
  end
end

local function flips(x, y)
  for i = 0, 3 do
    local s = sprite.put { sprite = "letter", x = x + 20 * i, y = y, bank = i + 1 }
    s.flip_x, s.flip_y = i % 2 == 1, i > 1
  end
end

local function turns(x, y)
  for i = 0, 15 do
    bullet.fire { kind = "arrow", x = x + 26 * (i % 5), y = y + 26 * (i // 5), dir = 22.5 * i, speed = 0, bank = i % 8 }
  end
  return bullet.fire { kind = "arrow", x = x + 26 * 3, y = y + 26 * 3, dir = 0, speed = 0, bank = 1 }
end

-- Boxes whose centres circle just inside and outside the screen's border, so that each is clipped in every way.
local function clipped()
  local boxes, w, h = {}, rom.screen.w, rom.screen.h
  local places = { { 0, 0 }, { w // 2, 0 }, { w, 0 }, { w, h // 2 }, { w, h }, { w // 2, h }, { 0, h }, { 0, h // 2 } }
  for i, at in ipairs(places) do
    boxes[i] = { x = at[1], y = at[2], sprite = sprite.put { sprite = "box", x = at[1], y = at[2], bank = i - 1, screen = true } }
  end
  return boxes
end

local function round(boxes, frame)
  for i, b in ipairs(boxes) do
    b.sprite.x = b.x + 10 * angle.cos(3 * frame + 45 * i)
    b.sprite.y = b.y + 10 * angle.sin(3 * frame + 45 * i)
  end
end

local function font(row)
  for k, bank in ipairs { 0, 3, 10 } do
    for line = 0, 2 do
      local s = ""
      for c = 32 + 37 * line, math.min(32 + 37 * line + 36, 140) do
        if c ~= 127 then s = s .. string.char(c) end
      end
      text.put { col = 2, row = row + 3 * (k - 1) + line, text = s, bank = bank }
    end
  end
end

local function pads(row)
  for p = 1, 2 do
    text.put { col = 2, row = row + p - 1, text = "P" .. p, bank = FREE }
    for i, button in ipairs(BUTTONS) do
      local bank = pad.down(button, p) and HELD or DIM
      text.put { col = 2 + 3 * i, row = row + p - 1, text = SHORT[i], bank = bank }
    end
  end
end

text.put { col = 2, row = 0, text = "CURTAIN TEST CARD" }
colours(32, 16)
flips(184, 24)
local spin = turns(184, 50)
sprite.put { sprite = "steps", x = 270, y = 24 }
local mover = sprite.put { sprite = "box", x = 0, y = 140, bank = 4 }
font(18)

task.go(function()
  local boxes = clipped()
  for frame = 0, forever do
    text.put { col = 30, row = 0, text = ("%8d"):format(frame), bank = FREE }
    spin:turn(2)
    mover.x = frame % (rom.screen.w + 32) - 16
    round(boxes, frame)
    pads(27)
    wait(1)
  end
end)

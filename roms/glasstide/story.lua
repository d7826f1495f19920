-- story.lua - pictures with words under them, which come out of the dark and go into it again. The opening and the
-- endings are told so. FIRE goes on to the next, START leaves.
local story = {}

local FADE <const> = 36   -- frames from black, and to it
local LETTER <const> = 2  -- frames before each letter
local STAYS <const> = 170 -- frames that all of the words stand
local MIDDLE <const> = 108 -- y of the picture's
local DOWN <const> = 25   -- row of the first words, below the picture
local APART <const> = 2

-- Everything but what the words are written in: those are never dark.
local FIRST <const>, LAST <const> = 8 * 16, 255

local function taken(button) return pad.take(button, 0, 1) or pad.take(button, 0, 2) end

-- Waits so many frames; true: somebody is done with this picture. left: set where somebody leaves.
local function rest(frames, told)
  for _ = 1, frames do
    if taken("start") then told.left = true end
    if told.left or taken("fire") then return true end
    wait(1)
  end
  return false
end

local function dark(over)
  palette.fade { to = 0x04060e, over = over, first = FIRST, last = LAST }
end

-- The words, a letter after the other. True: somebody did not wait for them.
local function write(lines, told)
  local row = DOWN
  for _, line in ipairs(lines) do
    local words, hurried = text.lang(line), false
    for i = 1, utf8.len(words) do
      local bytes = utf8.offset(words, i + 1) - 1
      if not hurried and i % 2 == 0 then hurried = rest(LETTER, told) end
      if told.left then return true end
      if not hurried or bytes == #words then story.put(row, words, bytes) end
    end
    row = row + APART * #hud.wrap(words, hud.cols - 2)
  end
  return false
end

-- The first bytes of a text, in rows as if all of it stood there.
function story.put(row, words, bytes)
  for _, s in ipairs(hud.wrap(words, hud.cols - 2)) do
    local part = s:sub(1, math.max(0, bytes))
    text.put { col = 1, row = row, text = part, bank = 3 }
    bytes, row = bytes - #s - 1, row + APART
  end
end

-- What hides the field: a plate of the screen's size, in the darkest colour there is.
local function cloth()
  return sprite.plate { x = -8, y = -8, w = rom.screen.w + 16, h = rom.screen.h + 16, bank = 13 }
end

-- scenes: a list of { picture, palette?, lines }. Returns true when it was seen to its end.
function story.tell(scenes)
  local told = { left = false }
  local behind = cloth()
  for _, scene in ipairs(scenes) do
    if told.left then break end
    palette.load(scene.palette or "story")
    dark(0)
    text.clear()
    local picture = sprite.put { sprite = scene.picture, x = rom.screen.w // 2, y = MIDDLE, screen = true,
                                 layer = "over" }
    palette.fade { to = scene.palette or "story", over = FADE }
    local _ = rest(FADE, told) or told.left or write(scene.lines, told)
    if not told.left then rest(STAYS, told) end
    dark(FADE // 2)
    wait(FADE // 2)
    picture:remove()
  end
  behind:remove()
  text.clear()
  palette.load("main")
  return not told.left
end

return story

-- story.lua - pictures with words under them, which come out of the dark and go into it again.
-- The opening and the endings are told so. FIRE goes on to the next, START leaves.
local story = {}

local FADE <const> = 36   -- frames from black, and to it
local LETTER <const> = 2  -- frames before each letter
local STAYS <const> = 170 -- frames that all of the words stand
local MIDDLE <const> = 108 -- y of the picture's
local DOWN <const> = 25   -- row of the first words, below the picture
local APART <const> = 2   -- rows from one line to the next
local WORDS <const> = 3   -- their bank

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

-- The words, a letter after the other; each line stands in a row. A line in a hurry is there at
-- once.
local function write(lines, told)
  for i, line in ipairs(lines) do
    local words, hurried = text.lang(line), false
    local row = DOWN + APART * (i - 1)
    for n = 1, utf8.len(words) do
      if not hurried and n % 2 == 0 then
        hurried = rest(LETTER, told)
        local there = words:sub(1, utf8.offset(words, n + 1) - 1)
        text.put { col = 1, row = row, text = there, bank = WORDS }
      end
    end
    if told.left then return end
    text.put { col = 1, row = row, text = words, bank = WORDS }
  end
end

-- Behind the pictures is nothing: a layer that has a map, so that no sea comes there, and hides it.
bg.def("nothing", function()
  palette.load("story")
  bg.layer(1).map, bg.layer(1).hidden = "water", true
end)

local telling = false

-- Is something told now?
function story.telling() return telling end

-- scenes: a list of { picture, palette?, lines }. Returns true when it was seen to its end.
function story.tell(scenes)
  local told = { left = false }
  telling = true
  local over <close> = setmetatable({}, { __close = function() telling = false end })
  bg.show("nothing", { over = 0 })
  wait(1)
  for _, scene in ipairs(scenes) do
    if told.left then break end
    palette.load(scene.palette or "story")
    dark(0)
    text.clear()
    local picture = sprite.put { sprite = scene.picture, x = rom.screen.w // 2, y = MIDDLE,
                                 screen = true, layer = "over" }
    palette.fade { to = scene.palette or "story", over = FADE }
    rest(FADE, told)
    if not told.left then write(scene.lines, told) end
    if not told.left then rest(STAYS, told) end
    dark(FADE // 2)
    wait(FADE // 2)
    picture:remove()
  end
  text.clear()
  palette.load("main")
  return not told.left
end

return story

-- story.lua - pictures with text below them, which fade in from dark and out again, for the opening
-- and the endings. FIRE shows the next picture, START skips the rest.
local story = {}

local FADE <const> = 36   -- frames of a fade from dark; half of it to dark
local LETTER <const> = 2  -- frames before each letter
local STAYS <const> = 170 -- frames that the complete text stays
local MIDDLE <const> = 108 -- y of the picture's centre
local DOWN <const> = 25   -- row of the first line, below the picture
local APART <const> = 2   -- rows from one line to the next
local WORDS <const> = 3   -- the bank of the text

-- All colours except those of the text, which never darkens.
local FIRST <const>, LAST <const> = 8 * 16, 255

local function taken(button) return pad.take(button, 0, 1) or pad.take(button, 0, 2) end

-- Waits; returns true if a player skips this picture. Sets told.left if one skips the rest.
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

-- The cells that a line takes: one and a half for each full-width letter.
local function cells(line)
  local n = 0
  for _, code in utf8.codes(line) do n = n + (code >= 0x2e80 and 1.5 or 1) end
  return n
end

-- Writes the lines letter by letter, each in the middle of its own row. FIRE completes the
-- current line immediately.
local function write(lines, told)
  for i, line in ipairs(lines) do
    local words, hurried = text.lang(line), false
    local row, col = DOWN + APART * (i - 1), (hud.cols - cells(words)) / 2
    for n = 1, utf8.len(words) do
      if not hurried and n % 2 == 0 then
        hurried = rest(LETTER, told)
        local there = words:sub(1, utf8.offset(words, n + 1) - 1)
        text.put { col = col, row = row, text = there, bank = WORDS, full_width = true }
      end
    end
    if told.left then return end
    text.put { col = col, row = row, text = words, bank = WORDS, full_width = true }
  end
end

-- The background behind the pictures: a hidden layer, whose map keeps sea.lua from showing the sea.
bg.def("nothing", function()
  palette.load("story")
  bg.layer(1).map, bg.layer(1).hidden = "water", true
end)

local telling = false

-- Is a story playing?
function story.telling() return telling end

-- scenes: a list of { picture, palette?, lines }. Returns true if it played to the end.
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

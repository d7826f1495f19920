-- screens/music.lua - the music room: a list of pieces; fire plays one. The music before resumes at the end.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local LONG <const> = 60 * 60 * 10 -- frames without input after which the page closes while a piece plays
local KEYS <const> = { "fire", "Play", "bomb", "Back" }
local NOTE <const> = hud.glyph(144, "*")

local function title_of(m)
  return m.title and m.title ~= "" and text.lang(m.title) or menu.label(m.name)
end

-- list: { name, title?, text?, needs? } each. Returns after bomb, or if nobody presses a button for long.
return function(list)
  local items, closed, notes = {}, {}, page.low and 2 or 5
  local first -- how to unlock the first of those that are closed
  local closes = sys.read("boot/records").closed
  local playing, on, chosen
  for i, m in ipairs(list) do
    local hint = closes(m.needs)
    closed[i] = hint and page.how_to_unlock(hint) or false
    first = first or hint and hint ~= "" and "? ? ?: " .. text.lang(hint)
    items[i] = hint and "? ? ?" or title_of(m)
  end
  local function note(i, row)
    if playing then row = page.text(row, NOTE .. " " .. title_of(list[playing]), hud.banks.bright) end
    local line = closed[i] or list[i].text
    row = line and page.text(row, line) or row
    if first and not closed[i] and not page.low then page.text(row, first, hud.banks.faint) end
  end
  local function stop(fade) if on then sys.music_back(list[playing].name, fade) end end
  local back <close> = setmetatable({}, { __close = function() stop(30) end })
  repeat
    chosen = page.ask("Music", {
      items = items, chosen = chosen or 1, notes = notes, note = note, closed = closed, limit = playing and LONG or nil,
      keys = KEYS,
    })
    if chosen then
      stop(0)
      playing, on = chosen, sys.music_on(list[chosen].name)
    end
  until not chosen
end

-- screens/mode.lua - which of the game's modes.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local page = sys.read("menu/page")

-- modes: a list of { name, text?, closed? }. Returns the name of one; nil: back.
return function(modes)
  local items, closed = {}, {}
  for i, mode in ipairs(modes) do
    items[i], closed[i] = mode.closed and "? ? ?" or menu.label(mode.name), mode.closed
  end
  local function note(i, row)
    local words = modes[i].text
    if words then page.text(row, words) end
  end
  local i = page.ask("MODE", { items = items, closed = closed, note = note, notes = 6 })
  return i and modes[i].name
end

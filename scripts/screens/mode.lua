-- screens/mode.lua - which of the game's modes.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

-- modes: a list of { name, text?, closed? }. Returns the name of one; nil: back.
return function(modes)
  local items, words, closed = {}, {}, {}
  for i, mode in ipairs(modes) do
    items[i], closed[i] = mode.closed and "? ? ?" or menu.label(mode.name), mode.closed
    words[i] = mode.text
  end
  local function note(i, row)
    if words[i] then page.text(row, words[i]) end
  end
  local i = page.ask("MODE", { items = items, closed = closed, note = note, notes = page.notes(words, #modes) })
  return i and modes[i].name
end

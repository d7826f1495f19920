-- screens/difficulty.lua - how hard it is to be.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local page = sys.read("menu/page")

-- names: easiest first; present: the one to begin at; texts: what boot.run says of some, by name. Returns one; nil:
-- back.
return function(names, present, texts)
  local items, chosen = {}, 1
  for i, name in ipairs(names) do
    items[i] = menu.label(name)
    if name == present then chosen = i end
  end
  local function note(i, row)
    local words = texts[names[i]]
    if words then page.text(row, words) end
  end
  return names[page.ask("DIFFICULTY", { items = items, chosen = chosen, note = note, notes = 6 }) or 0]
end

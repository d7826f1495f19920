-- screens/difficulty.lua - how hard it is to be.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

-- names: easiest first; present: the one to begin at; texts: what boot.run says of some, by name. Returns one; nil:
-- back.
return function(names, present, texts)
  local items, words, chosen = {}, {}, 1
  for i, name in ipairs(names) do
    items[i], words[i] = menu.label(name), texts[name]
    if name == present then chosen = i end
  end
  local function note(i, row)
    if words[i] then page.text(row, words[i]) end
  end
  local rows = page.notes(words, #names)
  return names[page.ask("DIFFICULTY", { items = items, chosen = chosen, note = note, notes = rows }) or 0]
end

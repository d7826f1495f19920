-- menu.lua - a list to choose from, in front of any picture. The screens of a game are in screens/, a file each;
-- boot.lua decides when each is shown.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local menu = {}

-- A declared name as text: "late_wave" is "Late Wave".
function menu.label(name)
  return text.lang((name:gsub("_", " "):gsub("^%l", string.upper):gsub(" %l", string.upper)))
end

-- Shows a list to choose from: items, row, and optionally title, chosen, p (the player who chooses), limit (frames),
-- back (the result of bomb; false: bomb does nothing). Returns the number chosen, or nil for bomb or if nobody answers.
function menu.choose(a) return sys.read("menu/choose")(a) end

return menu

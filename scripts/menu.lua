-- menu.lua - a list to choose from, in front of any picture. The screens of a game stand in screens/, one piece each;
-- boot.lua says when each is shown.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local menu = {}

-- A declared name as a line of text: "rose_red" is ROSE RED.
function menu.label(name) return text.lang((name:gsub("_", " "):upper())) end

-- Shows a list to choose from: items, row, and if wanted title, chosen, p (whose switches), limit (frames), back (the
-- number bomb answers; false: bomb does nothing). Returns the number chosen, or nil for bomb or when nobody answers.
function menu.choose(a) return sys.read("menu/choose")(a) end

return menu

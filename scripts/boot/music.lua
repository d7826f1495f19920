-- boot/music.lua - the music of screens: each piece of boot.run's `music` plays over what was before while its screen is
-- shown, the title's until a game begins. And the list of the music room.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

-- "clear" and "over" are the last words of a game, which are no screen, and the opening is a function of the game's.
local SCREENS <const> = {
  "title", "mode", "difficulty", "ship", "results", "name", "ending", "staff", "scores", "history", "unlocks", "missions",
  "mission", "clear", "over", "room", "opening",
}

local FADE <const> = 30 -- frames

local function check(list)
  local known = {}
  for _, name in ipairs(SCREENS) do known[name] = true end
  for _, key in ipairs(sys.keys(list)) do
    local song = list[key]
    if type(key) ~= "number" and not known[key] then
      sys.fail("boot.run", ('unknown music screen "%s"%s'):format(tostring(key), sys.hint(tostring(key), SCREENS)))
    end
    if type(key) ~= "number" and key ~= "room" then sys.check("boot.run music", { name = song }) end
  end
end

-- f with that piece over what was before.
local function with(song, f)
  return function(...)
    local on = sys.music_on(song, FADE)
    local back <close> = setmetatable({}, { __close = function() if on then sys.music_back(song, FADE) end end })
    return f(...)
  end
end

-- The list of the music room; nil: there is none.
local function room(list)
  local pieces, title, rows = sys.pieces(), {}, {}
  if list.room and #list > 0 then sys.fail("boot.run", "music: expected `room = true` or a list of pieces, got both") end
  if list.room then return pieces end
  for _, m in ipairs(pieces) do title[m.name] = m.title end
  for i = 1, #list do
    local m = list[i]
    if type(m) ~= "table" then
      sys.fail("boot.run", ('music: entry %d: expected a table such as { name = "tide" }, got a %s'):format(i, type(m)))
    end
    rows[i] = sys.check("boot.run music", m)
    rows[i].title = rows[i].title or title[rows[i].name]
  end
  return rows[1] and rows
end

-- a: of boot.run; a.screens and a.ending are those with music then, and a.music is the room's list.
return function(a)
  local list, own = a.music, a.screens or {}
  local screens = setmetatable({}, { __index = own })
  check(list)
  for i = 2, #SCREENS - 4 do
    local name = SCREENS[i]
    if list[name] then
      screens[name] = with(list[name], function(...) return (own[name] or sys.read("screens/" .. name))(...) end)
    end
  end
  for _, word in ipairs { "clear", "over" } do
    screens[word] = list[word] and function() music.play(list[word], { fade = FADE }) end
  end
  screens.title = list.title and function(...)
    music.play(list.title, { fade = FADE })
    return (own.title or sys.read("screens/title"))(...)
  end
  if list.opening and a.opening then a.opening = with(list.opening, a.opening) end
  if list.ending and type(a.ending) == "function" then
    a.ending = with(list.ending, a.ending)
  else
    for _, e in ipairs(a.ending or {}) do
      local song = e.music or list.ending
      if e.music then sys.check("boot.run music", { name = e.music }) end
      if song then e.show = with(song, e.show) end
    end
  end
  a.music, a.screens = room(list), screens
end

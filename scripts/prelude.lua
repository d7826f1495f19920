-- prelude.lua - functions without a table: wait_until, wait_for, by_difficulty.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local FEW = 12 -- names that an error lists at most

-- The end of an error about a word that is not in the list: the nearest word, or all of them if they are few.
function sys.hint(word, list)
  local near = sys.near(word, list)
  if near then return (' (did you mean "%s"?)'):format(near) end
  if #list == 0 then return " (known: none)" end
  return #list <= FEW and (" (known: %s)"):format(table.concat(list, ", ")) or ""
end

-- Stops the run because of an unknown name and suggests the nearest known one. what: a noun, or "where: noun"; of: as
-- in sys.fail.
function sys.unknown(api, what, word, list, of)
  local where, noun = what:match("^(.*: )(.*)$")
  sys.fail(api, ('%sunknown %s "%s"%s'):format(where or "", noun or what, word, sys.hint(word, list)), of)
end

local function wait_until(f, limit)
  local left = sys.check("wait_until", f, limit).limit or forever
  wait(0) -- fails in an event handler, also if f() is true at once
  if sys.skipping() then return true end -- a stage that skips to a mark doesn't wait
  while not f() do
    if left == 0 then return false end
    wait(1)
    left = left - 1
  end
  return true
end

-- Dead things stay dead, so waiting for each in turn waits for all of them.
local function wait_for(...)
  local list = { ... }
  for i = 1, select("#", ...) do
    if not sys.is_waitable(list[i]) then
      sys.fail("wait_for", ("argument %d: expected a task, a movement or a thing, got %s"):format(i, type(list[i])))
    end
  end
  wait(0)
  if sys.skipping() then return end
  for _, h in ipairs(list) do
    while h.alive do wait(1) end
  end
end

-- A list with the easiest difficulty's value first -> a table by difficulty names.
local function named(values, names)
  if #values > #names then
    sys.fail("by_difficulty", ("got %d values for %d difficulties"):format(#values, #names))
  end
  local by_name = {}
  for _, i in ipairs(sys.keys(values)) do by_name[names[i] or i] = values[i] end
  return by_name
end

-- Returns the value of the current difficulty or of the nearest easier one that has a value; if none has, the value of
-- the nearest harder one.
local function by_difficulty(values)
  local names, value, reached = sys.difficulties(), nil, false
  if sys.loading() then
    sys.fail("by_difficulty", "no difficulty is chosen while scripts load; call this function during the game")
  end
  if type(values) ~= "table" then sys.fail("by_difficulty", "expected a table, got " .. type(values)) end
  if values[1] ~= nil then values = named(values, names) end
  local known = {}
  for _, name in ipairs(names) do known[name] = true end
  for _, name in ipairs(sys.keys(values)) do
    if not known[name] then sys.unknown("by_difficulty", "difficulty", tostring(name), names) end
  end
  for _, name in ipairs(names) do
    if values[name] ~= nil then value = values[name] end
    if name == board.difficulty() then reached = true end
    if reached and value ~= nil then return value end
  end
  sys.fail("by_difficulty", "expected at least one value")
end

return { wait_until = wait_until, wait_for = wait_for, by_difficulty = by_difficulty }

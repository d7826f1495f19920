-- bg.lua - bg.def and bg.show: named backgrounds, and the fade from one to the next. The board stores which one is
-- shown (sys.bg_shown), so a new game starts without a background.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local scenes = {} -- number -> function
local names = {}  -- number -> name
local numbers = {} -- name -> number
local task_of     -- the task of the background that is shown; it may have ended
local coming      -- the task that waits for the middle of a fade
local next_one    -- the number of the background that it will show

function bg.def(name, f)
  local a = sys.check("bg.def", name, f)
  if numbers[a.name] then sys.fail("bg.def", ('background "%s" is declared twice'):format(a.name)) end
  local n = #names + 1
  names[n], scenes[n], numbers[a.name] = a.name, a.f, n
end

local function change(n, dark)
  wait(dark)
  if task_of then task.stop(task_of) end
  task_of = sys.task()
  coming = nil
  sys.bg_clear()
  sys.bg_shown(n)
  if n > 0 then scenes[n]() end
end

-- at_once: shown immediately, without a fade; also while a stage skips to a practice mark.
local function show(n, over, at_once)
  if coming then task.stop(coming) end
  next_one = n
  if at_once or sys.skipping() then return sys.turn(task.go(change, n, 0)) end
  coming = task.go(change, n, sys.bg_fade(over))
end

function bg.show(name, args)
  local a = sys.check("bg.show", name, args)
  if a.name and not numbers[a.name] then sys.unknown("bg.show", "background", a.name, names) end
  show(a.name and numbers[a.name] or 0, a.over)
end

-- For boss.lua: shows a background, given by name or number, and returns the number of the one before. `what` and `of`
-- (the boss) are for the error about an undeclared name. A background never fades to itself. at_once: no fade.
function sys.backdrop(name, what, at_once, of)
  local before = coming and task.alive(coming) and next_one or sys.bg_shown()
  if what and not numbers[name] then sys.unknown("boss.def", what, name, names, of) end
  local n = numbers[name] or name
  if n ~= before then show(n, 30, at_once) end
  return before
end

return bg

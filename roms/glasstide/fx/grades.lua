-- fx/grades.lua - what a stage is worth in a letter: who was never hit and kept the bombs has an S,
-- and a sign that was broken cleanly makes up for a bomb.
local before = { {}, {} } -- of each player, what had been counted when the stage began

local function counted(p) return { misses = p.misses, used = p.used, captures = p.captures } end

on.stage(function(_, state)
  if state == "start" then player.each(function(p) before[p.index] = counted(p) end) end
end)

return function(_, p)
  local was = before[p.index]
  local function since(what) return (p[what] or 0) - (was[what] or 0) end
  local lost = 3 * since("misses") + math.max(0, since("used") - since("captures"))
  local place = lost <= 0 and 1 or lost <= 3 and 2 or lost <= 9 and 3 or 4
  return ("sabc"):sub(place, place):upper()
end

-- fx/grades.lua - the grade for a stage. No hits and no bombs earn an S; each captured sign makes
-- up for one bomb.
local before = { {}, {} } -- per player: the counts at the start of the stage

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

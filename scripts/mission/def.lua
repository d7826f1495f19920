-- mission/def.lua - checks the arguments of mission.def, except names, which may be declared later.
local sys = ...

local function fail(...) sys.fail("mission.def", (...):format(select(2, ...))) end

local function check_piece(m)
  if (m.stage == nil) == (m.boss == nil) then fail("expected either stage (and mark, to) or boss (and phase)") end
  if m.boss and (m.mark or m.to) then fail("%s: only with stage", m.mark and "mark" or "to") end
  if m.stage and m.phase then fail("phase: only with boss") end
end

-- Returns whether there is at least one.
local function check_counts(m, field)
  local there = false
  for _, name in ipairs(sys.keys(m[field] or {})) do
    if type(name) ~= "string" or math.type(m[field][name]) ~= "integer" then
      fail("%s: expected { NAME = n, .. } with whole numbers", field)
    end
    there = true
  end
  return there
end

local function check_goal(m)
  local t = type(m.goal)
  if t ~= "nil" and t ~= "table" and t ~= "function" then
    fail("goal: expected { NAME = n, .. } or a function, got %s", math.type(m.goal) or t)
  end
  if t == "table" and not check_counts(m, "goal") then fail("goal: expected { NAME = n, .. }, got none") end
  if not m.goal and not m.clear then fail("expected a goal, or clear = true") end
end

local function check_medals(m, stars)
  if not m.medals then return end
  for _, v in ipairs(m.medals) do
    if math.type(v) ~= "integer" then fail("medals: expected whole numbers, got %s", math.type(v) or type(v)) end
  end
  if #m.medals ~= stars - 1 then fail("medals: expected %d values, got %d", stars - 1, #m.medals) end
end

return function(m, stars)
  check_piece(m)
  check_goal(m)
  check_counts(m, "registers")
  check_medals(m, stars)
  return m
end

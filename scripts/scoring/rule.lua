-- scoring/rule.lua - checks the arguments of score.rule. Returns the rule's event, or its own name.
local sys = ...

local function fail(...) sys.fail("score.rule", (...):format(select(2, ...))) end

local function what(v) return type(v) == "string" and '"' .. v .. '"' or math.type(v) or type(v) end

local function formula(a, field)
  local t = type(a[field])
  if t ~= "nil" and t ~= "number" and t ~= "string" and t ~= "function" then
    fail("%s: expected a number, a register or a function, got %s", field, what(a[field]))
  end
end

local function registers(a, field, kind, expected)
  for _, name in ipairs(sys.keys(a[field] or {})) do
    local v = a[field][name]
    if type(name) ~= "string" or (math.type(v) or type(v)) ~= kind then
      fail("%s: expected %s, got %s", field, expected, type(name) == "string" and what(v) or what(name))
    end
  end
end

local function kind(a, of)
  if not a.kind then return end
  if not of then fail("kind: only for kill, graze and take") end
  for _, k in ipairs(sys.kinds(of)) do
    if k == a.kind then return end
  end
  sys.unknown("score.rule", of .. " kind", a.kind, sys.kinds(of))
end

return function(a, events)
  if (a.on == nil) == (a.name == nil) then fail("expected either on (an event) or name (for score.count)") end
  if a.on and events[a.on] == nil or a.name and events[a.name] ~= nil then
    local list = {}
    for name in pairs(events) do list[#list + 1] = name end
    if a.name then fail('name: "%s" is an event; write on = "%s"', a.name, a.name) end
    sys.unknown("score.rule", "event", a.on, list)
  end
  kind(a, a.on and events[a.on])
  formula(a, "points")
  formula(a, "times")
  registers(a, "gain", "integer", "{ REGISTER = n, .. }, whole numbers")
  registers(a, "set", "integer", "{ REGISTER = n, .. }, whole numbers")
  registers(a, "most", "string", "{ REGISTER = name, .. }, of another")
  local own = a.on == "kill" or a.on == "take"
  if a.times and not a.points and not own then fail("points: a required argument is missing (the event has none of its own)") end
  if not (a.points or a.times or a.gain or a.set or a.most) then fail("expected one of points, times, gain, most, set") end
  return a.on or a.name
end

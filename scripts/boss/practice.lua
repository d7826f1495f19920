-- boss/practice.lua - the phase of a boss by its id.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

return function(api, b, id, of)
  local ids = {}
  for i, phase in ipairs(b.phases) do
    if phase.id == id then return phase end
    ids[i] = phase.id
  end
  sys.unknown(api, "phase", id, ids, of)
end

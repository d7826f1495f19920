-- boss/history.lua - boss.history: how often a phase with a spell was fought and captured.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

return function(find, name, id, args)
  local a = sys.check("boss.history", name, id, args)
  sys.read("boss/practice")("boss.history", find("boss.history", a.name), a.id) -- fails over an id that there is not
  if a.difficulty then
    local known = sys.difficulties()
    for i, one in ipairs(known) do known[one] = i end
    if not known[a.difficulty] then sys.unknown("boss.history", "difficulty", a.difficulty, known) end
  end
  return sys.history(a.name, a.id, 0, a.difficulty, a.ship)
end

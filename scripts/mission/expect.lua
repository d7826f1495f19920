-- mission/expect.lua - fails unless everything that missions name is declared: sections, ships, difficulties, counts.
local sys = ...

-- of: the mission with the name.
local function one_of(of, what, name, list)
  for _, known in ipairs(list) do
    if known == name then return end
  end
  sys.unknown("mission.def", what, name, list, of)
end

-- The counts that a goal can use, with any of these ships.
local function counts(kinds)
  local list, known = { "score", "grazes", "lives", "frames", "kills" }, {}
  for _, kind in ipairs(kinds) do
    for _, r in ipairs(sys.ship(kind).registers) do
      if not known[r.name] then list[#list + 1] = r.name end
      known[r.name] = true
    end
  end
  return list
end

return function(list, a)
  for _, m in ipairs(list) do
    m.start = sys.read("boot/piece")("mission.def", m, m.name)
    if m.ship then one_of(m.name, "ship", m.ship, a.kinds) end
    if m.difficulty then one_of(m.name, "difficulty", m.difficulty, sys.difficulties()) end
    local known = counts(m.ship and { m.ship } or a.kinds)
    for name in pairs(type(m.goal) == "table" and m.goal or {}) do one_of(m.name, "count", name, known) end
    for name in pairs(m.registers or {}) do one_of(m.name, "register", name, known) end
    if m.by ~= "time" then one_of(m.name, "count", m.by, known) end
    if m.needs then
      if not rawget(sys, "unlock") then sys.unknown("mission.def", "unlock", m.needs, {}, m.name) end
      sys.unlock.closed(m.needs, "mission.def", m.name)
    end
  end
end

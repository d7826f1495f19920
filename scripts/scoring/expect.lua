-- scoring/expect.lua - fails unless every register that rules and the tally name exists on some ship.
local sys = ...

return function(rules, lines, registers)
  local known = {}
  for _, name in ipairs(registers) do known[name] = true end
  local function expect(of, name)
    if not known[name] then sys.unknown(of.api, "register", name, registers, of.at) end
  end
  for _, list in pairs(rules) do
    for _, r in ipairs(list) do
      for _, field in ipairs { "points", "times" } do
        if type(r[field]) == "string" then expect(r, r[field]) end
      end
      for _, field in ipairs { "gain", "most", "set" } do
        for name, v in pairs(r[field] or {}) do
          expect(r, name)
          if field == "most" then expect(r, v) end
        end
      end
    end
  end
  for _, line in ipairs(lines) do
    if type(line.value) == "string" then expect(line, line.value) end
  end
end

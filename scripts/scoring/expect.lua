-- scoring/expect.lua - fails unless some ship has each register that rules and tally name.
local sys = ...

return function(rules, lines, registers)
  local known = {}
  for _, name in ipairs(registers) do known[name] = true end
  local function expect(api, name)
    if not known[name] then sys.unknown(api, "register", name, registers) end
  end
  for _, list in pairs(rules) do
    for _, r in ipairs(list) do
      for _, field in ipairs { "points", "times" } do
        if type(r[field]) == "string" then expect("score.rule", r[field]) end
      end
      for _, field in ipairs { "gain", "most", "set" } do
        for name, v in pairs(r[field] or {}) do
          expect("score.rule", name)
          if field == "most" then expect("score.rule", v) end
        end
      end
    end
  end
  for _, line in ipairs(lines) do
    if type(line.value) == "string" then expect("score.tally", line.value) end
  end
end

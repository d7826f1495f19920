-- scoring/tally.lua - the lines of score.tally, checked.
local sys = ...

return function(list)
  local lines = {}
  for i = 1, #list do
    local entry = list[i]
    local line = sys.check("score.tally line", entry)
    local t = type(line.value)
    if t ~= "string" and t ~= "function" then
      sys.fail("score.tally", ("line %d: value: expected a property, a register or a function, got %s"):format(i, t))
    end
    line.api, line.at = "score.tally", ""
    lines[i] = line
  end
  if #lines == 0 then sys.fail("score.tally", 'expected at least one line, such as { label = "Bombs", value = "bombs", points = 1000 }') end
  return lines
end

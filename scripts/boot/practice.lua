-- boot/practice.lua - what a practice start begins with.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each

-- practice is "boss/phase", "stage" or "stage:mark". Returns a function that starts that part in a scope owned by
-- `owner`, and returns the scope. Names are checked at once, while the game loads.
local function part(practice)
  local name, phase = practice:match("^([^/]*)/(.*)$")
  if name then
    local fight = boss.practice("boot.run", name, phase)
    return function(owner)
      local scope = task.scope(owner)
      task.own(scope, function()
        fight()
        task.stop(scope)
      end)
      return scope
    end
  end
  local stage_name, mark = practice:match("^([^:]*):(.*)$")
  stage_name = stage_name or practice
  stage.expect("boot.run", stage_name)
  return function(owner)
    if not mark then sys.mark("start", "") end -- with a mark, stage.mark says so when the stage is there
    return stage.play(stage_name, owner, mark)
  end
end

local function expect_registers(kind, with)
  local names, known = {}, {}
  for i, r in ipairs(sys.ship(kind).registers) do names[i], known[r.name] = r.name, true end
  for _, r in ipairs(with.registers) do
    if not known[r.name] then
      sys.fail("--register", ('ship "%s" has no register "%s"%s'):format(kind, r.name, sys.hint(r.name, names)))
    end
  end
end

-- The function that starts that part in a game, or nil: the cabinet asks for the list.
return function(a, practice)
  expect_registers(a.players[1], a.with)
  if practice ~= "?" then return part(practice) end
end

-- boot/piece.lua - a part of a game that practice or a mission plays alone.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local function fight(owner, f, ended)
  local scope = task.scope(owner)
  task.own(scope, function()
    local won = f()
    if ended then ended(won) end
    task.stop(scope)
  end)
  return scope
end

-- what: stage, and optionally mark, where it starts, and to, the mark that ends it; or boss, and optionally phase and
-- search, the stages in which the fight may be: the first that has it shows its scene. Returns a function that starts that part in a scope
-- owned by `owner` and returns the scope; ended(won) is called when a fight is over. Names of stages, bosses and phases
-- are checked at once, while the game loads; api and of: as for sys.fail.
return function(api, what, of)
  if what.boss then
    local f = boss.practice(api, what.boss, what.phase, of, what.search)
    return function(owner, ended) return fight(owner, f, ended) end
  end
  stage.expect(api, what.stage, of)
  return function(owner)
    if not what.mark then sys.mark("start", "") end -- with a mark, stage.mark says so when the stage is there
    return stage.play(what.stage, owner, what.mark, what.to)
  end
end

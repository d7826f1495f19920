-- unlock/earn.lua - whether a run earns an unlock. run.stage: the stage just cleared, nil at the end of the run;
-- cleared: cleared stages by name; clear: all stages are cleared; mode, difficulty, continues; ships and scores, by
-- player.

-- Returns a difficulty's index, easiest first.
local function grade(sys, name)
  for i, n in ipairs(sys.difficulties()) do
    if n == name then return i end
  end
end

local function captured(spell)
  local _, captures = boss.history(spell:match("^(.-)/(.*)$"))
  return captures > 0
end

local sys = ...

local function heard(name)
  for _, m in ipairs(sys.pieces()) do
    if m.name == name then return m.heard end
  end
end

return function(when, run)
  if type(when) == "function" then return not run.stage and when(run) == true end
  local c = when.clear
  if run.stage and not (type(c) == "string" or when.spell or when.heard) then return false end
  if c == true and not run.clear or type(c) == "string" and not run.cleared[c] then return false end
  if when.mode and when.mode ~= run.mode or when.continues and run.continues > when.continues then return false end
  if when.difficulty and grade(sys, run.difficulty) < grade(sys, when.difficulty) then return false end
  if when.spell and not captured(when.spell) then return false end
  if when.heard and not heard(when.heard) then return false end
  for p, ship in ipairs(run.ships) do
    if (not when.ship or when.ship == ship) and run.scores[p] >= (when.score or 0) then return true end
  end
  return false
end

-- boot/list.lua - the list of what can be practised, for the cabinet.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local TOLD = 12 -- sys.mark calls in one frame: fewer than the board can hand out

-- True if the text of a practice start ("boss/phase", "stage:mark") can hold the name: short enough, plain characters,
-- and none that `except`, a Lua pattern, matches.
local function startable(name, except) return #name < 32 and not name:find("[^ -~]") and not name:find(except) end

-- A function that does what sys.mark does, and waits a frame when the frame is full.
local function teller()
  local told = 0
  return function(...)
    if told == TOLD then
      wait(1)
      told = 0
    end
    told = told + 1
    sys.mark(...)
  end
end

local function tell_ship(tell, kind)
  local ship = sys.ship(kind)
  tell("ship", kind, "", "", ship.lives)
  for _, r in ipairs(ship.registers) do
    if r.show ~= "none" and startable(r.name, "=") then tell("register", r.name, "", "", r.value) end
  end
end

local function tell_boss(tell, b)
  if not startable(b.name, "/") then return end
  tell("boss", b.name, "", b.title)
  for _, phase in ipairs(b.phases) do
    if startable(phase.id, "\0") then tell("phase", phase.id, b.name, phase.spell) end
  end
end

-- Stages run through as they would be played, so in a game with its ship.
local function tell_marks(tell, a, name, enter, leave)
  local scope = enter { a.kinds[1] }
  local marks, whole = stage.run_through(name, scope)
  leave(scope, 1)
  for _, mark in ipairs(marks) do
    if startable(mark, "/") then tell("point", mark, name) end
  end
  if not whole then print(('stage "%s" waits for ever when it is skipped: marks after that are not known'):format(name)) end
end

-- All ships, the one that practice is played with first; registers are of that one.
local function tell_ships(tell, kinds)
  tell_ship(tell, kinds[1])
  for i = 2, #kinds do
    if startable(kinds[i], "@") then tell("ship", kinds[i], "", "", sys.ship(kinds[i]).lives) end
  end
end

-- First what is known without running anything: a stage that runs through may fault, and then the list ends there.
return function(a, enter, leave)
  local tell, stages = teller(), {}
  tell_ships(tell, a.kinds)
  for _, name in ipairs(stage.names(a.stages)) do
    if startable(name, "[:/]") then
      tell("stage", name)
      stages[#stages + 1] = name
    end
  end
  boss.each(function(b) tell_boss(tell, b) end)
  for _, name in ipairs(stages) do tell_marks(tell, a, name, enter, leave) end
  tell("listed", "") -- the list is complete
end

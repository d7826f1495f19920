-- boss.lua - a boss is an enemy, or a cast of several, with phases, each with hp, a clock and a task. A phase has a
-- scene: an owner of every task that the phase starts and every enemy and sprite it makes. When the phase ends, the
-- scene is stopped and the board removes all of these. The scene of a single boss belongs to that boss and ends with
-- it; when the fight's task is stopped, the enemies are removed.
--
-- This file is always loaded. Fights, and parts that only some bosses need, are in the files boss/NAME.lua, which are
-- read when a fight begins.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local boss = {}

local bosses = {} -- name -> definition; its cast is a list, of one that is alone itself
local names = {}  -- in the order they were declared

-- What goes on: task, the one that fights, which may be stopped at any time, and name, its boss; status, of the fight,
-- nil before and between: boss; team, its enemies; left, phases to come; phase, the one that runs, or nil; began, when;
-- missed, its bonus is lost; hit, it ended a last phase; worth(), its bonus; rows, which draws it; verdict, what the
-- phase that ended was worth, until it is shown. tune, song: the boss's music and the phase's, over what was before.
local now = {}

-- A death or a bomb: no bonus and no capture for what is left of the phase.
local function miss()
  if now.status then now.status.missed = true end
end

function boss.def(name, def)
  local b = sys.check("boss.def", name, def)
  if bosses[b.name] then sys.fail("boss.def", ('boss "%s" is declared twice'):format(b.name)) end
  if #names == 0 then on.death(miss) on.bomb(miss) end
  if sys.boss(b) then now.last = now.last or sys.read("boss/last") end
  sys.note_place("boss.def", b.name)
  bosses[b.name] = b
  names[#names + 1] = b.name
end

local function find(api, name, of)
  if not bosses[name] then sys.unknown(api, "boss", name, names, of) end
  return bosses[name]
end

function boss.fight(name, args)
  local a = sys.check("boss.fight", name, args)
  local b = find("boss.fight", a.name)
  if stage.skipping() then
    stage.stop_at(a.name)
    sys.pass() -- counts as a wait passed over, as in stage.lua
    sys.music_fight(b.music, b.warning)
    return true
  end
  return sys.read("boss/fight")(now, b, b.phases, a)
end

function boss.now()
  local status = boss.status()
  if not (status and status.phase) then return nil end
  return status.boss.name, status.phase.id, sys.clock() - status.began
end

function boss.history(name, id, args) return sys.read("boss/history")(find, name, id, args) end

-- The rest is for the pieces, hud.lua and boot.lua.

-- nil: there is no fight, or nobody is left in it.
function boss.status()
  if not now.status then return end
  for _, e in ipairs(now.status.team) do
    if e.alive then return now.status end
  end
end

-- Draws the fight's rows in the HUD; hides them if `hidden`. again: draws everything, even if it hasn't changed.
-- has_dialogue: the lower edge is covered, so the boss isn't marked there.
function boss.draw(hidden, again, has_dialogue)
  if not now.rows then return end
  now.rows(not hidden and boss.status() or nil, again, now.verdict, has_dialogue)
  now.verdict = nil
  if not now.task then now.rows = nil end
end

-- Calls f(boss) for all of them, as they were declared: name, title, phases.
function boss.each(f)
  for _, name in ipairs(names) do f(bosses[name]) end
end

-- A function that fights one phase alone, or without an id all of them, with neither warning nor talks. search: stages;
-- the first that has this fight shows its scene.
function boss.practice(api, name, id, of, search)
  local b = find(api, name, of)
  local phases = id and { sys.read("boss/practice")(api, b, id, of) } or b.phases
  return function()
    if search then stage.search(search, name) end
    sys.mark("start", "")
    return sys.read("boss/fight")(now, b, phases)
  end
end

return boss

-- boss.lua - a boss is an enemy with phases, each with hp, a clock and a task. A phase has a scene: an owner of every
-- task that the phase starts and every enemy and sprite it makes. When the phase ends, the scene is stopped and the
-- board removes all of these. The scene belongs to the enemy, so it also ends with that; and when the task that fights
-- is stopped, the enemy is removed.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local boss = {}

local ABOVE = -48  -- y of the place above the field where a boss comes from and leaves to
local FLIGHT = 60  -- frames its way in or out takes

local bosses = {}  -- name -> definition
local names = {}   -- in the order they were declared
local busy         -- task, the task that fights now, and name, its boss; that task may be stopped at any time
local status       -- what the hud shows of the fight: enemy, title, spell, hp, ends, left; nil between fights

local function checked(entry, ids)
  local phase = sys.check("boss.def phase", entry)
  if ids[phase.id] then sys.fail("boss.def", ('phase "%s" is there twice'):format(phase.id)) end
  if not (phase.hp or phase.survive) then
    sys.fail("boss.def", ('phase "%s": hp: expected a whole number, got nil'):format(phase.id))
  end
  ids[phase.id] = true
  if phase.clear then phase.clear = sys.check("boss.def clear", phase.clear) end
  if phase.drops then phase.drops = sys.drops("boss.def", phase.drops) end
  return phase
end

function boss.def(name, def)
  local b, phases, ids = sys.check("boss.def", name, def), {}, {}
  if not sys.loading() then sys.fail("boss.def", "a boss is declared while scripts load, not later") end
  if bosses[b.name] then sys.fail("boss.def", ('boss "%s" is declared twice'):format(b.name)) end
  if #b.phases == 0 then sys.fail("boss.def", "phases: expected at least one phase") end
  for i, entry in ipairs(b.phases) do phases[i] = checked(entry, ids) end
  b.phases = phases
  bosses[b.name] = b
  names[#names + 1] = b.name
end

local function find(api, name)
  if not bosses[name] then sys.unknown(api, "boss", name, names) end
  return bosses[name]
end

-- For <close>: calls f when the block ends, or the task does.
local function at_end(f) return setmetatable({}, { __close = f }) end

local function spawn(b)
  local e = enemy.spawn { kind = b.kind, x = b.x, y = ABOVE }
  sys.hold(e, true) -- makes it undying: at 0 hp a phase ends, but the boss does not die
  e.safe = forever
  return e
end

local function fly_in(b, e)
  e:move { x = b.x, y = b.y, over = FLIGHT, ease = "out" }
  wait(FLIGHT)
end

local function leave(e, beaten)
  sys.hold(e, false) -- it can die again
  if beaten then return e:kill() end
  e:move { x = e.x, y = ABOVE, over = FLIGHT, ease = "in" }
  wait(FLIGHT)
  e:remove()
end

-- bg.lua is there if the game declares a background.
local function backdrop(b, phase)
  local what = ('boss "%s": phase "%s": background'):format(b.name, phase.id)
  if not rawget(sys, "backdrop") then sys.unknown("boss.def", what, phase.bg, {}) end
  return sys.backdrop(phase.bg, what)
end

-- True if the phase was beaten. The fight's task is older than the phase's, so it gets its turn first and stops the
-- phase before that runs again.
local function play(b, e, phase)
  e.hp = phase.hp or 1
  e.safe = phase.survive and forever or 0
  sys.mark("phase", phase.id, b.name, phase.spell)
  local before = phase.bg and backdrop(b, phase)
  local scene = sys.scene(e) -- owned by the boss; what the phase makes belongs to it
  task.own(scene, function() phase.run(e) end)
  wait_until(function() return not e.alive or e.hp <= 0 end, phase.time)
  local won = e.alive and (phase.survive or e.hp <= 0)
  task.stop(scene)
  if before then sys.backdrop(before) end
  local left = phase.clear or {}
  bullet.clear { all = true, spark = left.spark, items = won and left.items or nil }
  if won and phase.drops and e.alive then sys.drop(phase.drops, e.x, e.y) end
  if e.alive then e.x = e.x end -- ends the move it makes
  e.safe = forever
  if won and phase.bonus > 0 then
    player.each(function(p) score.add(phase.bonus, p) end)
  end
  sys.mark(won and "won" or "lost", phase.id, b.name)
  sys.emit("phase", e, phase.id, won)
  return won
end

-- One boss at a time: a phase's end clears the field, and the hud shows one clock.
local function claim(b)
  if busy and task.alive(busy.task) then
    sys.fail("boss.fight", ('boss "%s": "%s" is fighting; two fights at once are not there yet'):format(b.name, busy.name))
  end
  busy = { task = sys.task(), name = b.name }
end

-- True if every phase was beaten. A boss whose last phase was not beaten leaves instead of dying.
local function fight(b, phases)
  claim(b)
  sys.mark("boss", b.name, "", b.title)
  local e, all, won = spawn(b), true, false
  local field <close> = at_end(function() -- when the fight is cut short too
    e:remove()
    busy, status = nil, nil
  end)
  fly_in(b, e)
  for i, phase in ipairs(phases) do
    local spell = phase.spell and text.lang(phase.spell)
    status = { enemy = e, title = text.lang(b.title), spell = spell, left = #phases - i,
               hp = not phase.survive and phase.hp, ends = sys.clock() + phase.time }
    won = play(b, e, phase)
    all = all and won
    status.spell, status.hp, status.ends = nil, nil, nil
    if i < #phases and phase.rest > 0 then
      e:move { x = b.x, y = b.y, over = phase.rest, ease = "both" }
      wait(phase.rest)
    end
    if not e.alive then
      all = false -- a script took it off the field
      break
    end
  end
  status = nil
  if e.alive then leave(e, won) end
  return all
end

function boss.fight(name)
  local b = find("boss.fight", sys.check("boss.fight", name).name)
  if stage.skipping() then
    sys.pass() -- counts as a wait passed over, as in stage.lua
    return true
  end
  local s = stage.stop_clock()
  local clock <close> = at_end(function() if s then stage.start_clock(s) end end)
  return fight(b, b.phases)
end

-- The rest is for hud.lua and boot.lua.

function boss.status() return status and status.enemy.alive and status or nil end

-- Calls f(boss) for all of them, as they were declared: name, title, phases.
function boss.each(f)
  for _, name in ipairs(names) do f(bosses[name]) end
end

-- A function that fights one phase alone.
function boss.practice(api, name, id)
  local b, ids = find(api, name), {}
  for i, phase in ipairs(b.phases) do
    if phase.id == id then
      return function()
        sys.mark("start", "")
        return fight(b, { phase })
      end
    end
    ids[i] = phase.id
  end
  sys.unknown(api, "phase", id, ids)
end

return boss

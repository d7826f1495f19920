-- boss.lua - a boss is an enemy, or a cast of several, with phases, each with hp, a clock and a task. A phase has a scene:
-- an owner of every task that the phase starts and every enemy and sprite it makes. When the phase ends, the scene is
-- stopped and the board removes all of these. One boss's scene belongs to it, so it also ends with that; and when the
-- task that fights is stopped, the enemies are removed.
--
-- What only some bosses need stands in pieces, boss/NAME.lua, which boss.def reads.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local boss = {}

local ABOVE = -48  -- y of the place above the field where a boss comes from and leaves to
local FLIGHT = 60  -- frames its way in or out takes

local bosses = {}  -- name -> definition; its cast is a list, of one that is alone itself
local names = {}   -- in the order they were declared
local extras = {}  -- the pieces that were read, by name
local busy         -- task, the task that fights now, and name, its boss; that task may be stopped at any time
local status       -- of the fight, for the pieces: boss; team, its enemies; left, phases to come; phase, the one that
                   -- runs, or nil; began, when; missed, the bonus is lost; hit, it ended a last phase; nil between fights
local verdict      -- what the phase that ended was worth, until it is shown

-- A death or a bomb: no bonus and no capture for what is left of the phase.
local function miss()
  if status then status.missed = true end
end

function boss.def(name, def)
  local b = sys.check("boss.def", name, def)
  if bosses[b.name] then sys.fail("boss.def", ('boss "%s" is declared twice'):format(b.name)) end
  if #names == 0 then on.death(miss) end
  for _, piece in ipairs(sys.boss(b)) do extras[piece] = extras[piece] or sys.read("boss/" .. piece) end
  bosses[b.name] = b
  names[#names + 1] = b.name
end

local function find(api, name)
  if not bosses[name] then sys.unknown(api, "boss", name, names) end
  return bosses[name]
end

-- For <close>: calls f when the block ends, or the task does.
local function at_end(f) return setmetatable({}, { __close = f }) end

-- The first of the team that is on the field; nil: nobody is.
local function lead(team)
  for _, e in ipairs(team) do
    if e.alive then return e end
  end
end

local function spawn(m)
  local e = enemy.spawn { kind = m.kind, x = m.x, y = ABOVE }
  sys.hold(e, true) -- makes it undying: at 0 hp a phase ends, but the boss does not die
  e.safe = forever
  return e
end

-- Everybody goes home, or straight up and out.
local function gather(b, team, over, ease, out)
  for i, m in ipairs(b.cast) do
    local e = team[i]
    if e.alive then e:move { x = out and e.x or m.x, y = out and ABOVE or m.y, over = over, ease = ease } end
  end
  wait(over)
end

local function leave(b, team, beaten)
  for _, e in ipairs(team) do
    sys.hold(e, false) -- it can die again
    if beaten then e:kill() end
  end
  if not beaten then gather(b, team, FLIGHT, "in", true) end
end

-- bg.lua is there if the game declares a background.
local function backdrop(b, phase)
  local what = ('boss "%s": phase "%s": background'):format(b.name, phase.id)
  if not rawget(sys, "backdrop") then sys.unknown("boss.def", what, phase.bg, {}) end
  return sys.backdrop(phase.bg, what)
end

-- Starts what the phase runs; returns the scene of it, and the function that tells when its bars are down. The fight's
-- task is older than the phase's, so it gets its turn first and stops the phase before that runs again.
local function begin(b, team, phase)
  local e = team[1]
  for _, each in ipairs(team) do each.safe = phase.survive and forever or phase.safe end
  if #team > 1 then return extras.cast(b, team, phase) end
  e.hp = phase.hp or 1
  local scene = sys.scene(e) -- owned by the boss; what the phase makes belongs to it
  task.own(scene, function() phase.run(e) end)
  return scene, function() return e.hp <= 0 end
end

-- What the running phase is worth now.
function boss.bonus()
  local phase = status.phase
  if not phase.bonus_to then return phase.bonus end
  return phase.bonus - (phase.bonus - phase.bonus_to) * math.min(sys.clock() - status.began, phase.time) // phase.time
end

local function tidy(team, phase, won)
  local left, e = phase.clear or {}, lead(team)
  bullet.clear { all = true, spark = left.spark, items = won and left.items or nil }
  if won and phase.drops then sys.drop(phase.drops, e.x, e.y) end
  for _, each in ipairs(team) do
    if each.alive then each.x = each.x end -- ends the move it makes
    each.safe = forever
  end
end

-- True if the phase was beaten.
local function play(b, team, phase)
  sys.mark("phase", phase.id, b.name, phase.spell)
  status.phase, status.began, status.missed, status.hit = phase, sys.clock(), false, false
  local before = phase.bg and backdrop(b, phase)
  local scene, down = begin(b, team, phase)
  if phase.armour > 0 then extras.armour(team, phase, scene) end
  if phase.cut_in then extras.cut_in(b, phase, scene) end
  if phase.spell then sys.history(b.name, phase.id, 1) end
  wait_until(function() return not lead(team) or status.hit or down() end, phase.time)
  local won = lead(team) ~= nil and not status.hit and (phase.survive or down())
  local captured = won and not status.missed
  task.stop(scene)
  if before then sys.backdrop(before) end
  tidy(team, phase, won)
  if phase.bonus > 0 then
    local n = captured and boss.bonus()
    if n then player.each(function(p) score.add(n, p) end) end
    verdict = { bonus = n, spell = phase.spell }
  end
  if captured and phase.spell then sys.history(b.name, phase.id, 2) end
  status.phase = nil
  sys.mark(won and "won" or "lost", phase.id, b.name)
  sys.emit("phase", lead(team) or team[1], phase.id, won, captured)
  return won
end

-- One boss at a time: a phase's end clears the field, and the hud shows one clock.
local function claim(b)
  if busy and task.alive(busy.task) then
    sys.fail("boss.fight", ('boss "%s": "%s" is fighting; for two at once declare one boss with cast = { ... }')
      :format(b.name, busy.name))
  end
  busy = { task = sys.task(), name = b.name }
end

-- True if every phase was beaten. A boss whose last phase was not beaten leaves instead of dying. alone: a phase of it is
-- practised, without warning and talks.
local function fight(b, phases, alone)
  claim(b)
  local team, all, won = {}, true, false
  local field <close> = at_end(function() -- when the fight is cut short too
    for _, e in ipairs(team) do e:remove() end
    busy, status = nil, nil
  end)
  if b.warning > 0 and not alone then extras.warning(b) end
  sys.mark("boss", b.name, "", b.title)
  for i, m in ipairs(b.cast) do team[i] = spawn(m) end
  gather(b, team, FLIGHT, "out")
  status = { boss = b, team = team }
  for i, phase in ipairs(phases) do
    if lead(team) and (all or not phase.last) then
      if phase.talk and not alone then extras.talk(phase.talk, team) end
      status.left = #phases - i
      won = play(b, team, phase)
      all = all and won
      local after = phases[i + 1] or b
      if (after ~= b and (all or not after.last) or after.talk and not alone) and phase.rest > 0 then
        gather(b, team, phase.rest, "both")
      end
    end
  end
  if b.talk and not alone and lead(team) then extras.talk(b.talk, team) end
  all = all and lead(team) ~= nil -- nil: a script took it off the field
  leave(b, team, won)
  return all
end

function boss.fight(name, args)
  local a = sys.check("boss.fight", name, args)
  local b = find("boss.fight", a.name)
  if stage.skipping() then
    sys.pass() -- counts as a wait passed over, as in stage.lua
    return true
  end
  local s = not a.clock and stage.stop_clock()
  local clock <close> = at_end(function() if s then stage.start_clock(s) end end)
  return fight(b, b.phases)
end

function boss.history(name, id, args) return sys.read("boss/history")(find, name, id, args) end

-- The rest is for the pieces, hud.lua and boot.lua.

-- nil: there is no fight, or nobody is left in it.
function boss.status() return status and lead(status.team) and status end

-- Draws the fight from that row of the screen on; `again`: all of it.
function boss.draw(row, again)
  if extras.rows then extras.rows(boss.status(), row, again, verdict) end
  verdict = nil
end

-- Calls f(boss) for all of them, as they were declared: name, title, phases.
function boss.each(f)
  for _, name in ipairs(names) do f(bosses[name]) end
end

-- A function that fights one phase alone.
function boss.practice(api, name, id)
  local phase = sys.read("boss/practice")(api, find(api, name), id)
  return function()
    sys.mark("start", "")
    return fight(bosses[name], { phase }, true)
  end
end

return boss

-- boss/fight.lua - a fight, from the boss's way in to its end. boss.fight and practice read it; so what only a fight needs
-- takes no memory in between.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local ABOVE = -48 -- y of the place above the field where a boss comes from and leaves to
local FLIGHT = 60 -- frames its way in or out takes

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

-- On its way in it leaves sparks behind it, and where it stops a ring of them.
local function trail(b, team)
  for age = 1, FLIGHT do
    for _, e in ipairs(team) do
      if e.alive and age == FLIGHT then
        spark.burst { kind = b.entrance, from = e, n = 24, radius = 16, speed = 2.5 }
      elseif e.alive and age % 2 == 0 then
        spark.burst { kind = b.entrance, from = e, n = 4, speed = 1.2 }
      end
    end
    wait(1)
  end
end

local function leave(b, team, beaten)
  for _, e in ipairs(team) do
    sys.hold(e, false) -- it can die again
    if beaten then e:kill() end
  end
  if not beaten then gather(b, team, FLIGHT, "in", true) end
end

-- bg.lua is there if the game declares a background. what: whose it is; nil: the boss's own.
local function backdrop(b, name, what, at_once)
  what = ('boss "%s": %sbackground'):format(b.name, what and ('phase "%s": '):format(what) or "")
  if not rawget(sys, "backdrop") then sys.unknown("boss.def", what, name, {}, b.name) end
  return sys.backdrop(name, what, at_once, b.name)
end

-- Starts what the phase runs; returns the scene of it, and the function that tells when its bars are down. The fight's
-- task is older than the phase's, so it gets its turn first and stops the phase before that runs again.
local function begin(b, team, phase)
  local e = team[1]
  for _, each in ipairs(team) do each.safe = phase.survive and forever or phase.safe end
  if #team > 1 then return sys.read("boss/cast")(b, team, phase) end
  e.hp = phase.hp or 1
  local scene = sys.scene(e) -- owned by the boss; what the phase makes belongs to it
  task.own(scene, function() phase.run(e) end)
  return scene, function() return e.hp <= 0 end
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

-- True if the phase was beaten. after: the one that comes next, or nil; all: those before were beaten; alone: it is
-- practised.
local function play(now, b, team, phase, after, all, alone)
  local status = now.status
  sys.mark("phase", phase.id, b.name, phase.spell)
  status.phase, status.began, status.missed, status.hit = phase, sys.clock(), false, false
  local before = phase.bg and (now.before or backdrop(b, phase.bg, phase.id)) -- that of the phase before may stay
  if phase.music and not now.song then now.song = sys.music_on(phase.music, not alone and 0 or nil) and phase.music end
  local armour = phase.armour > 0 and sys.read("boss/armour")(team, phase)
  local scene, down = begin(b, team, phase)
  if phase.cut_in then sys.read("boss/cut_in")(b, phase, scene) end
  if phase.spell then
    sys.cue("spell")
    sys.history(b.name, phase.id, 1)
  end
  wait_until(function() return not lead(team) or status.hit or down() end, phase.time)
  local won = lead(team) ~= nil and not status.hit and (phase.survive or down())
  local captured = won and not status.missed
  task.stop(scene)
  if armour then task.stop(armour) end
  local comes = after and (not after.last or all and won) and after
  local stands = comes and comes.bg == phase.bg
  if before and not stands then sys.backdrop(before) end
  now.before = stands and before or nil
  if now.song and not (comes and comes.music == phase.music) then
    sys.music_back(now.song)
    now.song = nil
  end
  tidy(team, phase, won)
  if phase.bonus > 0 then
    local n = captured and status.worth()
    if n then
      sys.cue("bonus")
      player.each(function(p) score.add(n, p) end)
    end
    now.verdict = { bonus = n, spell = phase.spell }
  end
  if captured and phase.spell then sys.history(b.name, phase.id, 2) end
  status.phase = nil
  sys.mark(won and "won" or "lost", phase.id, b.name)
  sys.emit("phase", lead(team) or team[1], phase.id, won, captured)
  return won
end

-- One boss at a time: a phase's end clears the field, and the hud shows one clock.
local function claim(now, b)
  if now.task and task.alive(now.task) then
    sys.fail("boss.fight", ('boss "%s": "%s" is still fighting; for two bosses at once, declare one with `cast = { .. }`')
      :format(b.name, now.name))
  end
  now.task, now.name = sys.task(), b.name
  now.rows = now.rows or sys.read("boss/rows")
end

-- What the running phase is worth.
local function worth_of(status)
  return function()
    local phase = status.phase
    if not phase.bonus_to then return phase.bonus end
    local age = math.min(sys.clock() - status.began, phase.time)
    return phase.bonus - (phase.bonus - phase.bonus_to) * age // phase.time
  end
end

local function talk(list, team)
  if list and lead(team) then sys.read("boss/talk")(list, team) end
end

-- The phases in order; true if the last of them was beaten, and whether all were. A last phase comes only if all before
-- it were beaten.
local function run(now, b, phases, team, alone)
  local all, won = true, false
  for i, phase in ipairs(phases) do
    if lead(team) and (all or not phase.last) then
      if not alone then talk(phase.talk, team) end
      now.status.left = #phases - i
      won = play(now, b, team, phase, phases[i + 1], all, alone)
      all = all and won
      local after = phases[i + 1]
      local on = after and (all or not after.last) or not after and b.talk and not alone
      if on and phase.rest > 0 then
        gather(b, team, phase.rest, "both")
      end
    end
  end
  if not alone then talk(b.talk, team) end
  return won, all and lead(team) ~= nil -- nil: a script took it off the field
end

-- now: of boss.lua. args: of boss.fight; nil: a phase is practised, without warning and talks. True if every phase was
-- beaten. A boss whose last phase was not beaten leaves instead of dying.
return function(now, b, phases, args)
  claim(now, b)
  local team, s = {}, not (args and args.clock) and stage.stop_clock()
  local field <close> = at_end(function() -- when the fight is cut short too
    for _, e in ipairs(team) do e:remove() end
    if s then stage.start_clock(s) end
    if now.tune then sys.music_back(now.tune) end
    if now.song then sys.music_back(now.song) end
    now.task, now.status, now.before, now.tune, now.song = nil, nil, nil, nil, nil
  end)
  local first = phases[1].bg
  if b.bg then backdrop(b, b.bg, nil, not args) end
  if first and not args then now.before = backdrop(b, first, phases[1].id, true) end -- no stage has shown anything
  if b.music then now.tune = sys.music_on(b.music, args and b.warning) and b.music end
  for i = 2, args and 0 or #b.phases do -- practised: what the phase before plays too
    local song = b.phases[i] == phases[1] and b.phases[i].music
    if song and song == b.phases[i - 1].music then now.song = sys.music_on(song) and song end
  end
  if b.warning > 0 and args then sys.read("boss/warning")(b) end
  sys.mark("boss", b.name, "", b.title)
  for i, m in ipairs(b.cast) do team[i] = spawn(m) end
  if b.entrance then task.own(sys.task(), function() trail(b, team) end) end
  gather(b, team, FLIGHT, "out")
  now.status = { boss = b, team = team }
  now.status.worth = worth_of(now.status)
  for i, m in ipairs(b.cast) do
    if m.hurt or m.broken then task.go(sys.read("boss/wounds"), b, m, team[i], now.status) end
  end
  local won, all = run(now, b, phases, team, not args)
  if lead(team) then leave(b, team, won) end
  return all
end

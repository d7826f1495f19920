-- stage.lua - a stage is one task: plain code, from top to bottom. Everything that it starts belongs to its scope and
-- stops with it.
--
-- A practice start runs the same code with `skip` set to the name of a mark. Before that mark the stage skips: stage.at
-- only sets the clock, and waves, clears and boss fights are left out.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local stage = {}

local stages = {} -- name -> function
local names = {}  -- in the order of their declarations

-- The current or last stage. name; scope: owns its tasks; base: the board's clock at the stage's frame 0; fights: the
-- number of boss fights that stop its clock; stopped: the board's clock when the first of them started; skip: the mark
-- it skips to, or nil; fight: the boss whose fight practice searches, or nil; found: that fight was reached; ends: the
-- mark at which it ends, or nil; marks: the marks reached so far, in order; met: the same by name; waves: the tasks that
-- send enemies.
local now

local function current(api)
  if not (now and task.alive(now.scope)) then sys.fail(api, "no stage is running") end
  return now
end

-- The stage's clock: frames since its start, without those of boss fights.
local function clock(s) return (s.fights > 0 and s.stopped or sys.clock()) - s.base end

function stage.def(name, f, args)
  local a = sys.check("stage.def", name, f, args)
  if not sys.loading() then sys.fail("stage.def", "declare stages while scripts load, not later") end
  if stages[a.name] then sys.fail("stage.def", ('stage "%s" is declared twice'):format(a.name)) end
  stages[a.name] = a.f
  if a.needs then
    sys.stage_needs = rawget(sys, "stage_needs") or {}
    sys.stage_needs[a.name] = a.needs
    sys.note_place("stage.def", a.name)
  end
  if a.music then
    sys.stage_music = rawget(sys, "stage_music") or {}
    sys.stage_music[a.name] = a.music
  end
  names[#names + 1] = a.name
end

-- Fails unless the stage is declared. of: as of sys.fail.
function stage.expect(api, name, of)
  if not stages[name] then sys.unknown(api, "stage", name, names, of) end
end

function stage.at(n)
  local frame, s = sys.check("stage.at", n).n, current("stage.at")
  local time = clock(s)
  if time > frame then
    sys.fail("stage.at", ("frame %d has already passed; the stage is at frame %d"):format(frame, time))
  end
  if s.skip then
    s.base = s.base - (frame - time)
    sys.music_clock(frame - time)
    -- sys.pass() counts a skipped wait; too many in one frame are a fault, so endless skipping ends.
    return sys.pass()
  end
  while clock(s) < frame do wait(frame - clock(s)) end -- repeats if a boss fight has stopped the clock
end

local function fly_wave(a)
  for i = 0, a.n - 1 do
    local dx, dy = i * a.dx, i * a.dy
    if a.place then
      local x, y = a.place(i)
      dx, dy = dx + x, dy + y
    end
    local x, y = path.place(a.path[1], a.mirror, dx, dy)
    local e = enemy.spawn { kind = a.kind, x = x, y = y, run = a.run, stay = a.stay, hp = a.hp, bank = a.bank,
                            tag = a.tag, on_death = a.on_death, drops = a.drops }
    task.own(e, path.travel, a.path, a.mirror, dx, dy)
    if i < a.n - 1 then wait(a.every) end
  end
end

function stage.wave(args)
  local a = sys.check("stage.wave", args)
  if not path.known(a.path) then sys.fail("stage.wave", "path: expected a route from path.def") end
  if a.drops then sys.check_drops("stage.wave", a.drops) end
  if a.formation then a.place = sys.read("stage/formation")(a) end
  if stage.skipping() then return sys.pass() end
  sys.mark("wave", a.kind)
  local t = task.go(fly_wave, a)
  if now then now.waves[#now.waves + 1] = t end
end

-- A wave that still sends enemies counts too: right after stage.wave, no enemy is on the field yet.
local function cleared(s)
  for i = #s.waves, 1, -1 do
    if not task.alive(s.waves[i]) then table.remove(s.waves, i) end
  end
  return #s.waves == 0 and enemy.count() == 0
end

function stage.clear(limit)
  local a, s = sys.check("stage.clear", limit), current("stage.clear")
  if s.skip then
    sys.pass()
    return true
  end
  return wait_until(function() return cleared(s) end, a.limit)
end

-- From here on the stage's task waits as usual. Removes what the stage's own code made directly, outside waves and
-- fights, while it skipped; its background and palette stay.
local function stop_skipping(s)
  s.skip = nil
  sys.skip(false)
  sys.wipe(true)
  sys.faded()
  hud.refresh()
end

function stage.mark(name)
  local a, s = sys.check("stage.mark", name), current("stage.mark")
  if not s.met[a.name] then
    s.met[a.name] = true
    s.marks[#s.marks + 1] = a.name
  end
  if s.skip and s.skip ~= a.name then return sys.pass() end
  if s.ends == a.name and not s.skip then return task.stop(s.scope) end
  sys.mark("point", a.name, s.name) -- reports an event of the run to the program; changes nothing in the game
  if not s.skip then return end
  sys.mark("start", "") -- the practice section starts here
  stop_skipping(s)
end

-- The following functions are for boss.lua and boot.lua.

function stage.skipping() return now ~= nil and task.alive(now.scope) and now.skip ~= nil end

-- Stops the clock of the current stage. Returns the stage, for stage.start_clock: when the fight ends, another stage
-- may be the current one.
function stage.stop_clock()
  if not now then return end
  if now.fights == 0 then now.stopped = sys.clock() end
  now.fights = now.fights + 1
  return now
end

function stage.start_clock(s)
  s = s or now
  if not s then return end
  s.fights = s.fights - 1
  if s.fights == 0 then s.base = s.base + sys.clock() - s.stopped end
end

local function begin(name, owner, skip)
  local songs = rawget(sys, "stage_music")
  if songs and songs[name] then music.play(songs[name]) end
  now = { name = name, scope = task.scope(owner), base = sys.clock(), fights = 0, skip = skip, marks = {}, met = {},
          waves = {} }
  return now
end

-- Starts a stage; optionally from one mark, and up to another. Returns its scope, which ends with the stage.
function stage.play(name, owner, mark, to)
  local s = begin(name, owner, mark)
  s.ends = to
  sys.emit("stage", name, "start")
  sys.mark("stage", name)
  task.own(s.scope, function()
    sys.skip(mark ~= nil) -- true: this task skips its waits
    stages[name]()
    for _, missed in ipairs { s.skip or s.ends } do sys.unknown("stage " .. name, "mark", missed, s.marks) end
    sys.mark("clear", name)
    sys.emit("stage", name, "clear")
    task.stop(s.scope)
  end)
  return s.scope
end

-- Returns all stages: those of `first`, then the others in the order of their declarations.
function stage.names(first)
  local list, there = {}, {}
  for _, from in ipairs { first, names } do
    for _, name in ipairs(from) do
      if not there[name] then list[#list + 1] = name end
      there[name] = true
    end
  end
  return list
end

-- Runs through a stage with nothing but skips, which takes a frame. Returns the marks it reached, and whether it
-- reached its end. fight: stops at the fight with this boss and stays there; then returns nil.
function stage.run_through(name, owner, fight)
  local s, whole = begin(name, owner, true), false -- true is not the name of a mark, so it skips to the end
  s.fight = fight
  task.own(s.scope, function()
    sys.skip(true)
    stages[name]()
    whole = true
  end)
  wait(1)
  if s.found then return nil end
  task.stop(s.scope)
  return s.marks, whole
end

-- Runs through these stages until one reaches the fight with this boss. That stage waits there, and its scene stays:
-- background, palette and music. If none has the fight, the screen is empty. Takes a frame for each stage.
function stage.search(list, fight)
  for _, name in ipairs(list) do
    if not stage.run_through(name, sys.task(), fight) then return end
    sys.skip(false) -- also for the music
    sys.wipe()
    if rawget(sys, "stage_music") then music.stop() end
  end
end

-- Called for a boss fight that the stage would skip: waits there if practice searches this fight.
function stage.stop_at(fight)
  if now.fight ~= fight then return end
  now.found = true
  stop_skipping(now)
  wait(forever)
end

return stage

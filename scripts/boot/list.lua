-- boot/list.lua - reports to the program what can be practised, and the titles that its screens show (PRACTICE_LIST).
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local PER_FRAME = 12 -- calls of sys.mark in a frame: fewer than the board's limit

-- True if the text of a practice start ("boss/phase", "stage:mark") can contain the name: it is short, printable ASCII,
-- and doesn't match the Lua pattern `except`.
local function startable(name, except) return #name < 32 and not name:find("[^ -~]") and not name:find(except) end

-- A function like sys.mark that waits a frame when a frame's calls are used up.
local function reporter()
  local calls = 0
  return function(...)
    if calls == PER_FRAME then
      wait(1)
      calls = 0
    end
    calls = calls + 1
    sys.mark(...)
  end
end

local function title_of(title, name) return title and text.lang(title) or menu.label(name) end

-- All ships with their registers; practice uses the first one unless the player chooses another. A form's title follows
-- its ship's.
local function report_ships(report, a)
  local titles = {}
  for _, kind in ipairs(a.players) do
    local about = a.ships and a.ships[kind] or {}
    local ship = title_of(about.title, kind)
    titles[kind] = ship
    for _, form in ipairs(about.forms or {}) do
      local title = form.title or form.kind ~= kind and form.kind
      if title then titles[form.kind] = ship .. " " .. title_of(form.title, form.kind) end
    end
  end
  for i, kind in ipairs(a.kinds) do
    if i == 1 or startable(kind, "@") then
      local ship = sys.ship(kind)
      report("ship", kind, ship.sprite, titles[kind], ship.lives)
      for _, r in ipairs(ship.registers) do
        local label = menu.label((r.label and r.label ~= "" and r.label or r.name):lower())
        if r.show ~= "none" and startable(r.name, "=") then report("register", r.name, kind, label, r.value) end
      end
    end
  end
end

local function report_names(report)
  for _, name in ipairs(sys.difficulties()) do report("difficulty", name, "", menu.label(name)) end
  local missions = rawget(sys, "missions")
  if missions then
    missions.each(function(m) report("mission", m.name, "", text.lang(m.title)) end)
  end
end

-- A boss is shown by the portrait of its first phase that has one, or by its sprite.
local function report_boss(report, b)
  if not startable(b.name, "/") then return end
  local portrait
  for _, phase in ipairs(b.phases) do portrait = portrait or phase.portrait end
  report("boss", b.name, portrait or sys.enemy_sprite(b.cast[1].kind), text.lang(b.title))
  for _, phase in ipairs(b.phases) do
    local title = phase.spell and text.lang(phase.spell) or menu.label(phase.id)
    if startable(phase.id, "\0") then report("phase", phase.id, b.name, title) end
  end
end

-- Runs through a stage, in a game with the first ship. A mark with the name of a boss has the boss's title.
local function report_marks(report, a, name, titles, enter, leave)
  local scope = enter { a.kinds[1] }
  local marks, whole = stage.run_through(name, scope)
  leave(scope, 1)
  for _, mark in ipairs(marks) do
    if startable(mark, "/") then report("point", mark, name, titles[mark] or menu.label(mark)) end
  end
  if whole then return end
  print(('stage "%s" waits for ever when it is skipped: marks after that are not known'):format(name))
end

-- Stages are run through last: one of them may fault, and then the list ends there.
return function(a, enter, leave)
  local report, stages, titles = reporter(), {}, {}
  report_ships(report, a)
  report_names(report)
  for _, name in ipairs(stage.names(a.stages)) do
    if startable(name, "[:/]") then
      report("stage", name, "", text.lang("Stage %s"):format(menu.label(name)))
      stages[#stages + 1] = name
    end
  end
  boss.each(function(b)
    report_boss(report, b)
    titles[b.name] = text.lang(b.title)
  end)
  for _, name in ipairs(stages) do report_marks(report, a, name, titles, enter, leave) end
  report("listed", "") -- the list is complete
end

-- unlock/expect.lua - fails unless everything that unlocks name is declared, and every unlock that something needs.
local sys = ...

-- of: the unlock with the name.
local function one_of(of, what, name, list)
  for _, n in ipairs(list) do
    if n == name then return end
  end
  sys.unknown("unlock.def", what, name, list, of)
end

local function spell_of(unlock, name)
  local of, id = name:match("^(.-)/(.*)$")
  if not of then
    local text = 'spell: expected "boss/id", a boss and the id of its phase, got "%s"'
    sys.fail("unlock.def", text:format(name), unlock)
  end
  local bosses, ids = {}, nil
  boss.each(function(b)
    bosses[#bosses + 1] = b.name
    if b.name ~= of then return end
    ids = {}
    for _, phase in ipairs(b.phases) do ids[#ids + 1] = phase.id end
  end)
  if not ids then sys.unknown("unlock.def", "boss", of, bosses, unlock) end
  one_of(unlock, "phase", id, ids)
end

return function(list, find, a)
  local modes = {}
  for _, m in ipairs(a.modes or {}) do modes[#modes + 1] = m.name end
  for _, u in ipairs(list) do
    local when = type(u.when) == "table" and u.when or {}
    if type(when.clear) == "string" then stage.expect("unlock.def", when.clear, u.name) end
    if when.mode then one_of(u.name, "mode", when.mode, modes) end
    if when.difficulty then one_of(u.name, "difficulty", when.difficulty, sys.difficulties()) end
    if when.ship then one_of(u.name, "player", when.ship, sys.kinds("player")) end
    if when.spell then spell_of(u.name, when.spell) end
  end
  for name, needs in pairs(rawget(sys, "stage_needs") or {}) do find("stage.def", needs, name) end
  local open = false
  for _, kind in ipairs(a.players) do
    local forms = a.ships and a.ships[kind] and a.ships[kind].forms or { { kind = kind } }
    local needs, any = sys.ship(kind).needs, false
    if needs then find("player.def", needs, kind) end
    for _, f in ipairs(forms) do
      local of_form = sys.ship(f.kind).needs
      if of_form then find("player.def", of_form, f.kind) end
      any = any or not of_form
    end
    if not needs and not any then
      sys.fail("boot.run", ("ship %s: forms: expected at least one form that needs no unlock"):format(kind))
    end
    open = open or not needs
  end
  if not open then sys.fail("boot.run", "players: expected at least one ship that needs no unlock") end
  for _, part in ipairs { a.modes or {}, a.music or {} } do
    for _, m in ipairs(part) do
      if m.needs then find("boot.run", m.needs) end
    end
  end
end

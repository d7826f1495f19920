-- boot/args.lua - checks the arguments of boot.run that every game has, while the game loads; boot/check.lua checks the
-- others.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local PLAIN <const> = { players = true, stages = true, demo = true, continues = true }

local function check_players(list)
  local kinds, known = sys.kinds("player"), {}
  for _, kind in ipairs(kinds) do known[kind] = true end
  for i = 1, #list do
    if not known[list[i] or 0] then sys.unknown("boot.run", "player", tostring(list[i]), kinds) end
  end
  if #list == 0 then sys.fail("boot.run", "players: expected at least one player, got none") end
end

local function check_stages(list)
  if not list or #list == 0 then
    sys.fail("boot.run", "stages: expected at least one stage, got " .. (list and "none" or "nil"))
  end
  for i = 1, #list do stage.expect("boot.run", tostring(list[i])) end
end

-- Returns all kinds that can be played: the ships, or their forms.
local function all_kinds(a)
  local list = {}
  for _, kind in ipairs(a.players) do
    local forms = a.ships and a.ships[kind] and a.ships[kind].forms or { { kind = kind } }
    for _, f in ipairs(forms) do list[#list + 1] = f.kind end
  end
  return list
end

-- Returns whether the game uses score rules, tallies, unlocks or missions.
local function keeps_records(a)
  for _, name in ipairs { "scoring", "unlock", "stage_needs", "missions" } do
    if rawget(sys, name) then return true end
  end
  if a.modes then return true end
  for _, kind in ipairs(a.kinds) do
    if sys.ship(kind).needs then return true end
  end
  for _, m in ipairs(a.music or {}) do
    if m.needs then return true end
  end
end

-- Returns the arguments.
return function(args)
  local a = sys.check("boot.run", args)
  check_players(a.players)
  if a.stages or not a.modes then check_stages(a.stages) end
  for key in pairs(a) do
    if not PLAIN[key] then
      sys.read("boot/check")(a)
      break
    end
  end
  a.kinds = all_kinds(a)
  if keeps_records(a) then sys.read("boot/records").expect(a) end
  a.stages = a.stages or a.modes[1].stages
  return a
end

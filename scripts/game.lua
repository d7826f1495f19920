-- game.lua - the current run: its registers, by name, and read-only facts about it.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each

local name, scope -- of the last stage played
local defined = false

local play = stage.play
function stage.play(what, ...)
  name, scope = what, play(what, ...)
  return scope
end

local read = {}
function read.stage() return scope and task.alive(scope) and name or nil end
function read.mode() return rawget(sys, "mode") end -- boot.lua sets it
function read.continues() return sys.run("continues") end
function read.frames() return sys.run("frames") end

local function unknown(field)
  local names = sys.run_names()
  for word in pairs(read) do names[#names + 1] = word end
  sys.fail("game", ('unknown field "%s"%s'):format(tostring(field), sys.hint(field, names)))
end

local function def(args)
  local a = sys.check("game.def", args)
  if defined then sys.fail("game.def", "can be called only once") end
  defined = true
  sys.run_registers(a.registers)
end

local function index(_, field)
  if read[field] then return read[field]() end
  local value = sys.run(field)
  if value == nil then unknown(field) end
  return value
end

local function newindex(_, field, value)
  if read[field] then sys.fail("game", field .. " is read-only") end
  if not sys.run_set(field, value) then unknown(field) end
end

return setmetatable({ def = def }, { __index = index, __newindex = newindex, __metatable = false })

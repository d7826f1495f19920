-- lint.lua - finds in scripts what would only show when the line runs: names nobody declared.
--
--     curtain help lua | lua5.4 lint.lua [--with LIBRARY]... FILE...
--
-- Reads the compiler's listing (luac -l -l): every access to a global, and every field taken from one. A global must be
-- one the board gives; a field of an API table must be in the help, or defined in a file of the library named by --with
-- (its files may use what they do not hand to games). No script may write a global.

local LUAC = os.getenv("LUAC") or "luac5.4"

local function set(words)
  local s = {}
  for w in words:gmatch("%S+") do s[w] = true end
  return s
end

-- What is not in the help: Lua's own part, and the constants and screens of the standard library.
local globals = set [[
  assert error ipairs pairs pcall print require select setmetatable getmetatable rawequal rawget rawset rawlen tonumber
  tostring type math string table utf8 forever hud menu
]]
local fields = {
  math = set("abs atan ceil cos floor huge max maxinteger min mininteger pi sin sqrt tan tointeger type ult " ..
    "acos asin fmod modf exp log deg rad"),
  string = set "byte char find format gmatch gsub len lower match rep reverse sub upper",
  table = set "concat insert move pack remove sort unpack",
  utf8 = set "char charpattern codepoint codes len offset",
}

for line in io.lines() do
  local space, name = line:match("^(%a[%w_]*)%.([%w_]+)")
  if space then
    globals[space] = true
    fields[space] = fields[space] or {}
    fields[space][name] = true
  else
    globals[line:match("^[%a_][%w_]*") or ""] = true
  end
end
fields.rom, fields.game = nil, nil -- they have a field for all that rom.lua and game.def say

while arg[1] == "--with" do
  for line in io.lines(arg[2]) do
    local space, name = line:gsub("^function ", ""):match("^([%a_]+)%.([%w_]+)%s*[(=]")
    if fields[space] then fields[space][name] = true end
  end
  table.remove(arg, 1)
  table.remove(arg, 1)
end

local bad = 0
local function complain(file, line, what, ...)
  print(("%s:%s: " .. what):format(file, line, ...))
  bad = bad + 1
end

local function check(file)
  local listing = assert(io.popen(("%s -l -l -p '%s' 2>&1"):format(LUAC, file)))
  local held, from -- the register that the line before filled, and the global in it
  local seen
  for text in listing:lines() do
    local line, op, args, note = text:match("^%s+%d+%s+%[(%d+)%]%s+(%u+)%s+([^;]*);?%s*(.*)")
    seen = seen or line
    local name = note and note:match('^_ENV "([%w_]+)"')
    local field = note and op == "GETFIELD" and note:match('^"([%w_]+)"')
    local a, b = (args or ""):match("^(%d+) (%d+)")
    if op == "SETTABUP" and name then complain(file, line, "writes the global %s", name) end
    if op == "GETTABUP" and name and not globals[name] then complain(file, line, "unknown name %s", name) end
    if field and b == held and fields[from] and not fields[from][field] then
      complain(file, line, "unknown name %s.%s", from, field)
    end
    held, from = nil, nil
    if op == "GETTABUP" and name then held, from = a, name end
  end
  if not listing:close() or not seen then complain(file, 0, "does not compile") end
end

if #arg == 0 then complain("lint.lua", 0, "no file given") end
for _, file in ipairs(arg) do check(file) end
os.exit(bad == 0)

/*
 * worst.c - see worst.h.
 */
#include "worst.h"
#include <string.h>

/* BODY is done once, and `n` counted, in each round. */
#define LOOP(BODY) "while true do " BODY " c.n = c.n + 1 end"
#define FOUR(BODY) LOOP(BODY " " BODY " " BODY " " BODY)

/* Two texts of N bytes that differ in the last alone. */
#define TWINS(N) "local c = ... local s = ('a'):rep(" #N " - 1) local a, b, x = s .. 'x', s .. 'y' "

const struct worst WORST[] = {
    { "nothing", 2, "local c = ... " LOOP("") },
    { "adding integers", 10, "local c, x = ..., 1 " FOUR("x = (x * 31 + 7) & 65535") },
    { "`==` of two strings of 64 KiB", 140, TWINS(65536) FOUR("x = a == b") },
    { "`==` of two strings of 4 KiB", 16, TWINS(4096) FOUR("x = a == b") },
    { "`==` of a string of 60,000 bytes and a literal", 69,
      TWINS(60000) "local f = load('local a, c = ... local x while true do x = a == \"' .. b .. '\" c.n = c.n + 1 "
                   "end') return f(a, c)" },
    { "`<` of two strings of 64 KiB", 140, TWINS(65536) FOUR("x = a < b") },
    { "`<` of two strings of 64 KiB in upvalues", 290,
      TWINS(65536) "local function f() x = a < b end local function g() " FOUR("f()") " end g()" },
    { "`t[k]` with a string of 64 KiB as the key", 95, TWINS(65536) "local t = { [s .. 'x'] = 1 } " FOUR("x = t[a]") },
    { "`<` of two strings of 32 zero bytes", 140,
      "local c, x = ... local a, b = ('\\0'):rep(32), ('\\0'):rep(32) " FOUR("x = a < b") },
    { "`<=` of two strings of 4096 zero bytes", 17000,
      "local c, x = ... local a, b = ('\\0'):rep(4096), ('\\0'):rep(4096) " FOUR("x = a <= b") },
    { "`..` of two strings of 32 KiB", 55000, TWINS(32768) FOUR("x = a .. b") },
    { "`..` of two fractions", 13, "local c, x = ... local a, b = 1.1, 2.3 " FOUR("x = a .. b") },
    { "`..` of two extreme numbers", 230, "local c, x = ... local a, b = 1.1e308, 2.3e-308 " FOUR("x = a .. b") },
    { "`..` of a string and a number that increases", 24,
      "local c, x, i = ..., 0, 0 " LOOP("i = i + 1 x = 'abc' .. i") },
    { "`%` of two extreme numbers", 94, "local c, x = ... local a, b = 1.1e308, 2.3e-308 " FOUR("x = a % b") },
    { "`%` by a tiny constant", 94, "local c, x = ... local a = 5.1 " FOUR("x = a % 2.3e-308") },
    { "`+` of a string of 64 KiB of digits", 7700, "local c, x = ... local a = ('1'):rep(65536) " FOUR("x = a + 1") },
    { "`+` of a string of 64 KiB of blanks and a digit", 7700,
      "local c, x = ... local a = (' '):rep(65535) .. '1' " FOUR("x = a + 1") },
    { "`math.floor` of a string of 64 KiB of digits", 12000,
      "local c, x = ... local a, floor = ('1'):rep(65536), math.floor " FOUR("x = floor(a)") },
    { "`tonumber` of a string of 64 KiB of digits", 60000,
      "local c, x = ... local a = ('1'):rep(65536) " FOUR("x = tonumber(a)") },
    { "reading a key through a chain of 1900 metatables", 3800,
      "local c, x = ... local t = {} for i = 1, 1900 do t = setmetatable({}, { __index = t }) end " FOUR("x = t.x") },
    { "reading a key of an upvalue through a chain of 1900 metatables", 3800,
      "local c = ... local t = {} for i = 1, 1900 do t = setmetatable({}, { __index = t }) end "
      "local function f() local x " FOUR("x = t.x") " end f()" },
    { "writing a key through a chain of 1900 metatables", 3800,
      "local c = ... local t = {} for i = 1, 1900 do t = setmetatable({}, { __newindex = t }) end " FOUR("t.x = nil") },
    { "removing a key from a full table and adding another", 37000,
      "local c = ... local t, i = {}, 1 for k = 1, 65536 do t['k' .. k] = k end "
      "while true do t['k' .. i] = nil t['k' .. i + 65536] = 1 i = i + 1 c.n = c.n + 1 end" },
    { "the same with numbers as keys", 73000,
      "local c = ... local t, i = {}, 1 for k = 1, 131072 do t[k + 0.5] = k end "
      "while true do t[i + 0.5] = nil t[i + 131072.5] = 1 i = i + 1 c.n = c.n + 1 end" },
    { "`select(\"#\", ...)` with 100,000 arguments", 6000,
      "local c, x = ... local function f(...) " LOOP("x = select('#', ...)") " end f(table.unpack({}, 1, 100000))" },
    { "passing on 100,000 arguments", 5500,
      "local c = ... local function id(...) return ... end local function f(...) " LOOP(
          "id(...)") " end "
                     "f(table.unpack({}, 1, 100000))" },
    { "`{ ... }` with 100,000 arguments", 600000,
      "local c, x = ... local function f(...) " LOOP("x = { ... }") " end f(table.unpack({}, 1, 100000))" },
    { "`s:byte(1, -1)` of 64 KiB", 46000, TWINS(65536) FOUR("x = a:byte(1, -1)") },
    { "`s:sub(2)` of 64 KiB", 55000, TWINS(65536) FOUR("x = a:sub(2)") },
    { "`s:upper()` of 64 KiB", 110000, TWINS(65536) FOUR("x = a:upper()") },
    { "`s:rep(1000)` of 65 bytes", 110000, "local c, x = ... local a = ('a'):rep(65) " FOUR("x = a:rep(1000)") },
    { "`s:find(\"y\", 1, true)` in 64 KiB", 23000, TWINS(65536) FOUR("x = a:find('y', 1, true)") },
    { "`s:gsub(\".\", \"%0\")` of 64 KiB", 200000, TWINS(65536) FOUR("x = a:gsub('.', '%0')") },
    { "`s:find(\"a*a*a*b\")` in 64 KiB", 7000000, TWINS(65536) LOOP("x = a:find('a*a*a*b')") },
    { "`(\"%.14g\"):format(1.1e308)`", 1600, "local c, x = ... " FOUR("x = ('%.14g'):format(1.1e308)") },
    { "`(\"%99.99f\"):format(1.1e308)`", 1700, "local c, x = ... " FOUR("x = ('%99.99f'):format(1.1e308)") },
    { "`tostring(1.1e308)`", 230, "local c, x = ... " FOUR("x = tostring(1.1e308)") },
    { "`utf8.len` of 64 KiB", 180000, TWINS(65536) FOUR("x = utf8.len(a)") },
    { "`table.concat` of 1000 fractions", 25000,
      "local c, x = ... local t = {} for i = 1, 1000 do t[i] = i + 0.1 end " FOUR("x = table.concat(t)") },
    { "`table.sort` of 10,000 strings", 300000,
      "local c = ... local t = {} for i = 1, 10000 do t[i] = 'k' .. i end " LOOP("table.sort(t)") },
    { "`pairs` of 10,000 strings", 290000,
      "local c, x = ... local t = {} for i = 1, 10000 do t['k' .. i] = i end " LOOP("x = pairs(t)") },
    { "`table.remove(t, 1)` of 10,000 elements", 7000,
      "local c, x = ... local t = {} for i = 1, 10000 do t[i] = i end " LOOP("x = table.remove(t, 1) t[10000] = 1") },
    { "`table.unpack` of 10,000 elements", 7000,
      "local c, x = ... local t = {} for i = 1, 10000 do t[i] = i end " LOOP("x = table.unpack(t)") },
    { "`load` of 10,000 bytes", 110000, "local c, x = ... local s = ('x=1 '):rep(2500) " LOOP("x = load(s)") },
    { "`pcall(error, \"x\")`", 86, "local c = ... local pcall, error = pcall, error " FOUR("pcall(error, 'x')") },
    { "`{}`", 54, "local c, x = ... " FOUR("x = {}") },
    { "a table constructor with 13 nils", 240,
      "local c, x = ... " FOUR("x = { nil, nil, nil, nil, nil, nil, nil, nil, nil, nil, nil, nil, nil }") },
    { "`function() end`", 40, "local c, x = ... " FOUR("x = function() return x end") },
    { "`board.note` of 64 KiB", 12000, TWINS(65536) FOUR("board.note(a)") },
    { "`board.note(1)`", 290, "local c = ... " FOUR("board.note(1)") },
    { "`rom.has`", 290, "local c = ... " FOUR("rom.has('nothing')") },
    { "`query.near` of 4096 bullets", 63000,
      "local c, x = ... " LOOP("x = query.near { x = 100, y = 100, radius = 500, what = 'bullet' }") },
    { "`bullet.group():turn(1)` of 4096 bullets", 2900, "local c = ... local g = bullet.group() " LOOP("g:turn(1)") },
    { "`bullet.group():aim()` of 4096 bullets", 2900, "local c = ... local g = bullet.group() " LOOP("g:aim()") },
    { "`bullet.each` of 4096 bullets", 27000, "local c = ... local function f() end " LOOP("bullet.each(nil, f)") },
    { "`bullet.fire` in a full pool", 290,
      "local c = ... local kind, fire = { kind = 'd8', x = 9, y = 9, speed = 0 }, bullet.fire " FOUR("fire(kind)") },
    { "reading a bullet's `x`", 5, "local c, x, b = ... bullet.each(nil, function(one) b = one end) " FOUR("x = b.x") },
    { "writing a bullet's `x`", 5, "local c, b = ... bullet.each(nil, function(one) b = one end) " FOUR("b.x = 9") },
    { "`pattern.ring` in a full pool", 20000,
      "local c = ... local ring = { kind = 'd8', x = 9, y = 9, n = 1000, speed = 1 } " LOOP("pattern.ring(ring)") },
    { "`angle.sin`", 290, "local c, x = ... " FOUR("x = angle.sin(33.3)") },
    { "`text.put` of 64 KiB", 3000, TWINS(65536) LOOP("text.put { col = 0, row = 0, text = a }") },
    { "`print` of 64 KiB", 470, TWINS(65536) FOUR("print(a)") },
    { "`rng.int`", 290, "local c, x = ... " FOUR("x = rng.int(1, 6)") },
};
const int WORST_COUNT = sizeof WORST / sizeof *WORST;

static const struct worst *running;
static const char times_key;

static int run(lua_State *L)
{
    if (luaL_loadbufferx(L, running->text, strlen(running->text), "=worst", "t") != LUA_OK)
        return lua_error(L);
    lua_createtable(L, 0, 1);
    lua_pushinteger(L, 0);
    lua_setfield(L, -2, "n");
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &times_key);
    lua_call(L, 1, 0);
    return 0;
}

uint64_t worst_run(struct board *b, const struct worst *w, const char **fault)
{
    lua_State *L = b->vm.L;

    running = w;
    vm_reset_work(b, WORST_LIMIT);
    *fault = vm_call(b, run) ? NULL : b->output->fault.message;
    lua_rawgetp(L, LUA_REGISTRYINDEX, &times_key);
    lua_getfield(L, -1, "n");
    uint64_t n = (uint64_t)lua_tointeger(L, -1);
    lua_settop(L, 0);
    return n;
}

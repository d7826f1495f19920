/*
 * test_lualib.c - the scripts' library where it differs from stock Lua, and its bounds. test_lua_reference.c compares
 * all the rest with stock Lua.
 */
#include "../test.h"
#include "luapair.h"

enum { TEXT = 8192 };

/* ---- running chunks ---- */

static size_t add(char *out, size_t n, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    int more = vsnprintf(out + n, n < TEXT ? TEXT - n : 0, format, args);
    va_end(args);
    return n + (size_t)more;
}

/* The values on the stack, exactly. */
static void show(lua_State *L, char out[TEXT])
{
    size_t n = 0;

    out[0] = '\0';
    for (int i = 1; i <= lua_gettop(L); i++) {
        if (lua_isinteger(L, i))
            n = add(out, n, "%lld;", (long long)lua_tointeger(L, i));
        else if (lua_type(L, i) == LUA_TNUMBER)
            n = add(out, n, "%a;", lua_tonumber(L, i));
        else if (lua_type(L, i) == LUA_TSTRING)
            n = add(out, n, "'%s';", lua_tostring(L, i));
        else
            n = add(out, n, "%s;", lua_isboolean(L, i) ? lua_toboolean(L, i) ? "true" : "false" : luaL_typename(L, i));
    }
}

/* Runs a chunk; out gets what it returned, or the error's text. */
static bool run(lua_State *L, const char *chunk, char out[TEXT])
{
    lua_settop(L, 0);
    if (luaL_loadbufferx(L, chunk, strlen(chunk), "=t", "t") != LUA_OK)
        fail_msg("%s", lua_tostring(L, -1));
    int status = lua_pcall(L, 0, LUA_MULTRET, 0);
    if (status != LUA_OK && lualib_is_raised(L, -1)) {
        lualib_push_error_value(L, -1);
        lua_replace(L, 1);
        lua_settop(L, 1);
    }
    show(L, out);
    lua_settop(L, 0);
    return status == LUA_OK;
}

static bool run_ours(struct pair *p, const char *chunk, char out[TEXT])
{
    p->b->vm.work = p->spent;
    return run(p->ours, chunk, out);
}

static void gives(struct pair *p, const char *chunk, const char *expected)
{
    char out[TEXT];

    if (!run_ours(p, chunk, out))
        fail_msg("%s\nfailed: %s", chunk, out);
    if (strcmp(out, expected))
        fail_msg("%s\ngives %s\nnot   %s", chunk, out, expected);
}

static void same_as_stock(struct pair *p, const char *chunk)
{
    char expected[TEXT];

    assert_true(run(p->stock, chunk, expected));
    gives(p, chunk, expected);
}

/* The chunk ends in an error whose text has `what` in it. */
static void fails(struct pair *p, const char *chunk, const char *what)
{
    char out[TEXT];

    if (run_ours(p, chunk, out))
        fail_msg("%s\nwas let through: %s", chunk, out);
    if (!strstr(out, what))
        fail_msg("%s\nfailed with %s\nnot    %s", chunk, out, what);
}

/* A state that has seen a fault is dead; the next use is a new one. */
static void fails_for_good(struct pair **p, const char *chunk, const char *what)
{
    fails(*p, chunk, what);
    teardown((void **)p);
    setup((void **)p);
}

/* ---- strings ---- */

TEST(classes_of_all_bytes)
{
    same_as_stock(*state, "local t = {} for c = 0, 255 do for class in ('acdglpsuwxzACDGLPSUWXZ'):gmatch('.') do\n"
                          "t[#t + 1] = string.char(c):find('%' .. class) or 0 end end return table.concat(t)");
}

TEST(takes_well_formed_patterns)
{
    static const char *const chunks[] = {
        "return ('key = value'):match('^(%w+)%s*=%s*(%w+)$'), ('THE (quick) fox'):find('%((%a+)%)')",
        "return ('x'):rep(300):match(('x?'):rep(100) .. ('x'):rep(200)):len()",
        "return ('a]b-^'):match('[]b]+'), ('a]b-^'):match('[^]]+'), ('a]b-^'):match('[%]%-^]+$'), ('a-'):find('[a-]+')",
        "return ('THE (quick) fox'):find('%f[%a]%a+%f[%A]', 5), ('f(a(b)c)d'):match('%b()')",
        "return ('abcabd'):match('^(.-)(%a)%2?$'), ('abab'):match('(ab)%1'), ('x'):rep(50):find(('(x)'):rep(32))",
        "return ('abc'):gsub('', '-'), ('abc'):gsub('b*', '-'), ('abc'):gsub('$', 'x'), ('abc'):gsub('()b', '%1')",
    };

    for (size_t i = 0; i < sizeof chunks / sizeof *chunks; i++)
        same_as_stock(*state, chunks[i]);
}

TEST(writes_no_address)
{
    struct pair *p = *state;

    gives(p, "return tostring({}), tostring(tostring), ('%s %10s|'):format({}, {})",
          "'table';'function';'table      table|';");
    gives(p, "return tostring(setmetatable({}, {__name = 'thing'})), ('%s'):format(setmetatable({}, {__name = 'x'}))",
          "'thing';'x';");
    fails(p, "return ('%A'):format(1.5)", "invalid conversion");
    fails(p, "return ('%q'):format(1.5)", "whole numbers only");
    gives(p, "return ('%q %q %q %q %q'):format(2.0, -1e18, 1/0, -1/0, 0/0)",
          "'2.0 -1000000000000000000.0 1e9999 -1e9999 (0/0)';");
}

/* Both signs of NaN, however it arose. */
TEST(writes_one_nan)
{
    struct pair *p = *state;

    gives(p, "local n = 0/0 return tostring(n), tostring(-n), ('%f %g %5.1f|%-5g|%E'):format(n, -n, n, -n, n)",
          "'nan';'nan';'nan nan   nan|nan  |NAN';");
    gives(p, "local n = 0/0 return table.concat({n, -n}, ' '), ('a'):gsub('a', n), ('a'):gsub('a', {a = -n})",
          "'nan nan';'nan';'nan';1;");
    gives(p,
          "local t = setmetatable({}, {__tostring = function() return 0/0 end}) return tostring(t), ('%s'):format(t)",
          "'nan';'nan';");
}

/* Releases of 5.4 differ in whether utf8.codes lets a surplus continuation byte pass. */
TEST(reads_utf8_strictly)
{
    struct pair *p = *state;
    static const char *const bad[] = { "\\128", "a\\128", "\\195\\169\\128", "\\237\\160\\128", "\\255" };

    gives(
        p,
        "local t = {} for at, code in utf8.codes('a\\u{e9}\\u{20ac}\\u{1f3ae}') do t[#t + 1] = at .. ':' .. code end\n"
        "return table.concat(t, ' ')",
        "'1:97 2:233 4:8364 7:127918';");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char chunk[128];
        snprintf(chunk, sizeof chunk, "for p, c in utf8.codes('%s') do end", bad[i]);
        fails(p, chunk, "invalid UTF-8 code");
    }
}

/* ---- tables ---- */

TEST(sorts_stably_and_always_ends)
{
    struct pair *p = *state;

    gives(p,
          "for n = 0, 200, 9 do for kinds = 1, 7, 3 do\n"
          "local t = {} for i = 1, n do t[i] = {k = i * 37 % kinds, i = i} end\n"
          "table.sort(t, function(a, b) return a.k < b.k end)\n"
          "for i = 2, n do local a, b = t[i - 1], t[i]\n"
          "assert(a.k < b.k or a.k == b.k and a.i < b.i) end end end",
          "");
    gives(p, "local t = {} for i = 1, 1000 do t[i] = i end table.sort(t, function() return true end) return #t",
          "1000;");
    gives(p,
          "local x, t = 1, {} for i = 1, 300 do t[i] = i end\n"
          "table.sort(t, function() x = x * 1103515245 + 12345 return x >> 16 & 1 == 1 end)\n"
          "local s = 0 for i = 1, 300 do s = s + t[i] end return s",
          "45150;");
    gives(p,
          "local t = {3, 2, 1} local ok = pcall(table.sort, t, function() error('no') end) return ok, t[1], t[2], t[3]",
          "false;3;2;1;");
}

TEST(visits_in_order)
{
    struct pair *p = *state;

    gives(
        p,
        "local s = {} for k, v in pairs{b = 1, a = 2, [10] = 3, 4, [-5] = 5, ab = 6, [''] = 7, A = 8, ['\\255'] = 9}\n"
        "do s[#s + 1] = k .. '=' .. v end return table.concat(s, ' ')",
        "'-5=5 1=4 10=3 =7 A=8 a=2 ab=6 b=1 \xff=9';");
    gives(p,
          "local t = {} for i = 1, 500 do t['k' .. i * 7919 % 500] = i t[i * 7919 % 500 - 250] = i end\n"
          "local n, last = 0 for k in pairs(t) do n = n + 1\n"
          "assert(not last or math.type(last) and not math.type(k) or last < k) last = k end return n",
          "1000;");
    gives(p,
          "local t, s = {a = 1, b = 2, c = 3, 10, 20, 30}, '' for k, v in pairs(t) do s = s .. k t[k] = nil t.b = nil\n"
          "t[3] = nil t['new' .. k] = 1 end return s",
          "'12ac';");
    gives(p, "local t, n = {1, 2, 3, 4}, '' for k in pairs(t) do n = n .. k t[2], t[3] = nil end return n", "'14';");
    fails(p, "for k in pairs{[1.5] = 1} do end", "pairs: keys of type float have no fixed order");
    fails(p, "for k in pairs{[{}] = 1, [true] = 2} do end", "pairs: keys of type boolean have");
    fails(p, "for k in pairs(setmetatable({}, {__pairs = 1})) do end", "__pairs is not supported");
    gives(p, "local f, s, c = pairs{a = 1} return f(s, 'zzz'), f(s), f(s)", "'a';nil;nil;");
    gives(p, "local f, s, c = pairs{1, 2} return f(s, -7), f(s, math.maxinteger), (f(s, 1))", "nil;nil;2;");
}

/* ---- errors ---- */

TEST(catches_what_scripts_raise)
{
    struct pair *p = *state;
    static const char *const chunks[] = {
        "return pcall(function() error('x') end)",
        "return pcall(function() error('x', 0) end)",
        "local function f() error('deep', 2) end return pcall(function()\nf()\nend)",
        "local t = {} local ok, e = pcall(error, t) return ok, e == t",
        "return pcall(function() assert(false) end)",
        "return pcall(function() local ok, e = pcall(error, 'in') error(e .. '+', 0) end)",
        "return pcall(string.gsub, 'abc', '%w', function(c) error(c, 0) end)",
        "local s = '' local ok, e = pcall(function() local x <close> = setmetatable({}, {__close = function() s = 'c' "
        "end})\n"
        "error('e', 0) end) return ok, e, s",
    };

    for (size_t i = 0; i < sizeof chunks / sizeof *chunks; i++)
        same_as_stock(p, chunks[i]);
    fails(p, "error('uncaught')", "t:1: uncaught");
    gives(p,
          "local e2 local ok, e = pcall(function() local x <close> = setmetatable({}, {__close = function(_, e)\n"
          "e2 = tostring(e) error(e) end}) error('e', 0) end) return ok, e, e2",
          "false;'e';'e';");
}

TEST(lets_faults_through)
{
    struct pair *p = *state;
    static const char *const faults[][2] = {
        { "nil + 1", "attempt to perform arithmetic" },
        { "('x'):rep({})", "bad argument" },
        { "(function() local function f() return (('a'):gsub('a', f)) end return f() end)()", "stack overflow" },
        { "(function() local s = 'x' while true do s = s .. s end end)()", "not enough memory" },
        { "load(('('):rep(300) .. '1' .. (')'):rep(300))", "C stack overflow" },
        { "setmetatable({}, {['__' .. 'gc'] = 1})", "__gc is not allowed in a metatable" },
        { "setmetatable({}, { __call = {} })", "setmetatable: __call: expected a function, got a table" },
    };

    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        char chunk[512];
        snprintf(chunk, sizeof chunk, "local a, b = pcall(pcall, function() local x = %s end) return 'survived'",
                 faults[i][0]);
        fails_for_good(&p, chunk, faults[i][1]);
    }
    /* an error raised while a fault is on its way does not hide it */
    fails_for_good(&p,
                   "pcall(function() local x <close> = setmetatable({}, {__close = function() error('hides', 0) end})\n"
                   "local y = nil + 1 end) return 'survived'",
                   "attempt to perform arithmetic");
    *state = p;
}

TEST(keeps_the_first_traceback)
{
    struct pair *p = *state;

    gives(p, "return pcall(error, 'x')", "false;'x';");
    lualib_push_trace(p->ours);
    assert_true(lua_isnil(p->ours, -1));
    fails(
        p,
        "local function inner() local x = nil + 1 end local function outer() inner() return 1 end pcall(pcall, outer)",
        "attempt to perform arithmetic");
    lualib_push_trace(p->ours);
    assert_non_null(lua_tostring(p->ours, -1));
    assert_non_null(strstr(lua_tostring(p->ours, -1), "'inner'"));
    assert_null(strstr(lua_tostring(p->ours, -1), "0x"));
}

static int pause_here(lua_State *L)
{
    return lua_yield(L, 0);
}

TEST(catches_across_yields)
{
    struct pair *p = *state;
    lua_register(p->ours, "pause_here", pause_here);
    lua_State *co = lua_newthread(p->ours);
    static const char chunk[] =
        "local log = {} for i = 1, 3 do log[#log + 1] = tostring(select(2, pcall(function()\n"
        "pause_here() if i == 2 then error('two', 0) end pause_here() return 'fine' .. i end))) end\n"
        "return table.concat(log, ' ')";
    int results, yields = 0, status;

    assert_int_equal(luaL_loadstring(co, chunk), LUA_OK);
    while ((status = lua_resume(co, p->ours, 0, &results)) == LUA_YIELD)
        yields++;
    assert_int_equal(status, LUA_OK);
    assert_int_equal(yields, 5);
    assert_string_equal(lua_tostring(co, -1), "fine1 two fine3");

    lua_State *dying = lua_newthread(p->ours);
    assert_int_equal(luaL_loadstring(dying, "pcall(function() pause_here() local x = nil + 1 end) return 1"), LUA_OK);
    assert_int_equal(lua_resume(dying, p->ours, 0, &results), LUA_YIELD);
    assert_int_equal(lua_resume(dying, p->ours, 0, &results), LUA_ERRRUN);
    assert_false(lualib_is_raised(dying, -1));
    assert_non_null(strstr(lua_tostring(dying, -1), "arithmetic"));
}

/* ---- the sandbox ---- */

static int check_metatables(lua_State *L)
{
    lualib_check_metatables(L);
    return 0;
}

static bool metatables_are_clean(struct pair *p)
{
    lua_pushcfunction(p->ours, check_metatables);
    bool clean = lua_pcall(p->ours, 0, 0, 0) == LUA_OK;
    lua_settop(p->ours, 0);
    return clean;
}

TEST(refuses_weak_and_finalized)
{
    struct pair *p = *state;

    fails(p, "setmetatable({}, {['__' .. 'mode'] = 'k'})", "__mode is not allowed in a metatable");
    gives(p, "mt = {} a = setmetatable({}, mt) for i = 1, 100 do setmetatable({}, {i}) end", "");
    assert_true(metatables_are_clean(p));
    gives(p, "mt['__mo' .. 'de'] = 'k'", "");
    assert_false(metatables_are_clean(p));
    gives(p, "mt['__mo' .. 'de'] = nil rawset(mt, '__g' .. 'c', function() end)", "");
    assert_false(metatables_are_clean(p));
    gives(p, "mt['__g' .. 'c'] = nil mt.__call = mt", "");
    assert_false(metatables_are_clean(p)); /* calling it would never end */
    gives(p, "mt.__call = function() return 7 end return a()", "7;");
    assert_true(metatables_are_clean(p));
    gives(p, "mt.__call = {} a, mt = nil", "");
    lua_gc(p->ours, LUA_GCCOLLECT);
    assert_true(metatables_are_clean(p)); /* the list holds nothing alive */
}

TEST(keeps_only_what_is_listed)
{
    struct pair *p = *state;
    static const char *const expected[][2] = {
        { "_G", "_G _VERSION assert error getmetatable ipairs load math pairs pcall rawequal rawget rawlen rawset "
                "select setmetatable string table tonumber tostring type utf8 warn" },
        { "string", "byte char find format gmatch gsub len lower match rep reverse sub upper" },
        { "table", "concat insert move pack remove sort unpack" },
        { "math",
          "abs acos asin atan ceil cos deg floor fmod huge max maxinteger min mininteger modf pi rad sin sqrt tan "
          "tointeger type ult" },
        { "utf8", "char charpattern codepoint codes len offset" },
    };

    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        char chunk[256], names[512];
        snprintf(chunk, sizeof chunk,
                 "local n = {} for k in pairs(%s) do n[#n + 1] = k end return table.concat(n, ' ')", expected[i][0]);
        snprintf(names, sizeof names, "'%s';", expected[i][1]);
        gives(p, chunk, names);
    }
    same_as_stock(p, "return math.pi, math.huge, math.maxinteger, math.mininteger, _VERSION, #utf8.charpattern");
}

/* ---- hazards ---- */

/* Library calls that would run for ever, or for hours: each is cut off, and no pcall of the script's hides that. */
TEST(cuts_off_endless_work)
{
    struct pair *p = *state;
    static const char *const bombs[] = {
        "('a'):rep(120):find(('.-'):rep(4) .. 'b'); ('a'):rep(300):find(('.-'):rep(4) .. 'b')",
        "table.move({}, 1, 1 << 40, 2)",
        "table.concat(setmetatable({}, {__index = rawlen}), '', 1, 1 << 40)",
        "('a'):rep(60000):gsub('a*b', '')",
        "('x'):rep(1000000):find(('x'):rep(500000) .. 'y', 1, true)",
        "table.insert(setmetatable({}, {__len = function() return 1 << 40 end}), 1, 0)",
        "table.remove(setmetatable({}, {__len = function() return 1 << 40 end}), 1)",
        "table.sort(setmetatable({}, {__len = function() return 1 << 30 end}))",
        "local t = {} for i = 1, 2000 do t[i] = i end for i = 1, 1e6 do for _ in pairs(t) do break end end",
        "local s = ('1'):rep(1000000) for i = 1, 100000 do tonumber(s) end",
        "local s = ('x'):rep(1000000) for i = 1, 100000 do s:find('y', 1, true) end",
        "local s = ('x'):rep(1000000) for i = 1, 100000 do utf8.len(s) end",
        "local s = ('\\128'):rep(1000000) for i = 1, 10000 do local f = utf8.codes('a') f(s, 1) end",
    };

    for (size_t i = 0; i < sizeof bombs / sizeof *bombs; i++) {
        char chunk[512];
        snprintf(chunk, sizeof chunk, "pcall(pcall, function() %s end) return 'survived'", bombs[i]);
        p->spent = i ? WORK_LIMIT - WORK_LIMIT / 20 : 0; /* the first in full, the others near the end of the frame */
        fails_for_good(&p, chunk, "infinite loop");
    }
    fails_for_good(&p, "pcall(string.rep, 'x', 1 << 40)", "too large");
    fails_for_good(&p, "pcall(table.unpack, {}, 1, 1 << 40)", "too many results");
    gives(p, "return #(''):rep(1 << 40)", "0;");
    *state = p;
}

/* Ordinary use is charged little. */
TEST(charges_fairly)
{
    struct pair *p = *state;

    gives(p,
          "for i = 1, 1000 do local s = ('k=%d'):format(i) local k, v = s:match('^(%w+)=(%d+)$') for _ in pairs{1, 2, "
          "a = 3} do end\n"
          "local t = {3, 1, 2} table.sort(t) table.insert(t, 1, 4) s = table.concat(t, ',') end",
          "");
    assert_in_range(p->b->vm.work, 10000, 300000);
}

RUN_TESTS_EACH(setup, teardown)

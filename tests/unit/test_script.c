/* test_script.c - script.h: what is refused, where it is found, and what looks like it but is fine. */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/script/script.h"
#include "../../src/script/std.h"

#define POWER "operator ^ is not available (results differ between machines); use x*x or math.sqrt"
#define GC    "__gc is not available (finalizers run at different times on different machines)"
#define MODE  "__mode is not available (weak tables hold different entries on different machines)"

/* Scans a copy of exactly the text's size, so that a sanitizer sees any read beyond it. */
static bool scan(const char *text, size_t n, int *line, const char **what)
{
    char *copy = malloc(n + (n == 0));

    memcpy(copy, text, n);
    bool good = script_scan(copy, n, line, what);
    free(copy);
    return good;
}

static void fine(const char *text)
{
    const char *what = NULL;
    int line = 0;

    if (!scan(text, strlen(text), &line, &what))
        print_message("%s\n%d: %s\n", text, line, what);
    assert_null(what);
}

static void refused_n(const char *text, size_t n, int want_line, const char *want)
{
    const char *what = NULL;
    int line = 0;

    assert_false(scan(text, n, &line, &what));
    assert_string_equal(what, want);
    assert_int_equal(line, want_line);
}

static void refused(const char *text, int line, const char *what)
{
    refused_n(text, strlen(text), line, what);
}

TEST(power)
{
    refused("return 2^3", 1, POWER);
    refused("x = 1\ny = x ^2", 2, POWER);
    refused("local s = 'a' ^ 1", 1, POWER);
    fine("-- 2^3\nreturn 1");
    fine("return '2^3', \"^\", [[^]], [==[ ]] ^ ]==]");
    fine("--[[ ^ \n ^ ]] return 1 --[=[ ^ ]] ]=] return 2");
    fine("return ('a'):find('^a')");
    refused("--[[ ]] ^", 1, POWER);
    refused("--[ ^\n^", 2, POWER);
    refused("--[=\n^", 2, POWER);
    refused("a[b[1]]=2^2", 1, POWER);
    refused("a[ [[x]] ] = 1 ^ 1", 1, POWER);
}

TEST(names)
{
    refused("t.__gc = 1", 1, GC);
    refused("t = { __mode = 'k' }", 1, MODE);
    refused("t['__gc'] = 1", 1, GC);
    refused("t[\"__mode\"] = 1", 1, MODE);
    refused("t[ [[__gc]] ] = 1", 1, GC);
    refused("t[ [==[\n__gc]==] ] = 1", 1, GC);
    refused("t[ [[\r\n__mode]] ] = 1", 1, MODE);
    fine("t.__gcx = 1 x__gc = 2 t.__mod = 3 __modes = 4 _gc = 5 t.__index = 6");
    fine("t = '__gc ' t = ' __mode' t = '__g' .. 'c'");
    fine("t = [[\n\n__gc]]");
    fine("-- __gc\n--[[ __mode ]]");
    fine("return '__gc__mode'");
}

TEST(escapes)
{
    refused("'\\95_gc'", 1, GC);
    refused("'\\095_gc'", 1, GC);
    refused("'\\x5f\\x5Fgc'", 1, GC);
    refused("'\\u{5f}_gc'", 1, GC);
    refused("'\\u{00000005F}_gc'", 1, GC);
    refused("'__\\z \n\t  gc'", 1, GC);
    refused("'__\\z  \n\\z \n mode'", 1, MODE);
    fine("'\\n__gc'");
    fine("'__gc\\0'");
    fine("'__gc\\\n'");
    fine("'\\u{1005f}_gc'");
    fine("'\\u{10000005f}_gc'");
    fine("'\\'__gc\\''");
    fine("'\\\\' '__g\\c'");
    refused("'\\\\' ^ 2", 1, POWER);
    refused("'\\'' ^ 2", 1, POWER);
}

TEST(lines)
{
    refused("\n\n^", 3, POWER);
    refused("\r\n\r\n^", 3, POWER);
    refused("\r\r^", 3, POWER);
    refused("\n\r\n\r^", 3, POWER);
    refused("--[[\n\n]]\n^", 4, POWER);
    refused("x = [[\r\n\r\n]] ^", 3, POWER);
    refused("x = 'a\\\nb' ^", 2, POWER);
    refused("x = 'a\\\r\nb\\z \r\n c' ^", 3, POWER);
    refused("-- a\r\n-- b\r\n^", 3, POWER);
    refused_n("a = '\0' \n^", 10, 2, POWER);
}

/* Text that is not Lua is the compiler's business, but the scan ends. */
TEST(unfinished)
{
    static const char *const texts[] = { "",
                                         "'",
                                         "\"a",
                                         "[[",
                                         "[==[ ]=]",
                                         "--[[",
                                         "--[==[ ]] ]=]",
                                         "--",
                                         "'\\",
                                         "'\\x",
                                         "'\\x5",
                                         "'\\u",
                                         "'\\u{",
                                         "'\\u{5f",
                                         "'\\9",
                                         "'\\z",
                                         "'\\z ",
                                         "'a\nb'",
                                         "[",
                                         "[=",
                                         "[==",
                                         "-",
                                         "'\\u{fffffffffffffffff}'",
                                         "]]",
                                         "[[]",
                                         "[=[]",
                                         "[=[]=" };

    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        fine(texts[i]);
}

/* Bytes of all kinds, and every cut of them: the scan ends and stays inside. */
TEST(any_bytes)
{
    static const char alphabet[] = "'\"[]=-\\xzu{}5f_gcmode^\n\r a9";
    struct rng r;
    char text[40];

    rng_seed(&r, 11);
    for (int i = 0; i < 20000; i++) {
        size_t n = (size_t)rng_below(&r, sizeof text);
        const char *what = NULL;
        int line = 0;
        for (size_t k = 0; k < n; k++)
            text[k] = rng_below(&r, 50) ? alphabet[rng_below(&r, sizeof alphabet - 1)] : (char)rng_next(&r);
        if (!scan(text, n, &line, &what))
            assert_true(line >= 1 && what != NULL);
    }
}

static void checked(const char *text, const char *want)
{
    static _Alignas(16) char work[1 << 20];
    char err[256] = "";

    assert_int_equal(script_check(text, strlen(text), "@stages/one.lua", work, sizeof work, err, sizeof err),
                     want[0] == '\0');
    assert_string_equal(err, want);
}

TEST(check)
{
    checked("local x <const> = 1 return x // 2 & 3", "");
    checked("-- nothing", "");
    checked("\n\nx = 2 ^ 2", "stages/one.lua:3: " POWER);
    checked("x = {\n__gc = 1 }", "stages/one.lua:2: " GC);
    checked("x = \n= 1", "stages/one.lua:2: unexpected symbol near '='");
    checked("\x1bLua", "stages/one.lua:1: expected Lua source, got compiled Lua");
    checked("return 1\n[[a\nb]]", "stages/one.lua:3: <eof> expected near '[[a b]]'");
}

/* A missing end: the block that Lua means, and by the indentation the one that the author means. */
TEST(end)
{
    checked("do\n  x = 1\n", "stages/one.lua:3: expected `end` to close `do` at line 1, got the end of the file");
    checked("if x then y = 1", "stages/one.lua:1: expected `end` to close `if` at line 1, got the end of the file");
    checked("function f()\n  if a then\n    b()\nend\nlocal x = 2\n",
            "stages/one.lua:6: expected `end` to close `function` at line 1, got the end of the file; the indentation "
            "suggests `if` at line 2");
    checked("run(function()\n\twhile f(function() return 'end' end) do -- end\n\t\tx()\nend)\n",
            "stages/one.lua:4: expected `end` to close `while` at line 2, got ')'");
    checked("player.def('p', { run = function(p)\n  if x[y(1)] then\n    z()\n  end\n})\n",
            "stages/one.lua:5: expected `end` to close `function` at line 1, got '}'");
    checked("x = { y = ] }", "stages/one.lua:1: unexpected symbol near ']'");
    checked("f(1, end)", "stages/one.lua:1: unexpected symbol near 'end'");
    checked("local a = [[\nend]] for i = 1, 2 do\n  repeat x() until i\n  do y() end\n",
            "stages/one.lua:5: expected `end` to close `for` at line 2, got the end of the file");
    checked("t = { f = function() if x then z() end,\n  g = 1 }\n",
            "stages/one.lua:1: expected `end` to close `function` at line 1, got ','");
    checked("x = 'end' y = (\n", "stages/one.lua:2: unexpected symbol near <eof>");
}

/* Deeper than is looked at, and cut everywhere: no more than Lua says itself, and nothing is read beyond the end. */
TEST(end_anywhere)
{
    static _Alignas(16) char work[1 << 20];
    static const char all[] = "local function f(a)\n  for i = 1, 2 do if a then repeat x = \"end\" until y end end\n"
                              "  while z do do end end -- end\n  return function() end\nend\n";
    char err[256], deep[300 * 3 + 1];

    for (size_t n = 0; n < sizeof all; n++) {
        char *cut = malloc(n ? n : 1);
        memcpy(cut, all, n);
        script_check(cut, n, "@one.lua", work, sizeof work, err, sizeof err);
        free(cut);
    }
    for (int i = 0; i < 300; i++)
        memcpy(deep + 3 * i, "do ", 4);
    assert_false(script_check(deep, strlen(deep), "@one.lua", work, sizeof work, err, sizeof err));
}

/* One call after the other finds all, with their lines. */
TEST(all)
{
    static const char text[] = "x = 2 ^ 3\ny = [[\n__gc]] ^ 1\nt.__mode = '^'\n";
    static const struct {
        int line;
        const char *what;
    } want[] = { { 1, POWER }, { 2, GC }, { 3, POWER }, { 4, MODE } };
    struct script_position place = { 0, 1 };
    const char *what;
    int line;

    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++) {
        assert_false(script_scan_from(text, sizeof text - 1, &place, &line, &what));
        assert_int_equal(line, want[i].line);
        assert_string_equal(what, want[i].what);
    }
    assert_true(script_scan_from(text, sizeof text - 1, &place, &line, &what));
}

/* All that script_next_global gives, with blanks between. */
static void gives(const char *text, const char *want)
{
    char got[256] = "";
    size_t n = strlen(text), at = 0, size;
    char *copy = malloc(n + (n == 0));
    const char *word;

    memcpy(copy, text, n);
    while (script_next_global(copy, n, &at, &word, &size))
        snprintf(got + strlen(got), sizeof got - strlen(got), "%s%.*s", got[0] ? " " : "", (int)size, word);
    free(copy);
    assert_string_equal(got, want);
}

TEST(reads)
{
    gives("", "");
    gives("a.b:c 'd' \"e\" [[f]] [=[g]] ]=] -- h\n --[[ i ]] --[==[ j ]==] k", "a k");
    gives("a . b : c", "a");
    gives("a. --[[ x ]] b", "a");
    gives("a..b ... c", "a b c");
    gives("::a:: b", "a b");
    gives("a = b", "b");
    gives("a--[[ x ]]\n= b", "b");
    gives("a == b ~= c <= d", "a b c d");
    gives("f { a = b, c == d, [e] = g }", "f b c d e g");
    gives("x = 3. y.z()", "y");
    gives("x = .5 y.z() x = 1e+5 y.z() x = 1e5 w() x = 0xap-1 y() x = 0Xe+z", "y y w y z");
    gives("x = 5 // y x = a[1].b", "y a");
    gives("x = a//.5 y()", "a y");
    gives("'\\'a' b \"\\z \n c\" d '\\\n e' f", "b d f");
    gives("pattern_x xpattern pattern2", "pattern_x xpattern pattern2");
}

TEST(modules)
{
    const uint64_t all = ((uint64_t)1 << STD_MODULE_COUNT) - 1;

    for (int i = 1; i < STD_MODULE_COUNT; i++) {
        char text[64];
        int n = snprintf(text, sizeof text, "x = %s.y", std_modules[i].name);
        if (std_modules[i].extended_table) {
            assert_int_equal(std_module_of_global(std_modules[i].name), -1);
            continue;
        }
        assert_int_equal(std_module_of_global(std_modules[i].name), i);
        assert_true(std_find_used_modules(text, (size_t)n) == (uint64_t)1 << i);
        n = snprintf(text, sizeof text, "x.%s = '%s' -- %s\n%sx()", std_modules[i].name, std_modules[i].name,
                     std_modules[i].name, std_modules[i].name);
        assert_true(std_find_used_modules(text, (size_t)n) == 0);
    }
    assert_int_equal(std_module_of_file("boss"), -1);
    assert_int_equal(std_module_of_file("bosses/cast"), -1);
    assert_int_equal(std_module_of_file("bos/cast"), -1);
    assert_int_equal(std_module_of_file("/cast"), -1);
    assert_int_equal(std_module_of_file("boss/cast"), std_module_of_global("boss"));
    assert_int_equal(std_module_of_file("screens/title"), std_module_of_global("boot"));
    assert_string_equal(std_modules[0].name, "prelude");
    assert_int_equal(std_module_of_global("prelude"), -1);
    assert_int_equal(std_module_of_global("wait_for"), 0);
    assert_int_equal(std_module_of_global("wait"), -1);
    assert_int_equal(std_module_of_global(""), -1);
    assert_int_equal(std_module_of_global(" pattern "), -1);
    assert_true(std_find_used_modules("wait_until(f)", 13) == 1);
    assert_true(std_find_used_modules("boss.def(hud)", 13) ==
                (1u << std_module_of_global("boss") | 1u << std_module_of_global("hud")));
    assert_int_equal(std_module_of_field("pattern", "star"), 2);
    assert_int_equal(std_module_of_field("pattern", "ring"), -1);
    assert_int_equal(std_module_of_field("bullet", "star"), -1);
    assert_true(std_find_used_modules("pattern.star", 12) == (1 << 1 | 1 << 2) &&
                std_find_used_modules("f(pattern)", 10) == (1 << 1 | 1 << 2));
    assert_true(std_find_used_modules("x(pattern..star)", 16) == (1 << 1 | 1 << 2));
    assert_true(std_find_needed_modules(1, "return pattern", 14) == 1 << 1);
    assert_true(std_find_used_modules("_G[k]", 5) == all && std_find_used_modules("_ENV[k]", 7) == all &&
                std_find_used_modules("load(k)", 7) == all);
    assert_true(std_find_used_modules("stages._G = s:load()", 20) == 0);
}

RUN_TESTS(NULL, NULL)

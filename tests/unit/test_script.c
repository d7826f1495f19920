/* test_script.c - script.h: what is refused, where it is found, and what looks like it but is fine. */
#include "../test.h"
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
    fine("return '2^3', \"^\", [[^]], [==[ ]] ^ ]==]");
    fine("--[[ ^ \n ^ ]] return 1 --[=[ ^ ]] ]=] return 2");
    fine("return ('a'):find('^a')");
    refused("--[[ ]] ^", 1, POWER);
    refused("--[ ^\n^", 2, POWER);
    refused("--[=\n^", 2, POWER);
    refused("a[b[1]]=2^2", 1, POWER);
}

TEST(names)
{
    refused("t.__gc = 1", 1, GC);
    refused("t = { __mode = 'k' }", 1, MODE);
    refused("t['__gc'] = 1", 1, GC);
    refused("t[ [==[\n__gc]==] ] = 1", 1, GC);
    refused("t[ [[\r\n__mode]] ] = 1", 1, MODE);
    fine("t.__gcx = 1 x__gc = 2 t.__mod = 3 __modes = 4 _gc = 5 t.__index = 6");
    fine("t = '__gc ' t = ' __mode' t = '__g' .. 'c'");
    fine("-- __gc\n--[[ __mode ]]");
}

TEST(escapes)
{
    refused("'\\095_gc'", 1, GC);
    refused("'\\x5f\\x5Fgc'", 1, GC);
    refused("'\\u{5f}_gc'", 1, GC);
    refused("'__\\z  \n\\z \n mode'", 1, MODE);
    fine("'\\n__gc'");
    fine("'__gc\\0'");
    fine("'\\u{10000005f}_gc'");
    fine("'\\'__gc\\''");
    fine("'\\\\' '__g\\c'");
    refused("'\\\\' ^ 2", 1, POWER);
    refused("'\\'' ^ 2", 1, POWER);
}

TEST(lines)
{
    refused("\n\n^", 3, POWER);
    refused("\n\r\n\r^", 3, POWER);
    refused("x = [[\r\n\r\n]] ^", 3, POWER);
    refused("x = 'a\\\r\nb\\z \r\n c' ^", 3, POWER);
    refused_n("a = '\0' \n^", 10, 2, POWER);
}

/* Text that is not Lua is for the compiler to refuse, but the scan ends. */
TEST(unfinished)
{
    static const char *const texts[] = { "",       "'",     "[[",   "[==[ ]=]", "--[[", "--[==[ ]] ]=]",
                                         "--",     "'\\",   "'\\x", "'\\x5",    "'\\u", "'\\u{5f",
                                         "'\\9",   "'\\z ", "[==",  "-",        "]]",   "'\\u{fffffffffffffffff}'",
                                         "'a\nb'", "[=[]=" };

    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        fine(texts[i]);
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
    checked("\n\nx = 2 ^ 2", "stages/one.lua:3: " POWER);
    checked("x = {\n__gc = 1 }", "stages/one.lua:2: " GC);
    checked("x = \n= 1", "stages/one.lua:2: unexpected symbol near '='");
    checked("\x1bLua", "stages/one.lua:1: expected Lua source, got compiled Lua");
    checked("return 1\n[[a\nb]]", "stages/one.lua:3: <eof> expected near '[[a b]]'");
}

/* A missing end: the block that Lua means, and by the indentation the one that the author means. */
TEST(end)
{
    checked("if x then y = 1", "stages/one.lua:1: expected `end` to close `if` at line 1, got the end of the file");
    checked("function f()\n  if a then\n    b()\nend\nlocal x = 2\n",
            "stages/one.lua:6: expected `end` to close `function` at line 1, got the end of the file; the indentation "
            "suggests `if` at line 2");
    checked("run(function()\n\twhile f(function() return 'end' end) do -- end\n\t\tx()\nend)\n",
            "stages/one.lua:4: expected `end` to close `while` at line 2, got ')'");
    checked("player.def('p', { run = function(p)\n  if x[y(1)] then\n    z()\n  end\n})\n",
            "stages/one.lua:5: expected `end` to close `function` at line 1, got '}'");
    checked("f(1, end)", "stages/one.lua:1: unexpected symbol near 'end'");
    checked("local a = [[\nend]] for i = 1, 2 do\n  repeat x() until i\n  do y() end\n",
            "stages/one.lua:5: expected `end` to close `for` at line 2, got the end of the file");
    checked("t = { f = function() if x then z() end,\n  g = 1 }\n",
            "stages/one.lua:1: expected `end` to close `function` at line 1, got ','");
    checked("x = 'end' y = (\n", "stages/one.lua:2: unexpected symbol near <eof>");
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
    gives("a.b:c 'd' \"e\" [[f]] [=[g]] ]=] -- h\n --[[ i ]] --[==[ j ]==] k", "a k");
    gives("a. --[[ x ]] b", "a");
    gives("a..b ... c", "a b c");
    gives("::a:: b", "a b");
    gives("a--[[ x ]]\n= b", "b");
    gives("a == b ~= c <= d", "a b c d");
    gives("f { a = b, c == d, [e] = g }", "f b c d e g");
    gives("x = 3. y.z()", "y");
    gives("x = .5 y.z() x = 1e+5 y.z() x = 1e5 w() x = 0xap-1 y() x = 0Xe+z", "y y w y z");
    gives("x = 5 // y x = a[1].b", "y a");
    gives("'\\'a' b \"\\z \n c\" d '\\\n e' f", "b d f");
    gives("pattern_x xpattern pattern2", "pattern_x xpattern pattern2");
}

TEST(modules)
{
    for (int i = 1; i < STD_MODULE_COUNT; i++) {
        char text[64];
        const int n = snprintf(text, sizeof text, "x = %s.y", std_modules[i].name);
        const bool is_global = !std_modules[i].extended_table;
        assert_int_equal(std_module_of_global(std_modules[i].name), is_global ? i : -1);
        if (is_global)
            assert_true(std_find_used_modules(text, (size_t)n) == (uint64_t)1 << i);
    }
    assert_int_equal(std_module_of_file("boss"), -1);
    assert_int_equal(std_module_of_file("bos/cast"), -1);
    assert_int_equal(std_module_of_file("/cast"), -1);
    assert_int_equal(std_module_of_file("boss/cast"), std_module_of_global("boss"));
    assert_int_equal(std_module_of_file("screens/title"), std_module_of_global("boot"));
    assert_int_equal(std_module_of_global("wait_for"), 0);
    assert_int_equal(std_module_of_global("wait"), -1);
    assert_int_equal(std_module_of_field("pattern", "star"), 2);
    assert_int_equal(std_module_of_field("pattern", "ring"), -1);
    assert_true(std_find_used_modules("x(pattern..star)", 16) == (1 << 1 | 1 << 2));
    assert_true(std_find_needed_modules(1, "return pattern", 14) == 1 << 1);
    assert_true(std_find_used_modules("stages._G = s:load() x.boss = 'hud' -- say", 42) == 0);
}

RUN_TESTS(NULL, NULL)

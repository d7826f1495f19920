/*
 * test_symbols.c - symbols.h: every construct of Lua, what is found in it, and that names are resolved as the Lua
 * compiler resolves them: luac's listing of each script of the repository and of generated programs is the judge.
 */
#define _POSIX_C_SOURCE 200809L /* popen, mkdtemp */
#include <unistd.h>
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/script/script.h"
#include "../../src/workbench/check/symbols.h"
#include "../../src/common/files.h"
#include "../../src/common/tree.h"
#include "../../src/workbench/check/builtins.h"

enum { WORK = 64 << 20, TEXT = 1 << 20 };

static char work_block[WORK + 16], out[1 << 16];

static void *work(void)
{
    return (void *)(((uintptr_t)work_block + 15) & ~(uintptr_t)15);
}

static bool compiles(const char *text, size_t n)
{
    char err[512];

    return script_compile(text, n, "@a.lua", work(), WORK, err, sizeof err);
}

/* Of a copy of exactly this size, so that a sanitizer sees any read beyond it. */
static bool read_copy(struct symbols *f, const char *text, size_t n)
{
    char *copy = malloc(n + (n == 0));

    memcpy(copy, text, n);
    bool whole = symbols_read(f, copy, n, builtins_global);
    free(copy);
    return whole;
}

/* ---- symbols as a line ---- */

static void say(const char *format, ...)
{
    size_t n = strlen(out);
    va_list args;

    va_start(args, format);
    vsnprintf(out + n, sizeof out - n, format, args);
    va_end(args);
}

static void say_line(int line)
{
    if (line != 1)
        say("@%d", line);
    say(" ");
}

static void say_global(const struct symbol_global *g)
{
    static const char *const after[] = { "", "[]", "=", "", "=", "()", "=" };

    say("%s%s%s%s", g->name,
        g->field == NULL       ? ""
        : g->use >= USE_METHOD ? ":"
                               : ".",
        g->field != NULL ? g->field : "", after[g->use]);
    if (g->local != NULL)
        say("~%s", g->local);
    say_line(g->line);
}

static void say_origin(const struct symbol_origin *o)
{
    say("%s%s%s", o->space != NULL ? o->space : "", o->space != NULL ? "." : "", o->name);
    if (o->arg > 0)
        say("/%d%s%s/%d", o->arg, o->key != NULL ? "." : "", o->key != NULL ? o->key : "", o->param);
}

/* What stands on the face of the text, but calls and keys. */
static const char *found(const char *text)
{
    struct symbols f;

    out[0] = '\0';
    if (!read_copy(&f, text, strlen(text)))
        say("(not whole) ");
    for (int i = 0; i < f.n_globals; i++)
        say_global(&f.globals[i]);
    for (int i = 0; i < f.n_iterations; i++) {
        say("{%s ", f.iterations[i].operation);
        say_origin(&f.iterations[i].origin);
        say("}");
        say_line(f.iterations[i].line);
    }
    for (int i = 0; i < f.n_divisions; i++) {
        say("<%s%s0>",
            f.divisions[i].left_is_zero     ? "0"
            : f.divisions[i].left_is_number ? "n"
                                            : "x",
            f.divisions[i].operation);
        say_line(f.divisions[i].line);
    }
    for (int i = 0; i < f.n_formats; i++) {
        say("\"%s\"", f.formats[i].s);
        say_line(f.formats[i].line);
    }
    symbols_free(&f);
    if (out[0] != '\0')
        out[strlen(out) - 1] = '\0';
    return out;
}

static const struct {
    const char *text, *want;
} table[] = {
    /* names: reads and writes */
    { "", "" },
    { "print(foo)", "print foo" },
    { "foo = 1", "foo=" },
    { "local foo = 1 foo = 2 print(foo)", "print" },
    { "local foo = foo", "foo" },
    { "local a, b = b, a", "b a" },
    { "local a <const>, b <close> = 1, nil return a, b", "" },
    { "local function f() return f() end", "" },
    { "local f = function() return f() end", "f" },
    { "function f() return f() end", "f= f" },
    { "do local x = 1 end x = x", "x= x" },
    { "if x then local y = 1 elseif y then local z else z = y end", "x y z= y" },
    { "while a do local a = 1 a = 2 end a()", "a a" },
    { "repeat local a = 1 until a a()", "a" },
    { "for i = i, n, s do i = 2 end i = 3", "i n s i=" },
    { "for k, v in pairs(k) do print(k, v) end k = v", "pairs k print k= v" },
    { "local function f(a, b, ...) local c = ... return a, b, c, d end", "d" },
    { "function t.a.b.c(x) return x, self end", "t.a self" },
    { "function t:m(x) self.y, z = x end", "t:m= z=" },
    { "local t = {} function t.f() end function t:g() return self, h end", "h" },
    { "goto done do local done = 1 end ::done:: done()", "done" },
    { "a.b = c.d", "a.b= c.d" },
    { "a['b'] = c[\"d\"]", "a.b= c.d" },
    { "a[b] = c[d]", "b a d c[]" },
    { "a.b.c.d = 1", "a.b" },
    { "a.b:c(d)", "a.b d" },
    { "a:b(c)", "a:b() c" },
    { "a:b 'x' a:b { c = d }", "a:b() a:b() d" },
    { "f 'x' f { y } f { y = z; [w] = v, u }", "f f y f z w v u" },
    { "(f)(x)", "f x" },
    { "(a).b = 1", "a" },
    { "local a a.b = 1 a[c] = 2 a.d.e = f", "c f" },
    { "a, b.c, d[1] = 1, 2, 3", "a= b.c= d" },
    { "local x = 1 return function() x = 2 return function() return x + y end end", "y" },
    { "return not a, -b, ~c, #d", "a b c d" },
    { "return a .. b + c - d * e / f // g % h ^ i", "a b c d e f g h i" },
    { "return a == b, c ~= d, e < f, g <= h, i > j, k >= l", "a b c d e f g h i j k l" },
    { "return a & b | c ~ d << e >> f and g or h", "a b c d e f g h" },
    { "return ...", "" },
    { "return", "" },
    { "return;", "" },
    { ";;; break_ = 1", "break_=" },
    { "while true do break end", "" },
    { "x = 1\ny = 2\r\nz = 3\n\rw = 4", "x= y=@2 z=@3 w=@4" },
    { "--[[ a\nb ]] c = 1 -- d\ne = 2 --[==[ ]] ]==] f()", "c=@2 e=@3 f@3" },
    { "x = [[\n\n]] y = 1", "x= y=@3" },
    { "x = 'a\\\nb' y = 'a\\z \n  b' z = 1", "x= y=@2 z=@3" },
    { "x = 0x1p-3 + 1e+5 + .5 + 3. + 0xA.8p1 + 7", "x=" },
    { "x = 'it\\'s \\x41\\65\\u{48}\\n'", "x=" },
    /* _G and _ENV */
    { "_G.foo = _ENV.bar", "foo= bar" },
    { "_G.a.b = 1 return _G[x]", "a.b= x _G[]" },
    { "local _ENV = {} foo = bar", "" },
    { "do local _ENV = f foo = 1 end foo = 2", "f foo=" },
    { "local function f(_ENV) return foo end return foo", "foo" },
    /* the nearest local */
    { "local count = 1 return conut", "conut~count" },
    { "local count = 1 do local counts = 2 end return coun", "coun~count" },
    { "local print_ = 1 return print", "print" },
    { "local wave, wait_ = 1, 2 return wavy", "wavy~wave" },
    { "local x = 1 return y", "y" },
    /* things that are no tables */
    { "pairs(bullet.fire { x = 1 })", "pairs bullet.fire {pairs bullet.fire}" },
    { "local b = bullet.fire {} for k in ipairs(b) do end", "bullet.fire ipairs {ipairs bullet.fire}" },
    { "local b\nb = f()\nreturn function() return #b end", "f@2 {# f}@3" },
    { "local b = f() b = nil return #b", "f" },
    { "local b = f() return function() b = {} return #b end", "f" },
    { "local b b = f() b = g() return #b", "f g" },
    { "local a, b = f(), g() return #a, #b", "f g {# f} {# g}" },
    { "local a, b = f() return #a, #b", "f {# f}" },
    { "local a = f() or {} return #a", "f" },
    { "local a = f().x return #a", "f" },
    { "local a = f()() return #a", "f" },
    { "local a = (f()) return #a, #(f())", "f f {# f} {# f}" },
    { "local f = g return #f()", "g" },
    { "local pairs = each pairs(f())", "each f" },
    { "local t = {} return #t, #'x', #t.y", "" },
    { "each('t', function(b, i) return #b, #i end)", "each {# each/2/1} {# each/2/2}" },
    { "def('n', { run = function(e) return #e end, f = function(e) e = {} return #e end })", "def {# def/2.run/1}" },
    { "a.b { c = { { d = function(x) return #x end } } }", "a.b {# a.b/1.d/1}" },
    { "a.b(function(x) return function(x) return #x end end)", "a.b" },
    { "a.b((function(x) return #x end))", "a.b" },
    { "x:each(function(b) return #b end)", "x:each()" },
    /* divisions */
    { "return 0/0, -(0/0), 0.0/0, 0/-0, 0x0/0", "<0/0> <0/0> <0/0> <0/0> <0/0>" },
    { "return 1/0, -1/0, x/0, x//0, x%0.0, 3%0", "x x x <n/0> <n/0> <x/0> <x//0> <x%0> <n%0>" },
    { "return 1/2/0, 0/1, x/(0), x/0e5, x/.0", "x x x <x/0> <x/0> <x/0> <x/0>" },
    { "return 1/10, 1/0.5, 1/0x10, x/0 ^ 2, 1/1e0, -0, 1/ -1", "x" },
    /* formats */
    { "string.format('%d', 1) string.format(f, 2); ('%s'):format(3)", "string.format string.format f \"%d\" \"%s\"" },
    { "local s = 'x' s:format(1) ('a'):rep(2):format(3)", "" },
    /* what the compiler refuses */
    { "x = = 1", "(not whole)" },
    { "f(", "f (not whole)" },
    { "local 1", "(not whole)" },
    { "x = 'abc", "(not whole)" },
    { "x = [[abc", "(not whole)" },
    { "--[[ abc", "(not whole)" },
    { "x = '\\q'", "(not whole)" },
    { "x = 3x", "(not whole)" },
    { "end", "(not whole)" },
    { "return 1 x()", "(not whole)" },
    { "for a.b = 1, 2 do end", "(not whole)" },
    { "x = 1 @ y = 2", "(not whole)" },
    { "#!shell", "(not whole)" },
};

TEST(table)
{
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        bool refused = strstr(table[i].want, "(not whole)") != NULL;
        const char *got = found(table[i].text);
        if (refused ? strstr(got, "(not whole)") == NULL : strcmp(got, table[i].want) != 0)
            print_message("%s\nwant %s\ngot  %s\n", table[i].text, table[i].want, got);
        if (refused)
            assert_non_null(strstr(got, "(not whole)"));
        else
            assert_string_equal(got, table[i].want);
        assert_int_equal(compiles(table[i].text, strlen(table[i].text)), !refused);
    }
}

/* ---- calls, keys, texts, members, the result ---- */

static const char *calls_of(const char *text)
{
    struct symbols f;

    out[0] = '\0';
    assert_true(read_copy(&f, text, strlen(text)));
    for (int i = 0; i < f.n_calls; i++) {
        const struct symbol_call *c = &f.calls[i];
        say("%s%s%s(", c->space != NULL ? c->space : "", c->space != NULL ? "." : "", c->name);
        for (int k = 0; k < c->args && k < SYMBOL_ARGS; k++)
            say("%s%s", k > 0 ? "," : "", c->arg[k] != NULL ? c->arg[k] : "?");
        say(")%d ", c->line);
    }
    symbols_free(&f);
    return out;
}

TEST(calls)
{
    assert_string_equal(calls_of("require 'a/b' require(\"c\") require(d) local r = require"),
                        "require(a/b)1 require(c)1 require(?)1 ");
    assert_string_equal(calls_of("a.b('x',\n'y', z, 'w') a.b.c('x') a:b('x') a.b { 'x' }\nf()"),
                        "a.b(x,y,?)1 a.b(?)2 f()3 ");
    assert_string_equal(calls_of("local f = 1 f('x') g(h('x'))"), "h(x)1 g(?)1 ");
    assert_string_equal(calls_of("f('a' .. 'b') f(('a'))"), "f(?)1 f(a)1 ");
}

static const char *keys_of(const char *text)
{
    struct symbols f;

    out[0] = '\0';
    assert_true(read_copy(&f, text, strlen(text)));
    for (int i = 0; i < f.n_keys; i++) {
        const struct symbol_key *k = &f.keys[i];
        const struct symbol_table *t = &f.tables[k->table];
        say("%s/%d%s.%s=%s@%d ", t->name != NULL ? t->name : "-", t->arg, t->key >= 0 ? f.keys[t->key].name : "",
            k->name, k->value != NULL ? k->value : "?", k->line);
    }
    symbols_free(&f);
    return out;
}

TEST(keys)
{
    assert_string_equal(keys_of("bullet.def('n', { sprite = 'orb',\n['hit'] = 'none', [1] = 'x', n = 1 })"),
                        "def/2.sprite=orb@1 def/2.hit=none@2 def/2.n=?@2 ");
    assert_string_equal(keys_of("f { a = { b = 'c' }, { d = 'e' } }"), "f/1.a=?@1 f/1a.b=c@1 f/1.=?@1 f/1.d=e@1 ");
    assert_string_equal(keys_of("local t = { a = 'b' } f((t))"), "-/0.a=b@1 ");
    assert_string_equal(keys_of("f { a = 'b' .. c, d = ('e') }"), "f/1.a=?@1 f/1.d=e@1 ");
}

static int texts_with(const char *text, const char *s, int how)
{
    struct symbols f;
    int n = 0;

    assert_true(read_copy(&f, text, strlen(text)));
    for (int i = 0; i < f.n_texts; i++)
        n += strcmp(f.texts[i].s, s) == 0 && f.texts[i].how == how;
    symbols_free(&f);
    return n;
}

TEST(texts)
{
    static const char joins[] = "return 'a' .. i, i .. 'b', i .. 'c' .. i, 'd', 'e' .. 'f', ('g') .. i, ('h' .. i)";

    assert_int_equal(texts_with(joins, "a", SYMBOL_FIRST), 1);
    assert_int_equal(texts_with(joins, "b", SYMBOL_LAST), 1);
    assert_int_equal(texts_with(joins, "c", SYMBOL_FIRST | SYMBOL_LAST), 1);
    assert_int_equal(texts_with(joins, "d", 0), 1);
    assert_int_equal(texts_with(joins, "e", SYMBOL_FIRST), 1);
    assert_int_equal(texts_with(joins, "f", SYMBOL_LAST), 1);
    assert_int_equal(texts_with(joins, "g", SYMBOL_FIRST), 1);
    assert_int_equal(texts_with(joins, "h", SYMBOL_FIRST), 1);
    assert_int_equal(texts_with("x.y:z { w = 1 }", "y", SYMBOL_KEY), 1);
    assert_int_equal(texts_with("x.y:z { w = 1 }", "z", SYMBOL_KEY), 1);
    assert_int_equal(texts_with("x.y:z { w = 1 }", "w", SYMBOL_KEY), 1);
    assert_int_equal(texts_with("x.y:z { w = 1 }", "x", SYMBOL_KEY), 0);
    assert_int_equal(texts_with("x = '\\x6fr\\98 \\u{e9}\\z  !'", "orb \xc3\xa9!", 0), 1);
    assert_int_equal(texts_with("x = [==[\r\na]]\r\nb]==]", "a]]\nb", 0), 1);
    assert_int_equal(texts_with("x = 'or\\0b'", "", 0), 1);
}

static void result(const char *text, const char *names, bool open)
{
    struct symbols f;

    out[0] = '\0';
    assert_true(read_copy(&f, text, strlen(text)));
    for (int i = 0; i < f.n_keys; i++)
        if (f.result_table >= 0 && f.keys[i].table == f.result_table)
            say("%s ", f.keys[i].name);
    for (int i = 0; i < f.n_members; i++)
        if (f.members[i].local == f.result_local)
            say("%s ", f.members[i].field);
    assert_string_equal(out, names);
    assert_int_equal(f.result_open, open);
    symbols_free(&f);
}

TEST(result)
{
    result("return { a = 1, b = 2 }", "a b ", false);
    result("local m = { a = 1 } function m.b() end m.c, m['d'] = 1, 2 return m", "a b c d ", false);
    result("local m = {} local n = {} n.x = 1 m.y = 1 return m", "y ", false);
    result("local m = {} m.a = 1 m[k] = 2 return m", "a ", true);
    result("local m = {} fill(m) return m", "", true);
    result("local m = setmetatable({}, {}) m.a = 1 return m", "a ", true);
    result("local m = {} m = other return m", "", true);
    result("local m = {} function m.f() return m end return m", "f ", true);
    result("if x then return { a = 1 } end", "", false);
}

TEST(lines)
{
    static const char rom[] = "return {\n title = 'T',\n sheets = {\n  small = {\n   file = 'x' } },\n"
                              " ['sprites'] = { ['a.b'] = { sheet = 'small',\n x = 1 } } }";
    struct symbols f;

    assert_true(read_copy(&f, rom, strlen(rom)));
    assert_int_equal(symbols_line(&f, (const char *const[]){ "title", NULL }), 2);
    assert_int_equal(symbols_line(&f, (const char *const[]){ "sheets", "small", "file", NULL }), 5);
    assert_int_equal(symbols_line(&f, (const char *const[]){ "sheets", "small", "bank", NULL }), 4);
    assert_int_equal(symbols_line(&f, (const char *const[]){ "sprites", "a.b", "x", NULL }), 7);
    assert_int_equal(symbols_line(&f, (const char *const[]){ "font", NULL }), 1);
    symbols_free(&f);
    assert_true(read_copy(&f, "local t = {} return t", 21));
    assert_int_equal(symbols_line(&f, (const char *const[]){ "title", NULL }), 1);
    symbols_free(&f);
}

/* ---- the compiler is the judge ---- */

struct name_count {
    char name[48];
    int reads, writes;
};

struct counts {
    struct name_count list[512];
    int n;
};

static struct name_count *count_of(struct counts *c, const char *name)
{
    for (int i = 0; i < c->n; i++)
        if (strcmp(c->list[i].name, name) == 0)
            return &c->list[i];
    assert_true(c->n < 512);
    snprintf(c->list[c->n].name, sizeof c->list[0].name, "%s", name);
    return &c->list[c->n++];
}

/* A name beyond the first 255 constants of a function is read as GETUPVAL _ENV, LOADK name, GETTABLE. */
static void count_far(struct counts *c, const char *line, int *step)
{
    static char name[48];
    const char *text = strstr(line, "; \"");

    if (strstr(line, "GETUPVAL") != NULL && strstr(line, "; _ENV") != NULL) {
        *step = 1;
    } else if (*step == 1 && strstr(line, "LOADK") != NULL && text != NULL &&
               sscanf(text, "; \"%47[A-Za-z0-9_]\"", name) == 1) {
        *step = 2;
    } else {
        if (*step == 2 && strstr(line, "GETTABLE") != NULL)
            count_of(c, name)->reads++;
        *step = 0;
    }
}

/* Every access to a global in luac's listing of a file. False: it does not compile. */
static bool list_globals(const char *path, struct counts *c)
{
    char command[TREE_PATH + 64], line[512], name[48];
    bool any = false;
    int step = 0;

    snprintf(command, sizeof command, "luac5.4 -l -l -p '%s' 2>&1", path);
    FILE *listing = popen(command, "r");
    assert_non_null(listing);
    while (fgets(line, sizeof line, listing) != NULL) {
        char *note = strstr(line, "; _ENV \"");
        any = true;
        count_far(c, line, &step);
        if (note == NULL || sscanf(note, "; _ENV \"%47[A-Za-z0-9_]\"", name) != 1)
            continue;
        if (strstr(line, "GETTABUP") != NULL)
            count_of(c, name)->reads++;
        if (strstr(line, "SETTABUP") != NULL)
            count_of(c, name)->writes++;
    }
    return pclose(listing) == 0 && any;
}

/* Is the name, or one that names all, among those that script_next_global gives? */
static bool gives(const char *text, size_t n, const char *name)
{
    static const char *const words[] = { "_ENV", "_G" };
    char *copy = malloc(n + (n == 0));
    const char *word;
    size_t at = 0, size;
    bool given = false;

    memcpy(copy, text, n);
    while (!given && script_next_global(copy, n, &at, &word, &size)) {
        given = strlen(name) == size && memcmp(word, name, size) == 0;
        for (int i = 0; i < 2; i++)
            given = given || (strlen(words[i]) == size && memcmp(word, words[i], size) == 0);
    }
    free(copy);
    return given;
}

static void compare_with_luac(const char *path, const char *text, size_t n)
{
    static struct counts want, got;
    struct symbols f;

    memset(&want, 0, sizeof want);
    memset(&got, 0, sizeof got);
    assert_true(list_globals(path, &want));
    assert_true(read_copy(&f, text, n));
    for (int i = 0; i < f.n_globals; i++) {
        struct name_count *one = count_of(&got, f.globals[i].name);
        if (f.globals[i].use == USE_WRITE)
            one->writes++;
        else
            one->reads++;
    }
    symbols_free(&f);
    for (int i = 0; i < want.n; i++) {
        const struct name_count *w = &want.list[i], *g = count_of(&got, w->name);
        if (w->reads != g->reads || w->writes != g->writes)
            print_message("%s: %s: luac %d reads %d writes, here %d and %d\n", path, w->name, w->reads, w->writes,
                          g->reads, g->writes);
        assert_int_equal(w->reads, g->reads);
        assert_int_equal(w->writes, g->writes);
        if (w->reads && !gives(text, n, w->name))
            fail_msg("%s: %s is read, and not given", path, w->name);
    }
    assert_int_equal(got.n, want.n);
}

static bool ends_with(const char *s, const char *tail)
{
    size_t n = strlen(s), m = strlen(tail);

    return n >= m && strcmp(s + n - m, tail) == 0;
}

static int compare_folder(const char *dir)
{
    struct tree files = { 0 };
    char err[512], path[TREE_PATH];
    int n = 0;

    assert_true(tree_walk(dir, &files, err, sizeof err));
    for (int i = 0; i < files.n; i++) {
        uint8_t *text;
        size_t size;
        if (!ends_with(files.name[i], ".lua"))
            continue;
        assert_true(tree_join(path, dir, files.name[i]));
        assert_true(files_read(path, path, TREE_SCRIPT, &text, &size, err, sizeof err));
        compare_with_luac(path, (const char *)text, size);
        free(text);
        n++;
    }
    tree_close(&files);
    return n;
}

TEST(repository)
{
    assert_true(compare_folder("scripts") >= 8);
    assert_true(compare_folder("roms") >= 20);
    assert_true(compare_folder("examples") >= 5);
    assert_true(compare_folder("tests") >= 30);
}

/* ---- programs nobody wrote ---- */

struct writer {
    struct rng rng;
    char *text;
    size_t n;
    int depth, labels;
    bool dots, loop;
};

static unsigned pick(struct writer *w, unsigned n)
{
    return (unsigned)rng_below(&w->rng, n);
}

static void put(struct writer *w, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    int n = vsnprintf(w->text + w->n, TEXT - w->n, format, args);
    va_end(args);
    assert_true(n >= 0 && (size_t)n < TEXT - w->n);
    w->n += (size_t)n;
}

static const char *word(struct writer *w)
{
    static const char *const words[] = { "a", "b", "c", "d", "foo", "bar", "pairs", "self", "x1", "_y" };

    return words[pick(w, 10)];
}

static void put_expr(struct writer *w);
static void put_block(struct writer *w);

static void put_list(struct writer *w)
{
    for (unsigned n = pick(w, 3); n > 0; n--) {
        put_expr(w);
        put(w, ", ");
    }
    put_expr(w);
}

static void put_function(struct writer *w)
{
    bool dots = w->dots, loop = w->loop;

    w->dots = pick(w, 2);
    w->loop = false;
    put(w, "(");
    unsigned n = pick(w, 3);
    for (unsigned i = 0; i < n; i++)
        put(w, "%s%s", i > 0 ? ", " : "", word(w));
    put(w, w->dots ? n > 0 ? ", ..." : "..." : "");
    put(w, ")\n");
    put_block(w);
    put(w, " end");
    w->dots = dots;
    w->loop = loop;
}

static void put_table(struct writer *w)
{
    put(w, "{ ");
    for (unsigned n = pick(w, 4); n > 0; n--) {
        unsigned how = pick(w, 3);
        if (how == 0)
            put(w, "%s = ", word(w));
        if (how == 1) {
            put(w, "[ ");
            put_expr(w);
            put(w, "] = ");
        }
        put_expr(w);
        put(w, pick(w, 2) ? ", " : "; ");
    }
    put(w, "}");
}

/* What may be indexed and called. */
static void put_prefix(struct writer *w)
{
    if (pick(w, 5) == 0) {
        put(w, "(");
        put_expr(w);
        put(w, ")");
    } else {
        put(w, "%s", word(w));
    }
    for (unsigned n = pick(w, 3); n > 0; n--) {
        unsigned how = pick(w, 3);
        if (how == 0) {
            put(w, ".%s", word(w));
        } else if (how == 1) {
            put(w, "[ ");
            put_expr(w);
            put(w, "]");
        } else {
            put(w, "(");
            put_list(w);
            put(w, ")");
        }
    }
}

static void put_call(struct writer *w)
{
    put_prefix(w);
    if (pick(w, 3) == 0)
        put(w, ":%s", word(w));
    unsigned how = pick(w, 4);
    if (how == 0) {
        put(w, " 's\\n'");
    } else if (how == 1) {
        put_table(w);
    } else {
        put(w, "(");
        if (how == 2)
            put_list(w);
        put(w, ")");
    }
}

static void put_simple(struct writer *w)
{
    static const char *const plain[] = { "nil",   "true", "false", "0",        "1.5",    "0x1F",     "3e-2",
                                         "\"s\"", "'q'",  "[[l]]", "[=[\n]=]", "'\\65'", "'\\u{7a}'" };
    unsigned how = w->depth > 5 ? 0 : pick(w, 6);

    if (how <= 1)
        put(w, "%s", plain[pick(w, 13)]);
    else if (how == 2)
        put_prefix(w);
    else if (how == 3)
        put_table(w);
    else if (how == 4)
        put(w, "%s", w->dots ? "..." : word(w));
    else
        put(w, "function"), put_function(w);
}

static void put_expr(struct writer *w)
{
    static const char *const ops[] = { "+",  "-", "*",  "/",   "//", "%", "^", "..", "==", "~=", "<",
                                       "<=", ">", ">=", "and", "or", "&", "|", "~",  "<<", ">>" };
    static const char *const signs[] = { "not ", "- ", "#", "~" };

    w->depth++;
    if (pick(w, 5) == 0)
        put(w, "%s", signs[pick(w, 4)]);
    put_simple(w);
    while (w->depth < 6 && pick(w, 3) == 0) {
        put(w, " %s ", ops[pick(w, 21)]);
        put_simple(w);
    }
    w->depth--;
}

static void put_local(struct writer *w)
{
    unsigned how = pick(w, 4);

    if (how == 0) {
        put(w, "local function %s", word(w));
        put_function(w);
        return;
    }
    put(w, "local %s", word(w));
    if (how == 1)
        put(w, ", k <const>, %s", word(w));
    if (how < 3) {
        put(w, " = ");
        put_list(w);
    }
}

static void put_assignment(struct writer *w)
{
    for (unsigned n = pick(w, 3) + 1; n > 0; n--) {
        unsigned how = pick(w, 3);
        put(w, "%s", word(w));
        if (how == 1)
            put(w, ".%s", word(w));
        if (how == 2)
            put(w, "[ "), put_expr(w), put(w, "]");
        put(w, n > 1 ? ", " : " = ");
    }
    put_list(w);
}

static void put_loop(struct writer *w)
{
    unsigned how = pick(w, 4);
    bool loop = w->loop;

    w->loop = true;
    if (how == 0) {
        put(w, "while "), put_expr(w), put(w, " do\n");
    } else if (how == 1) {
        put(w, "for %s = ", word(w)), put_expr(w), put(w, ", "), put_expr(w), put(w, " do\n");
    } else if (how == 2) {
        put(w, "for %s, %s in ", word(w), word(w)), put_list(w), put(w, " do\n");
    } else {
        put(w, "repeat\n");
    }
    put_block(w);
    w->loop = loop;
    if (how == 3)
        put(w, " until "), put_expr(w);
    else
        put(w, " end");
}

static void put_statement(struct writer *w)
{
    switch (pick(w, w->depth > 4 ? 4 : 9)) {
    case 0:
    case 5:
        put_local(w);
        break;
    case 1:
        put_assignment(w);
        break;
    case 2:
        put_call(w);
        break;
    case 3:
        put(w, "do goto L%d local q = r ::L%d:: end", w->labels, w->labels);
        w->labels++;
        break;
    case 4:
        put(w, "if "), put_expr(w), put(w, " then\n"), put_block(w);
        if (pick(w, 2))
            put(w, " elseif "), put_expr(w), put(w, " then "), put_block(w);
        if (pick(w, 2))
            put(w, " else "), put_block(w);
        put(w, " end");
        break;
    case 6:
        put(w, "function %s", word(w));
        if (pick(w, 2))
            put(w, ".%s", word(w));
        if (pick(w, 3) == 0)
            put(w, ":%s", word(w));
        put_function(w);
        break;
    case 7:
        put(w, "do "), put_block(w), put(w, " end");
        break;
    default:
        put_loop(w);
    }
    put(w, ";%s", pick(w, 3) ? "\n" : " --[[ c ]] ");
}

static void put_block(struct writer *w)
{
    w->depth++;
    for (unsigned n = pick(w, w->depth > 4 ? 2 : 4); n > 0; n--)
        put_statement(w);
    if (w->loop && pick(w, 4) == 0)
        put(w, "break ");
    else if (pick(w, 5) == 0)
        put(w, "return "), put_list(w), put(w, ";");
    w->depth--;
}

/* Assigning to k, a constant, and more than luac's short forms can name are the only ways not to compile; the words
 * above have neither. */
TEST(programs)
{
    char dir[] = "/tmp/names-XXXXXX", path[64];
    struct writer w = { .text = malloc(TEXT) };

    assert_non_null(mkdtemp(dir));
    snprintf(path, sizeof path, "%s/a.lua", dir);
    for (uint64_t seed = 0; seed < 150; seed++) {
        rng_seed(&w.rng, seed);
        w.n = 0;
        w.dots = true;
        for (int i = 0; i < 12; i++)
            put(&w, "do "), put_block(&w), put(&w, " end\n");
        FILE *file = fopen(path, "wb");
        assert_true(file != NULL && fwrite(w.text, 1, w.n, file) == w.n && fclose(file) == 0);
        assert_true(compiles(w.text, w.n));
        compare_with_luac(path, w.text, w.n);
    }
    remove(path);
    rmdir(dir);
    free(w.text);
}

/* Scripts with a few tokens changed: what still compiles is read whole, and nothing is read beyond the end. */
TEST(spoilt)
{
    static const char *const bits[] = { " end ", " local ", "(",  ")",  "{",  "}",         "=",    ",",  " ",
                                        "\n",    "[[",      "]]", "'",  "..", "function ", " do ", "--", "0",
                                        "::",    ".",       ":",  "\\", "\0", " not ",     " x ",  "<" };
    struct writer w = { .text = malloc(TEXT) };
    int good = 0;

    rng_seed(&w.rng, 7);
    for (int round = 0; round < 4000; round++) {
        struct symbols f;
        w.n = 0;
        w.dots = true;
        w.loop = false;
        w.depth = 2;
        put_block(&w);
        for (unsigned n = pick(&w, 3); n > 0 && w.n > 0; n--) {
            size_t at = pick(&w, (unsigned)w.n), cut = pick(&w, 3);
            const char *bit = bits[pick(&w, 26)];
            size_t size = bit[0] == '\0' ? 1 : strlen(bit);
            cut = cut < w.n - at ? cut : w.n - at;
            memmove(w.text + at + size, w.text + at + cut, w.n - at - cut);
            memcpy(w.text + at, bit, size);
            w.n = w.n - cut + size;
        }
        bool whole = read_copy(&f, w.text, w.n), compiled = compiles(w.text, w.n);
        if (compiled && !whole)
            print_message("%.*s\n", (int)w.n, w.text);
        assert_true(whole || !compiled);
        for (int i = 0; compiled && i < f.n_globals; i++) {
            if (f.globals[i].use != USE_WRITE && !gives(w.text, w.n, f.globals[i].name))
                fail_msg("%s is read, and not given:\n%.*s", f.globals[i].name, (int)w.n, w.text);
        }
        good += compiled;
        symbols_free(&f);
    }
    assert_true(good > 1000 && good < 4000);
    free(w.text);
}

/* ---- hostile texts ---- */

static void repeat(char *text, size_t *n, const char *head, const char *bit, int times, const char *tail)
{
    *n = strlen(head);
    memcpy(text, head, *n);
    for (int i = 0; i < times; i++, *n += strlen(bit))
        memcpy(text + *n, bit, strlen(bit));
    memcpy(text + *n, tail, strlen(tail));
    *n += strlen(tail);
}

TEST(deep)
{
    static const struct {
        const char *head, *bit, *tail;
    } deep[] = {
        { "x = ", "(", "" },
        { "x = ", "{", "" },
        { "x = ", "{a=", "" },
        { "x = ", "not ", "1" },
        { "x = ", "- ", "1" },
        { "x = ", "a..", "a" },
        { "x = ", "a^", "a" },
        { "f", "(f", "" },
        { "", "do ", "" },
        { "", "if x then ", "" },
        { "", "function f() ", "" },
        { "x = ", "function() return ", "" },
        { "", "while x do ", "" },
        { "x", "[x", "" },
        { "", "repeat ", "" },
        { "f", "{f", "" },
        { "", "for i = 1, 2 do ", "" },
        { "x = ", "a..(", "" },
    };
    char *text = malloc(TEXT * 4);
    struct symbols f;
    size_t n;

    for (size_t i = 0; i < sizeof deep / sizeof deep[0]; i++) {
        repeat(text, &n, deep[i].head, deep[i].bit, 50000, deep[i].tail);
        assert_false(read_copy(&f, text, n));
        symbols_free(&f);
    }
    for (int times = 150; times < 260; times++) { /* around the compiler's own limit */
        repeat(text, &n, "x = ", "a..", times, "a");
        assert_true(read_copy(&f, text, n) || !compiles(text, n));
        symbols_free(&f);
        repeat(text, &n, "", "do ", times, "");
        size_t head = n;
        for (int k = 0; k < times; k++, n += 4)
            memcpy(text + n, "end ", 4);
        assert_true(n > head && (read_copy(&f, text, n) || !compiles(text, n)));
        symbols_free(&f);
        repeat(text, &n, "", "local a ", times, "");
        assert_int_equal(read_copy(&f, text, n), compiles(text, n));
        symbols_free(&f);
    }
    free(text);
}

TEST(long)
{
    static const struct {
        const char *head, *bit, *tail;
        bool whole;
    } wide[] = {
        { "x = '", "abcdefgh", "'", true }, { "x = '", "abcdefgh", "", false }, { "x = [[", "ab\ncdefg", "]]", true },
        { "-- ", "abcdefgh", "", true },    { "x = {", "1,", "}", true },       { "x = 1", "+1", "", true },
        { "f(", "1,", "1)", true },         { "", "x = 1 ", "", true },         { "x = ", "1234567", "", true },
        { "x = y", ".y", "", true },        { "x = f", "()", "", true },        { "", "local x ", "", false },
        { "", "\r\n\n\r", "x = y", true },  { "x", ",x", "=1", true },          { "x = '", "\\z \n", "'", true },
    };
    char *text = malloc(TEXT * 2);
    struct symbols f;
    size_t n;

    for (size_t i = 0; i < sizeof wide / sizeof wide[0]; i++) {
        repeat(text, &n, wide[i].head, wide[i].bit, (int)(TEXT / strlen(wide[i].bit)), wide[i].tail);
        assert_int_equal(read_copy(&f, text, n), wide[i].whole);
        symbols_free(&f);
    }
    memset(text, 0, TEXT);
    assert_false(read_copy(&f, text, TEXT));
    symbols_free(&f);
    free(text);
}

TEST(zero_bytes)
{
    static const char in_string[] = "x = 'a\0b' y = z", in_code[] = "x = 1 \0 y = 2", in_comment[] = "-- \0 x\ny = 1";
    struct symbols f;

    assert_true(read_copy(&f, in_string, sizeof in_string - 1));
    assert_int_equal(f.n_globals, 3);
    symbols_free(&f);
    assert_false(read_copy(&f, in_code, sizeof in_code - 1));
    symbols_free(&f);
    assert_true(read_copy(&f, in_comment, sizeof in_comment - 1));
    assert_int_equal(f.globals[0].line, 2);
    symbols_free(&f);
}

RUN_TESTS(NULL, NULL)

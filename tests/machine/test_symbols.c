/*
 * test_symbols.c - symbols.h: every construct of Lua, what is found in it, and that names are resolved as the Lua
 * compiler resolves them: luac's listing of each script of the repository, and of changed ones, is the judge.
 */
#define _POSIX_C_SOURCE 200809L /* popen, mkdtemp */
#include <ctype.h>
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
    /* reads and writes of globals, whose scopes luac judges below */
    { "", "" },
    { "foo = 1", "foo=" },
    { "local foo = 1 foo = 2 print(foo)", "print" },
    { "local foo = foo", "foo" },
    { "local a <const>, b <close> = 1, nil return a, b", "" },
    { "local f = function() return f() end", "f" },
    { "function t:m(x) self.y, z = x end", "t:m= z=" },
    { "local t = {} function t.f() end function t:g() return self, h end", "h" },
    { "a['b'] = c[\"d\"]", "a.b= c.d" },
    { "a[b] = c[d]", "b a d c[]" },
    { "a:b(c)", "a:b() c" },
    { "a:b 'x' a:b { c = d }", "a:b() a:b() d" },
    { "f 'x' f { y } f { y = z; [w] = v, u }", "f f y f z w v u" },
    { "local a a.b = 1 a[c] = 2 a.d.e = f", "c f" },
    { "a, b.c, d[1] = 1, 2, 3", "a= b.c= d" },
    { "x = 1\ny = 2\r\nz = 3\n\rw = 4", "x= y=@2 z=@3 w=@4" },
    { "--[[ a\nb ]] c = 1 -- d\ne = 2 --[==[ ]] ]==] f()", "c=@2 e=@3 f@3" },
    { "x = [[\n\n]] y = 1", "x= y=@3" },
    { "x = 'a\\\nb' y = 'a\\z \n  b' z = 1", "x= y=@2 z=@3" },
    /* _G and _ENV */
    { "_G.foo = _ENV.bar", "foo= bar" },
    { "_G.a.b = 1 return _G[x]", "a.b= x _G[]" },
    { "local _ENV = {} foo = bar", "" },
    { "do local _ENV = f foo = 1 end foo = 2", "f foo=" },
    { "local function f(_ENV) return foo end return foo", "foo" },
    /* the nearest local */
    { "local count = 1 return conut", "conut~count" },
    { "local wave, wait_ = 1, 2 return wavy", "wavy~wave" },
    /* things that are no tables */
    { "pairs(bullet.fire { x = 1 })", "pairs bullet.fire {pairs bullet.fire}" },
    { "local b = bullet.fire {} for k in ipairs(b) do end", "bullet.fire ipairs {ipairs bullet.fire}" },
    { "local b\nb = f()\nreturn function() return #b end", "f@2 {# f}@3" },
    { "local b = f() return function() b = {} return #b end", "f" },
    { "local b b = f() b = g() return #b", "f g" },
    { "local a, b = f(), g() return #a, #b", "f g {# f} {# g}" },
    { "local a = f() or {} return #a", "f" },
    { "local a = (f()) return #a, #(f())", "f f {# f} {# f}" },
    { "local pairs = each pairs(f())", "each f" },
    { "local t = {} return #t, #'x', #t.y", "" },
    { "each('t', function(b, i) return #b, #i end)", "each {# each/2/1} {# each/2/2}" },
    { "def('n', { run = function(e) return #e end, f = function(e) e = {} return #e end })", "def {# def/2.run/1}" },
    { "a.b { c = { { d = function(x) return #x end } } }", "a.b {# a.b/1.d/1}" },
    { "a.b(function(x) return function(x) return #x end end)", "a.b" },
    /* divisions */
    { "return 0/0, -(0/0), 0.0/0, 0/-0, 0x0/0", "<0/0> <0/0> <0/0> <0/0> <0/0>" },
    { "return 1/0, -1/0, x/0, x//0, x%0.0, 3%0", "x x x <n/0> <n/0> <x/0> <x//0> <x%0> <n%0>" },
    { "return 1/2/0, 0/1, x/(0), x/0e5, x/.0", "x x x <x/0> <x/0> <x/0> <x/0>" },
    /* formats */
    { "string.format('%d', 1) string.format(f, 2); ('%s'):format(3)", "string.format string.format f \"%d\" \"%s\"" },
    { "local s = 'x' s:format(1) ('a'):rep(2):format(3)", "" },
    /* what the compiler refuses */
    { "x = = 1", "(not whole)" },
    { "x = 'abc", "(not whole)" },
    { "x = 3x", "(not whole)" },
    { "return 1 x()", "(not whole)" },
};

TEST(table)
{
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        const char *got = found(table[i].text), *refused = strstr(table[i].want, "(not whole)");
        if (refused ? strstr(got, "(not whole)") == NULL : strcmp(got, table[i].want) != 0)
            fail_msg("%s\nwant %s\ngot  %s\n", table[i].text, table[i].want, got);
        assert_int_equal(compiles(table[i].text, strlen(table[i].text)), refused == NULL);
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
            fail_msg("%s: %s: luac %d reads %d writes, here %d and %d\n", path, w->name, w->reads, w->writes, g->reads,
                     g->writes);
        if (w->reads && !gives(text, n, w->name))
            fail_msg("%s: %s is read, and not given", path, w->name);
    }
    assert_int_equal(got.n, want.n);
}

/* A script and its path. */
struct script {
    char path[TREE_PATH], *text;
    size_t n;
};

enum { MAX_SCRIPTS = 1000 };
static struct script scripts[MAX_SCRIPTS];
static int n_scripts;

static void add_folder(const char *dir)
{
    struct tree files = { 0 };
    char err[512];

    assert_true(tree_walk(dir, &files, err, sizeof err));
    for (int i = 0; i < files.n; i++) {
        const char *end = strrchr(files.name[i], '.');
        struct script *s = &scripts[n_scripts];
        if (!end || strcmp(end, ".lua"))
            continue;
        assert_true(n_scripts < MAX_SCRIPTS && tree_join(s->path, dir, files.name[i]));
        assert_true(files_read(s->path, s->path, TREE_SCRIPT, (uint8_t **)&s->text, &s->n, err, sizeof err));
        n_scripts++;
    }
    tree_close(&files);
}

TEST(repository)
{
    for (int i = 0; i < n_scripts; i++)
        compare_with_luac(scripts[i].path, scripts[i].text, scripts[i].n);
}

/* Puts `size` bytes in the place of `cut` others. */
static void replace(struct script *s, size_t at, size_t cut, const char *bytes, size_t size)
{
    cut = cut < s->n - at ? cut : s->n - at;
    memmove(s->text + at + size, s->text + at + cut, s->n - at - cut);
    memcpy(s->text + at, bytes, size);
    s->n = s->n - cut + size;
}

static bool is_word(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* The word at a place drawn at random; its length may be 0. */
static size_t draw_word(struct rng *rng, const struct script *s, size_t *length)
{
    size_t at = (size_t)rng_below(rng, s->n);

    while (at > 0 && is_word(s->text[at - 1]))
        at--;
    for (*length = 0; at + *length < s->n && is_word(s->text[at + *length]);)
        ++*length;
    return at;
}

/* Replaces a word by another one of the script, or any bytes by a token. */
static void change(struct rng *rng, struct script *s)
{
    static const char *const tokens[] = {
        " end ", " local ", "(",         ")",    "{",   "}",  "=", ",",  "\n", "[[",
        "]]",    "'",       "function ", " do ", " --", "::", ".", "\\", "<",  " not "
    };
    char word[64];
    size_t length, other_length, at = draw_word(rng, s, &length), other = draw_word(rng, s, &other_length);

    if (rng_below(rng, 4) == 0) {
        const char *token = tokens[rng_below(rng, sizeof tokens / sizeof *tokens)];
        replace(s, at, (size_t)rng_below(rng, 3), token, strlen(token));
    } else if (length && other_length && other_length < sizeof word) {
        memcpy(word, s->text + other, other_length);
        replace(s, at, length, word, other_length);
    }
}

/* Scripts with some words exchanged: what still compiles is read whole, and as the compiler reads it. */
TEST(changed)
{
    char dir[] = "/tmp/names-XXXXXX";
    struct script s = { .text = malloc(TREE_SCRIPT + 1000) };
    struct rng rng;
    int good = 0;

    assert_non_null(mkdtemp(dir));
    snprintf(s.path, sizeof s.path, "%s/a.lua", dir);
    rng_seed(&rng, 7);
    for (int round = 0; round < 3000; round++) {
        const struct script *of = &scripts[rng_below(&rng, (uint64_t)n_scripts)];
        struct symbols f;
        memcpy(s.text, of->text, s.n = of->n);
        for (int i = 0; i < 4; i++)
            change(&rng, &s);
        const bool whole = read_copy(&f, s.text, s.n), compiled = compiles(s.text, s.n);
        symbols_free(&f);
        if (compiled && !whole)
            fail_msg("%s: not read whole:\n%.*s", of->path, (int)s.n, s.text);
        if (!compiled || rng_below(&rng, 4))
            continue;
        FILE *file = fopen(s.path, "wb");
        assert_true(file != NULL && fwrite(s.text, 1, s.n, file) == s.n && fclose(file) == 0);
        compare_with_luac(s.path, s.text, s.n);
        good++;
    }
    assert_in_range(good, 100, 700);
    remove(s.path);
    rmdir(dir);
    free(s.text);
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
        { "x = ", "(", "" },    { "x = ", "{", "" },   { "x = ", "not ", "1" },
        { "x = ", "a..", "a" }, { "", "do ", "" },     { "x = ", "function() return ", "" },
        { "x", "[x", "" },      { "", "repeat ", "" },
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
        { "x = 1", "+1", "", true },        { "f(", "1,", "1)", true },         { "x = ", "1234567", "", true },
        { "x = f", "()", "", true },        { "", "local x ", "", false },      { "x", ",x", "=1", true },
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

static int setup(void **state)
{
    (void)state;
    add_folder("scripts");
    add_folder("roms");
    add_folder("examples");
    add_folder("tests");
    return n_scripts > 100 ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    while (n_scripts-- > 0)
        free(scripts[n_scripts].text);
    return 0;
}

RUN_TESTS(setup, teardown)

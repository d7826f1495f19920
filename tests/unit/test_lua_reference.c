/*
 * test_lua_reference.c - every function of lualib.h against the linked Lua's own: the same random and extreme calls, in
 * a stock state and in ours, must give the same results bit for bit, leave the same in the tables they were given, or
 * raise the same error. What may differ stands in `exemptions`, with the reason; each has to occur.
 *
 * A difference is printed as the call in Lua; nan and minus_nan stand there for the two of them, which Lua cannot
 * write. CURTAIN_SEED=n tries other calls. CURTAIN_CALLS=n makes as many of each function.
 */
#include <math.h>
#include "../test.h"
#include "luagen.h"
#include "luapair.h"

/* A call and what came of it in both states. */
struct answer {
    bool ok;
    struct out values; /* results, a line a turn when the first is a function; or the error */
    struct out after;  /* the tables among the arguments */
};

struct call {
    const char *name; /* "string.find" */
    struct out source;
    lua_Number x; /* the first argument, if that is a number */
    struct answer stock, ours;
};

/* ---- values as text ---- */

enum { DEEP = 3, LONG = 5000, TURNS = 60, SPAN = 2000, WORK_TEXT = 1 << 20 };

static void dump(struct out *o, lua_State *L, int idx, int deep);

static int in_order(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* The entries in the order of their texts. */
static void dump_table(struct out *o, lua_State *L, int idx, int deep)
{
    char *entries[2 * SPAN];
    size_t n = 0;

    luaL_checkstack(L, 10, NULL);
    lua_pushnil(L);
    while (lua_next(L, idx)) {
        struct out entry = { 0 };
        dump(&entry, L, lua_gettop(L) - 1, deep + 1);
        say(&entry, "=");
        dump(&entry, L, lua_gettop(L), deep + 1);
        assert_in_range(n, 0, sizeof entries / sizeof *entries - 1);
        entries[n++] = entry.s;
        lua_pop(L, 1);
    }
    qsort(entries, n, sizeof *entries, in_order);
    say(o, "{");
    for (size_t i = 0; i < n; i++) {
        say_bytes(o, entries[i], strlen(entries[i]));
        say(o, " ");
        free(entries[i]);
    }
    say(o, "}");
}

static void dump_text(struct out *o, const char *s, size_t n)
{
    uint32_t hash = 0;

    say_quoted(o, s, n < LONG ? n : LONG);
    for (size_t i = 0; i < n; i++)
        hash = (hash ^ (unsigned char)s[i]) * 16777619u;
    if (n >= LONG)
        say(o, "..%zu bytes, hash %x", n, (unsigned)hash);
}

static void dump(struct out *o, lua_State *L, int idx, int deep)
{
    size_t n;

    switch (lua_type(L, idx)) {
    case LUA_TNUMBER:
        if (lua_isinteger(L, idx))
            say(o, "%lld", (long long)lua_tointeger(L, idx));
        else
            say(o, isnan(lua_tonumber(L, idx)) ? "nan" : "%a", lua_tonumber(L, idx));
        break;
    case LUA_TSTRING: {
        const char *s = lua_tolstring(L, idx, &n);
        dump_text(o, s, n);
        break;
    }
    case LUA_TTABLE:
        if (deep < DEEP)
            dump_table(o, L, idx, deep);
        else
            say(o, "{..}");
        break;
    default:
        say(o, "%s", lua_isboolean(L, idx) ? lua_toboolean(L, idx) ? "true" : "false" : luaL_typename(L, idx));
    }
}

/* ---- a call in one state ---- */

/* The values from this stack index on, as a line. */
static void dump_values(struct out *o, lua_State *L, int from)
{
    int top = lua_gettop(L);

    for (int i = from; i <= top && i < from + SPAN; i++) {
        dump(o, L, i, 0);
        say(o, "; ");
    }
    say(o, "%d\n", top - from + 1);
}

static void dump_error(struct out *o, lua_State *L)
{
    if (lualib_is_raised(L, -1))
        lualib_push_error_value(L, -1);
    dump(o, L, lua_gettop(L), 0);
}

/* Calls the iterator at stack index f as a for does; any other function that came back is treated alike. */
static void iterate(struct answer *a, lua_State *L, int f)
{
    lua_settop(L, f + 2);
    for (int turn = 0; turn < TURNS; turn++) {
        lua_pushvalue(L, f);
        lua_pushvalue(L, f + 1);
        lua_pushvalue(L, f + 2);
        if (lua_pcall(L, 2, LUA_MULTRET, 0) != LUA_OK) {
            dump_error(&a->values, L);
            return;
        }
        dump_values(&a->values, L, f + 3);
        lua_settop(L, f + 3);
        if (lua_isnil(L, -1))
            return;
        lua_replace(L, f + 2);
    }
}

/* True when stock would be at it for ever, or fill the machine's memory. The stack: the function and its arguments. */
static bool too_large(lua_State *L, const char *name)
{
    lua_Integer a = lua_tointeger(L, 2), b = lua_tointeger(L, 3), c = lua_tointeger(L, 4);
    size_t n = lua_type(L, 2) == LUA_TSTRING ? lua_rawlen(L, 2) : 30;

    if (strcmp(name, "string.rep") == 0) {
        n += lua_type(L, 4) == LUA_TSTRING ? lua_rawlen(L, 4) : 0;
        return b > WORK_TEXT / 64 && (n == 0 || (lua_Unsigned)b < (lua_Unsigned)1 << 50);
    }
    if (strcmp(name, "table.move") == 0) /* from b to c */
        return c >= b && (lua_Unsigned)c - (lua_Unsigned)b > SPAN && (b > 0 || c < LUA_MAXINTEGER + b);
    if (strcmp(name, "table.insert") == 0 || strcmp(name, "table.remove") == 0) /* from b to a length below 0 */
        return b < -SPAN && luaL_getmetafield(L, 2, "__len") != LUA_TNIL;
    if (strcmp(name, "table.concat") == 0)
        return lua_tointeger(L, 5) >= c && (lua_Unsigned)lua_tointeger(L, 5) - (lua_Unsigned)c > SPAN &&
               luaL_getmetafield(L, 2, "__index") != LUA_TNIL;
    if (strcmp(name, "table.unpack") == 0)
        return c >= b && (lua_Unsigned)c - (lua_Unsigned)b > SPAN && (lua_Unsigned)c - (lua_Unsigned)b < 2000000;
    if (strcmp(name, "pcall") == 0 || strcmp(name, "string.gsub") == 0)
        return strstr(lua_typename(L, lua_type(L, 2)), "function") && (a | b | c) >> 20;
    return false;
}

/* False: the call is not made. */
static bool answer(lua_State *L, struct call *call, struct answer *a)
{
    struct out chunk = { 0 };

    lua_settop(L, 0);
    say(&chunk, "return %s, ", call->name);
    say_bytes(&chunk, call->source.s, call->source.n);
    if (luaL_loadbufferx(L, chunk.s, call->source.n ? chunk.n : chunk.n - 2, "=t", "t") != LUA_OK)
        fail_msg("%s\n%s", chunk.s, lua_tostring(L, -1));
    free(chunk.s);
    if (lua_pcall(L, 0, LUA_MULTRET, 0) != LUA_OK)
        return false; /* an argument could not be made: a number has no method rep */
    int n = lua_gettop(L);
    if (too_large(L, call->name))
        return false;
    call->x = lua_tonumber(L, 2);
    lua_checkstack(L, n + 10);
    for (int i = 1; i <= n; i++)
        lua_pushvalue(L, i);
    a->ok = lua_pcall(L, n - 1, LUA_MULTRET, 0) == LUA_OK;
    a->values.n = a->after.n = 0;
    if (!a->ok)
        dump_error(&a->values, L);
    else
        dump_values(&a->values, L, n + 1);
    if (a->ok && lua_isfunction(L, n + 1))
        iterate(a, L, n + 1);
    say(&a->after, " ");
    for (int i = 2; i <= n; i++)
        if (lua_type(L, i) == LUA_TTABLE)
            dump(&a->after, L, i, 0);
    return true;
}

/* ---- what may differ ---- */

static bool says(const struct answer *a, const char *what)
{
    return strstr(a->values.s, what) != NULL;
}

static bool same_tables(const struct call *c)
{
    return strcmp(c->stock.after.s, c->ours.after.s) == 0;
}

/* Stock's values with every ": 0x" and the digits behind it left out. */
static bool address(const struct call *c)
{
    char *text = strdup(c->stock.values.s), *at = text;

    while ((at = strstr(at, ": 0x")) != NULL) {
        const size_t n = 4 + strspn(at + 4, "0123456789abcdef");
        memmove(at, at + n, strlen(at + n) + 1);
    }
    const bool same = strcmp(text, c->ours.values.s) == 0 && says(&c->stock, ": 0x");
    free(text);
    return same;
}

/* As address, but padded, or cut off by a precision. */
static bool address_formatted(const struct call *c)
{
    return says(&c->stock, ": 0x") || says(&c->stock, "table") || says(&c->stock, "functi") || strchr(c->source.s, '{');
}

/* But for signs, and blanks, which depend on them. */
static bool nan_sign(const struct call *c)
{
    const struct answer *answers[] = { &c->stock, &c->ours };
    char *text[2];

    for (int i = 0; i < 2; i++) {
        char *to = text[i] = strdup(answers[i]->values.s);
        for (const char *s = text[i]; *s; s++)
            if (!strchr("-+ ", *s))
                *to++ = *s;
        *to = '\0';
    }
    bool same = strstr(c->source.s, "minus_nan") && strcmp(text[0], text[1]) == 0;
    free(text[0]);
    free(text[1]);
    return same;
}

static bool conversion_refused(const struct call *c)
{
    return strchr("aAp", strstr(c->ours.values.s, "' to 'format'")[-1]);
}

static bool fault_order(const struct call *c)
{
    return says(&c->ours, "invalid conversion") || says(&c->ours, "cannot have modifiers") ||
           says(&c->ours, "no value") || says(&c->ours, "'__tostring' must return a string");
}

static bool quoted_float(const struct call *c)
{
    return strstr(c->source.s, "%q") && says(&c->stock, "0x");
}

static bool is_pattern_function(const struct call *c)
{
    return strncmp(c->name, "string.", 7) == 0 && strstr("find match gmatch gsub", c->name + 7);
}

static bool pattern_flaw(const struct call *c)
{
    return is_pattern_function(c) &&
           (says(&c->ours, "malformed pattern") || says(&c->ours, "missing '[' after '%f' in pattern") ||
            says(&c->ours, "pattern capture") || says(&c->ours, "invalid capture index %") ||
            says(&c->ours, "unfinished capture"));
}

/* The angle is off by a rounding of x, which matters when x is large; so a tangent is compared as an angle too. */
static bool trigonometry(const struct call *c)
{
    static const char names[] = "math.sin math.cos math.asin math.acos math.atan";
    double a = strtod(c->stock.values.s, NULL), b = strtod(c->ours.values.s, NULL);
    double most = 3e-9 + fabs(c->x) * 3e-16;

    if (strcmp(c->name, "math.tan") == 0)
        return fabs(remainder(atan(a) - atan(b), acos(-1))) <= most;
    return strstr(names, c->name) && fabs(a - b) <= most;
}

static void by_line(const struct answer *a, char *lines[TURNS + 2], size_t *n, char **copy)
{
    *copy = strdup(a->values.s);
    *n = 0;
    for (char *s = strtok(*copy, "\n"); s; s = strtok(NULL, "\n"))
        lines[(*n)++] = s;
    qsort(lines, *n, sizeof *lines, in_order);
}

static bool pairs_order(const struct call *c)
{
    char *a[TURNS + 2], *b[TURNS + 2], *a_copy, *b_copy;
    size_t a_n, b_n;

    by_line(&c->stock, a, &a_n, &a_copy);
    by_line(&c->ours, b, &b_n, &b_copy);
    bool same = a_n == b_n;
    for (size_t i = 0; same && i < a_n; i++)
        same = strcmp(a[i], b[i]) == 0;
    free(a_copy);
    free(b_copy);
    return same;
}

/* Values that are equal, but not the same, or for which the comparator says nothing. */
static bool sort_stable(const struct call *c)
{
    static const char *const equal[] = { "// 2", "type(a)", "return true", "function() end",
                                         "nan",  ".0",      "0x1p",        ", tostring" };

    for (size_t i = 0; i < sizeof equal / sizeof *equal; i++)
        if (strstr(c->source.s, equal[i]))
            return true;
    return false;
}

static bool sort_writes(const struct call *c)
{
    return strstr(c->source.s, "__index") || strstr(c->source.s, "__newindex");
}

static bool sort_untouched(const struct call *c)
{
    return strcmp(c->stock.values.s, c->ours.values.s) == 0 || strstr(c->source.s, "error(") ||
           (says(&c->stock, "attempt to ") && says(&c->ours, "attempt to "));
}

/* Of several pcalls around it the innermost catches it in stock. */
static bool pcall_fault(const struct call *c)
{
    const char *stock = c->stock.values.s;

    while (strncmp(stock, "true; ", 6) == 0)
        stock += 6;
    return strncmp(stock, "false; ", 7) == 0 && strncmp(stock + 7, c->ours.values.s, strlen(c->ours.values.s)) == 0;
}

static bool load_reader(const struct call *c)
{
    return strncmp(c->stock.values.s, "nil; ", 5) == 0 &&
           strncmp(c->stock.values.s + 5, c->ours.values.s, strlen(c->ours.values.s)) == 0;
}

/* In which of the two states the call succeeded. */
enum success {
    NEITHER = 1 << 0,
    STOCK_ALONE = 1 << 1,
    OURS_ALONE = 1 << 2,
    BOTH = 1 << 3,
    NOT_OURS = NEITHER | STOCK_ALONE,
    ANY = NOT_OURS | OURS_ALONE | BOTH
};

static const struct exemption {
    const char *name; /* of the function; NULL: any */
    enum success success;
    const char *stock, *ours; /* texts in what came of it; NULL: any */
    bool (*holds)(const struct call *);
    const char *why; /* "some releases": of Lua 5.4, it need not occur */
} exemptions[] = {
    { NULL, BOTH, NULL, NULL, address, "texts hold no address" },
    { "string.format", BOTH, NULL, NULL, address_formatted, "texts hold no address" },
    { NULL, BOTH, NULL, NULL, nan_sign, "a NaN is nan, without a sign" },
    { "string.format", STOCK_ALONE, NULL, "\"invalid conversion '%", conversion_refused, "%a, %A and %p are refused" },
    { "string.format", NEITHER, NULL, NULL, fault_order,
      "of several flaws in a format, that of the format itself is named" },
    { "string.format", NOT_OURS, NULL, "(%q accepts whole numbers only)", NULL, "%q refuses a fraction" },
    { "string.format", BOTH, NULL, NULL, quoted_float, "%q writes a whole float in decimal" },
    { NULL, STOCK_ALONE, NULL, NULL, pattern_flaw,
      "a malformed pattern is an error even where no match reaches the flaw" },
    { NULL, NEITHER, NULL, NULL, pattern_flaw, "of a pattern's flaws, ours names the first" },
    { NULL, ANY, "pattern too complex", NULL, is_pattern_function, "matching needs no recursion" },
    { NULL, BOTH, NULL, NULL, trigonometry,
      "the angles of trig.h, good to about 1e-9 and a rounding of the angle given" },
    { "pairs", BOTH, NULL, NULL, pairs_order, "pairs has an order" },
    { "pairs", NOT_OURS, NULL, "have no fixed order", NULL, "pairs refuses keys without an order" },
    { "pairs", NOT_OURS, NULL, "__pairs is not supported", NULL, "pairs refuses __pairs" },
    { "pairs", NOT_OURS, NULL, "bad argument #1 to 'pairs' (table expected", NULL, "pairs takes tables only" },
    { "table.sort", BOTH, NULL, NULL, sort_stable, "table.sort is stable" },
    { "table.sort", BOTH, NULL, NULL, sort_writes, "table.sort writes only what moves" },
    { "table.sort", OURS_ALONE, "invalid order function", NULL, NULL, "table.sort takes any comparator" },
    { "table.sort", NEITHER, NULL, NULL, sort_untouched,
      "a sort that fails leaves the table alone, and compares others first" },
    { "pcall", STOCK_ALONE, NULL, NULL, pcall_fault, "pcall catches what error and assert raised and nothing else" },
    { "setmetatable", STOCK_ALONE, NULL, "is not allowed in a metatable", NULL, "no __gc and no __mode" },
    { "setmetatable", STOCK_ALONE, NULL, "setmetatable: __call: expected a function", NULL, "__call is a function" },
    { "getmetatable", BOTH, "\"__pow\"=function", NULL, NULL, "texts have no __pow" },
    { "load", BOTH, NULL, "operator ^ is not available", NULL, "load refuses ^" },
    { "load", BOTH, NULL, "__gc is not available", NULL, "load refuses __gc" },
    { "load", BOTH, NULL, "__mode is not available", NULL, "load refuses __mode" },
    { "load", BOTH, "attempt to load a", NULL, NULL, "load takes text only, whatever its mode" },
    { "load", BOTH, NULL, "attempt to load a binary chunk", NULL, "load refuses binary chunks before it reads them" },
    { "load", STOCK_ALONE, NULL, NULL, load_reader, "load passes an error of its reader on" },
    { "table.remove", NEITHER, "(position out of bounds)", "bad argument #2 to 'table.remove' (position out of bounds)",
      NULL, "some releases blame the first argument of table.remove" },
    { "utf8.codes", ANY, NULL, "invalid UTF-8 code", NULL, "some releases let stray continuation bytes pass" },
};

enum { EXEMPTIONS = sizeof exemptions / sizeof *exemptions };

static int times[EXEMPTIONS]; /* that each was used */

static bool is_exempt(const struct exemption *e, const struct call *c)
{
    return (!e->name || strcmp(e->name, c->name) == 0) && (e->success & 1 << (c->stock.ok + 2 * c->ours.ok)) != 0 &&
           (!e->stock || says(&c->stock, e->stock)) && (!e->ours || says(&c->ours, e->ours)) &&
           (!e->holds || e->holds(c));
}

/* Counts the use of an exemption. */
static bool may_differ(const struct call *c)
{
    for (int i = 0; i < EXEMPTIONS; i++)
        if (is_exempt(&exemptions[i], c)) {
            times[i]++;
            return true;
        }
    return false;
}

/* ---- what is called ---- */

/* The kinds of arguments, see luagen.h, and the functions that are called with them. */
static const struct {
    const char *args, *names;
} shapes[] = {
    { "a", "getmetatable math.tointeger math.type rawlen tonumber tostring type" },
    { "a*", "assert table.pack" },
    { "aa", "rawequal" },
    { "ai", "error" },
    { "ia*", "select" },
    { "kKM", "load" },
    { "kKMt", "load" },
    { "oa*", "pcall" },
    { "t", "getmetatable ipairs pairs rawlen table.concat table.remove table.sort table.unpack tostring" },
    { "ta", "rawget table.insert" },
    { "taa", "rawset" },
    { "ti", "table.remove" },
    { "tia", "table.insert" },
    { "tii", "table.unpack" },
    { "tiii", "table.move" },
    { "tiiit", "table.move" },
    { "tm", "setmetatable" },
    { "tO", "table.sort" },
    { "tSii", "table.concat" },
    { "N", "tonumber math.tointeger" },
    { "NB", "tonumber" },
    { "s", "string.len string.lower string.reverse string.upper" },
    { "sc", "string.rep" },
    { "scS", "string.rep" },
    { "sii", "string.byte string.sub" },
    { "ss*", "warn" },
    { "C*", "string.char" },
    { "f", "string.format" },
    { "Sp", "string.find string.gmatch string.match" },
    { "Spi", "string.find string.gmatch string.match" },
    { "sSil", "string.find" },
    { "Spr", "string.gsub" },
    { "Spri", "string.gsub" },
    { "n", "math.abs math.acos math.asin math.atan math.ceil math.cos math.deg math.floor math.modf math.rad math.sin "
           "math.sqrt math.tan math.tointeger tostring" },
    { "nn", "math.atan math.fmod math.ult" },
    { "nn*", "math.max math.min" },
    { "U*", "utf8.char" },
    { "u", "utf8.codes utf8.len" },
    { "ul", "utf8.codes" },
    { "ui", "utf8.codepoint utf8.offset" },
    { "uii", "utf8.offset" },
    { "uiil", "utf8.codepoint utf8.len" },
};

struct reference {
    struct pair *pair;
    uint64_t next_seed;
    int calls; /* of each shape */
    int compared, refused, different;
    int shown; /* of this shape */
};

static void set_nan(lua_State *L)
{
    lua_pushnumber(L, copysign(NAN, 1));
    lua_setglobal(L, "nan");
    lua_pushnumber(L, copysign(NAN, -1));
    lua_setglobal(L, "minus_nan");
}

static void open_pair(struct reference *r)
{
    void *pair;

    setup(&pair);
    r->pair = pair;
    set_nan(r->pair->ours);
    set_nan(r->pair->stock);
    /* A second name of math.atan, which messages may give it. */
    assert_int_equal(luaL_loadstring(r->pair->stock, "math.atan2 = nil"), LUA_OK);
    lua_call(r->pair->stock, 0, 0);
}

/* What a fault leaves behind: a state in which every pcall that fails passes it on. */
static void open_anew(struct reference *r)
{
    teardown((void **)&r->pair);
    open_pair(r);
}

static bool agree(const struct call *c)
{
    return c->stock.ok == c->ours.ok && strcmp(c->stock.values.s, c->ours.values.s) == 0 && same_tables(c);
}

static void report(const struct call *c)
{
    fprintf(stderr, "%s(%s)\n    stock %s %s%s\n    ours  %s %s%s\n", c->name, c->source.s,
            c->stock.ok ? "gives" : "fails:", c->stock.values.s, c->stock.after.s,
            c->ours.ok ? "gives" : "fails:", c->ours.values.s, c->ours.after.s);
}

static void compare(struct reference *r, struct call *c)
{
    struct pair *p = r->pair;

    if (!answer(p->stock, c, &c->stock))
        return;
    p->b->vm.work = 0;
    if (!answer(p->ours, c, &c->ours))
        fail_msg("%s(%s): the arguments are there in stock alone", c->name, c->source.s);
    r->compared++;
    r->refused += !c->ours.ok;
    if (!agree(c) && !may_differ(c)) {
        r->different++;
        if (r->shown++ < 3)
            report(c);
    }
    lua_settop(p->ours, 0);
    if (strcmp(c->name, "pcall") == 0 && !c->ours.ok)
        open_anew(r);
    else if (heap_used(p->b->vm.heap) > HEAP / 4)
        lua_gc(p->ours, LUA_GCCOLLECT);
}

static void forget(struct call *c)
{
    free(c->source.s);
    free(c->stock.values.s);
    free(c->stock.after.s);
    free(c->ours.values.s);
    free(c->ours.after.s);
}

static void compare_calls(struct reference *r, struct call *c, const char *args)
{
    const int before = r->compared;

    r->shown = 0;
    rng_seed(&r->pair->rng, r->next_seed++);
    for (int k = 0; k < r->calls; k++) {
        struct rng rng = r->pair->rng;
        c->source.n = 0;
        say(&c->source, "%s", "");
        luagen_args(&rng, &c->source, args);
        compare(r, c);
        r->pair->rng = rng;
    }
    assert_in_range(r->compared - before, r->calls / 2, r->calls); /* nearly all calls can be made */
}

TEST(agrees_with_the_linked_lua)
{
    struct reference *r = *state;
    struct call c = { 0 };

    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        char names[256], *next = names;
        snprintf(names, sizeof names, "%s", shapes[i].names);
        while ((c.name = strtok_r(next, " ", &next)) != NULL)
            compare_calls(r, &c, shapes[i].args);
    }
    forget(&c);
    print_message("%d calls compared, %d of them errors in ours, %d differ\n", r->compared, r->refused, r->different);
    assert_int_equal(r->different, 0);
}

/* An exemption that is never used is one too many, or the calls do not reach what it is for. */
TEST(uses_every_exemption)
{
    for (int i = 0; i < EXEMPTIONS; i++) {
        print_message("%6d  %s\n", times[i], exemptions[i].why);
        if (!times[i] && strncmp(exemptions[i].why, "some releases", 13) != 0)
            fail_msg("never: %s", exemptions[i].why);
    }
}

/* ---- every name ---- */

static bool has_shape(const char *name)
{
    const size_t n = strlen(name);

    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        for (const char *s = shapes[i].names; (s = strstr(s, name)) != NULL; s += n)
            if ((s == shapes[i].names || s[-1] == ' ') && (s[n] == ' ' || s[n] == '\0'))
                return true;
    return false;
}

TEST(calls_every_name)
{
    static const char *const libraries[] = { "_G", "string", "table", "math", "utf8" };
    struct reference *r = *state;
    lua_State *L = r->pair->ours;

    for (size_t i = 0; i < sizeof libraries / sizeof *libraries; i++) {
        char *names = strdup(lualib_retained_names(i ? libraries[i] : "")), name[64];
        for (char *s = strtok(names, " "); s; s = strtok(NULL, " ")) {
            snprintf(name, sizeof name, "%s.%s", libraries[i], s);
            lua_getglobal(L, libraries[i]);
            lua_getfield(L, -1, s);
            if (lua_isfunction(L, -1) && !has_shape(i ? name : s))
                fail_msg("no shape of arguments for %s", name);
            lua_settop(L, 0);
        }
        free(names);
    }
}

static int open_reference(void **state)
{
    struct reference *r = calloc(1, sizeof *r);
    const char *seed = getenv("CURTAIN_SEED"), *calls = getenv("CURTAIN_CALLS");

    r->next_seed = 1000 * (seed ? strtoull(seed, NULL, 0) : 1);
    r->calls = calls ? atoi(calls) : 6000;
    open_pair(r);
    *state = r;
    return 0;
}

static int close_reference(void **state)
{
    struct reference *r = *state;

    teardown((void **)&r->pair);
    free(r);
    return 0;
}

RUN_TESTS(open_reference, close_reference)

/*
 * luapattern.c - string.find, match, gmatch and gsub.
 *
 * A pattern is compiled to a flat list of ops. Lua's patterns have no alternatives and repeat only single characters,
 * so a match passes each op once, and each repeated op can store its own backtracking state: how far it got and how far
 * back it may go. When an op fails, the nearest earlier repeated op that has another alternative tries it, and matching
 * continues after that op. This needs neither recursion nor a stack, and captures need no undoing, because all ops
 * after the retried one run again. Each op tried and each character examined is charged.
 *
 * Character classes are those of the C locale on every host. Semantics: Lua 5.4 reference manual, 6.4.1.
 */
#include <assert.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "luaparts.h"
#include "../vm.h"

enum {
    MAX_CAPTURES = 32,
    MAX_STACK_OPS = 32,   /* a pattern with more is compiled into Lua memory */
    CHARGE_EVERY = 16384, /* work between two calls of vm_charge */
    ESCAPE = '%'
};

enum op_kind {
    OP_END,  /* a: number of captures in the pattern */
    OP_CHAR, /* the character a */
    OP_ANY,
    OP_SET,        /* a character in set */
    OP_OPEN,       /* capture a starts */
    OP_CLOSE,      /* capture a ends */
    OP_POSITION,   /* capture a is the current position */
    OP_BACKREF,    /* the same text as capture a */
    OP_BALANCE,    /* %b: from character a to the matching b */
    OP_FRONTIER,   /* the previous character is not in set, the next one is */
    OP_SUBJECT_END /* the subject's end */
};

struct op {
    uint8_t kind;
    uint8_t repeat; /* * + - ? or 0 (once); not 0 only for OP_CHAR, OP_ANY and OP_SET */
    uint8_t a, b;
    int prev_repeat; /* index of the nearest repeated op before this one, or -1 */
    uint64_t set[4];
    const char *current, *low; /* while matching: how far a repeated op got, and how far back a greedy one may go */
};

struct capture {
    const char *start;
    size_t size;
    bool is_position; /* a position, not a string */
};

struct matcher {
    lua_State *L;
    struct op *ops;
    const char *subject, *subject_end;
    uint64_t work; /* not yet charged */
    int capture_count;
    struct capture capture[MAX_CAPTURES];
};

/* ---- compiling ---- */

struct compiler {
    lua_State *L;
    const char *p, *end;
    struct op *ops;
    int op_count, last_repeat, capture_count;
    bool is_open[MAX_CAPTURES];
};

static void set_add(uint64_t set[4], unsigned c)
{
    set[c >> 6] |= (uint64_t)1 << (c & 63);
}

static bool set_has(const uint64_t set[4], unsigned char c)
{
    return set[c >> 6] >> (c & 63) & 1;
}

/* The classes, ASCII only: a bit per character, 0 to 63 in `low` and 64 to 127 in `high`. */
static const struct {
    unsigned char letter;
    uint64_t low, high;
} classes[] = {
    { 'a', 0, 0x07fffffe07fffffe },
    { 'c', 0x00000000ffffffff, 0x8000000000000000 },
    { 'd', 0x03ff000000000000, 0 },
    { 'g', 0xfffffffe00000000, 0x7fffffffffffffff },
    { 'l', 0, 0x07fffffe00000000 },
    { 'p', 0xfc00fffe00000000, 0x78000001f8000001 },
    { 's', 0x0000000100003e00, 0 },
    { 'u', 0, 0x0000000007fffffe },
    { 'w', 0x03ff000000000000, 0x07fffffe07fffffe },
    { 'x', 0x03ff000000000000, 0x0000007e0000007e },
    { 'z', 1, 0 },
};

/* Adds the characters that % followed by c matches: a class, its complement for an upper-case letter, or c itself. */
static void set_add_escape(uint64_t set[4], unsigned char c)
{
    for (size_t i = 0; i < sizeof classes / sizeof *classes; i++)
        if (classes[i].letter == (c | 0x20)) {
            uint64_t flip = c & 0x20 ? 0 : ~(uint64_t)0;
            set[0] |= classes[i].low ^ flip;
            set[1] |= classes[i].high ^ flip;
            set[2] |= flip;
            set[3] |= flip;
            return;
        }
    set_add(set, c);
}

/* Returns the position after the ] that closes the set whose [ is before p. A ] at the start of the set is an
 * ordinary character. */
static const char *find_set_end(struct compiler *c, const char *p)
{
    if (p < c->end && *p == '^')
        p++;
    do {
        if (p == c->end)
            luaL_error(c->L, "malformed pattern (missing ']')");
        if (*p++ == ESCAPE && p < c->end)
            p++;
    } while (p == c->end || *p != ']');
    return p + 1;
}

/* Parses a set into `set`, which must be empty; c->p is after the [. */
static void read_set(struct compiler *c, uint64_t set[4])
{
    const char *end = find_set_end(c, c->p), *last = end - 1, *p = c->p;
    bool complement = *p == '^';

    for (p += complement; p < last; p++) {
        if (*p == ESCAPE) {
            set_add_escape(set, (unsigned char)*++p);
        } else if (p + 2 < last && p[1] == '-') {
            for (unsigned ch = (unsigned char)p[0]; ch <= (unsigned char)p[2]; ch++)
                set_add(set, ch);
            p += 2;
        } else {
            set_add(set, (unsigned char)*p);
        }
    }
    for (int i = 0; complement && i < 4; i++)
        set[i] = ~set[i];
    c->p = end;
}

static struct op *emit(struct compiler *c, enum op_kind kind, unsigned a)
{
    struct op *op = &c->ops[c->op_count++];

    *op = (struct op){ .kind = (uint8_t)kind, .a = (uint8_t)a, .prev_repeat = c->last_repeat };
    return op;
}

static void read_capture_start(struct compiler *c)
{
    bool is_position = c->p < c->end && *c->p == ')';

    if (c->capture_count == MAX_CAPTURES)
        luaL_error(c->L, "too many captures");
    emit(c, is_position ? OP_POSITION : OP_OPEN, (unsigned)c->capture_count);
    c->is_open[c->capture_count++] = !is_position;
    c->p += is_position;
}

static void read_capture_end(struct compiler *c)
{
    for (int i = c->capture_count - 1; i >= 0; i--)
        if (c->is_open[i]) {
            c->is_open[i] = false;
            emit(c, OP_CLOSE, (unsigned)i);
            return;
        }
    luaL_error(c->L, "invalid pattern capture");
}

/* In the next three functions, c->p is at the character after the %. */
static void read_backref(struct compiler *c)
{
    int i = *c->p++ - '1';

    if (i < 0 || i >= c->capture_count || c->is_open[i])
        luaL_error(c->L, "invalid capture index %%%d in pattern", i + 1);
    emit(c, OP_BACKREF, (unsigned)i);
}

static void read_balance(struct compiler *c)
{
    if (c->end - c->p < 3)
        luaL_error(c->L, "malformed pattern (missing arguments to '%%b')");
    emit(c, OP_BALANCE, (unsigned char)c->p[1])->b = (uint8_t)c->p[2];
    c->p += 3;
}

static void read_frontier(struct compiler *c)
{
    if (++c->p == c->end || *c->p++ != '[')
        luaL_error(c->L, "missing '[' after '%%f' in pattern");
    read_set(c, emit(c, OP_FRONTIER, 0)->set);
}

static void read_repeat(struct compiler *c, struct op *op)
{
    if (c->p == c->end || !*c->p || !strchr("*+-?", *c->p))
        return;
    op->repeat = (uint8_t)*c->p++;
    c->last_repeat = c->op_count - 1;
}

/* Compiles an item, i.e. a single character or class, and its repetition, if any. `first` is the item's first character
 * in the pattern; c->p is after that character. */
static void read_item(struct compiler *c, char first)
{
    struct op *op = emit(c, first == '.' ? OP_ANY : OP_CHAR, (unsigned char)first);

    if (first == '[') {
        op->kind = OP_SET;
        read_set(c, op->set);
    } else if (first == ESCAPE) {
        unsigned char e = (unsigned char)*c->p++;
        op->a = e;
        if ((e >= 'A' && e <= 'Z') || (e >= 'a' && e <= 'z')) {
            op->kind = OP_SET;
            set_add_escape(op->set, e);
        }
    }
    read_repeat(c, op);
}

static void read_escape(struct compiler *c)
{
    if (c->p == c->end)
        luaL_error(c->L, "malformed pattern (ends with '%%')");
    if (*c->p == 'b')
        read_balance(c);
    else if (*c->p == 'f')
        read_frontier(c);
    else if (*c->p >= '0' && *c->p <= '9')
        read_backref(c);
    else
        read_item(c, ESCAPE);
}

/* Compiles pattern [p, end) into ops, which must have space for an op per byte and one more. Returns the number of
 * captures. */
static int compile(lua_State *L, struct op *ops, const char *p, const char *end)
{
    struct compiler c = { .L = L, .p = p, .end = end, .ops = ops, .last_repeat = -1 };

    vm_charge(L, (uint64_t)(end - p));
    while (c.p < end) {
        char ch = *c.p++;
        switch (ch) {
        case '(':
            read_capture_start(&c);
            break;
        case ')':
            read_capture_end(&c);
            break;
        case ESCAPE:
            read_escape(&c);
            break;
        default:
            if (ch == '$' && c.p == end)
                emit(&c, OP_SUBJECT_END, 0);
            else
                read_item(&c, ch);
        }
    }
    for (int i = 0; i < c.capture_count; i++)
        if (c.is_open[i])
            luaL_error(L, "unfinished capture");
    emit(&c, OP_END, (unsigned)c.capture_count);
    return c.capture_count;
}

/* ---- matching ---- */

static void charge_pending(struct matcher *m)
{
    uint64_t work = m->work;

    m->work = 0;
    vm_charge(m->L, work);
}

static void charge(struct matcher *m, size_t work)
{
    m->work += work;
    if (m->work >= CHARGE_EVERY)
        charge_pending(m);
}

static bool matches_char(const struct op *op, char c)
{
    switch (op->kind) {
    case OP_CHAR:
        return (unsigned char)c == op->a;
    case OP_SET:
        return set_has(op->set, (unsigned char)c);
    default:
        return true;
    }
}

/* Returns the end of the longest run at s of characters that op matches. */
static const char *find_run_end(struct matcher *m, const struct op *op, const char *s)
{
    const char *e = s;

    if (op->kind == OP_ANY)
        e = m->subject_end;
    else
        while (e < m->subject_end && matches_char(op, *e))
            e++;
    charge(m, (size_t)(e - s));
    return e;
}

/* Makes the first try of a repeated op at s. Returns where the next op continues, or NULL. */
static const char *begin_repeat(struct matcher *m, struct op *op, const char *s)
{
    switch (op->repeat) {
    case '-':
        op->current = s;
        break;
    case '?':
        op->low = s;
        op->current = s < m->subject_end && matches_char(op, *s) ? s + 1 : s;
        break;
    default:
        op->low = op->repeat == '+' ? s + 1 : s;
        op->current = find_run_end(m, op, s);
        if (op->current < op->low)
            return NULL;
    }
    return op->current;
}

/* Backtracks: makes a lazy repeat one character longer, any other one shorter. Returns where the next op continues, or
 * NULL. */
static const char *retry_repeat(const struct matcher *m, struct op *op)
{
    if (op->repeat == '-')
        return op->current < m->subject_end && matches_char(op, *op->current) ? ++op->current : NULL;
    return op->current > op->low ? --op->current : NULL;
}

static const char *match_balance(struct matcher *m, const struct op *op, const char *s)
{
    const char *start = s;
    size_t depth = 1;

    if (s == m->subject_end || (unsigned char)*s != op->a)
        return NULL;
    while (++s < m->subject_end) {
        if ((unsigned char)*s == op->b) {
            if (--depth == 0)
                break;
        } else if ((unsigned char)*s == op->a) {
            depth++;
        }
    }
    charge(m, (size_t)(s - start));
    return s < m->subject_end ? s + 1 : NULL;
}

static const char *match_backref(struct matcher *m, const struct op *op, const char *s)
{
    const struct capture *c = &m->capture[op->a];

    if (c->is_position || (size_t)(m->subject_end - s) < c->size || memcmp(s, c->start, c->size))
        return NULL;
    charge(m, c->size / 8);
    return s + c->size;
}

static const char *match_frontier(const struct matcher *m, const struct op *op, const char *s)
{
    char before = s > m->subject ? s[-1] : '\0', here = s < m->subject_end ? *s : '\0';

    return !set_has(op->set, (unsigned char)before) && set_has(op->set, (unsigned char)here) ? s : NULL;
}

/* Tries op, which must not be a repeated one, at s. Returns where the next op continues, or NULL. */
static const char *match_op(struct matcher *m, const struct op *op, const char *s)
{
    struct capture *c = &m->capture[op->a & (MAX_CAPTURES - 1)];

    switch ((enum op_kind)op->kind) {
    case OP_CHAR:
    case OP_ANY:
    case OP_SET:
        return s < m->subject_end && matches_char(op, *s) ? s + 1 : NULL;
    case OP_OPEN:
    case OP_POSITION:
        *c = (struct capture){ s, 0, op->kind == OP_POSITION };
        return s;
    case OP_CLOSE:
        c->size = (size_t)(s - c->start);
        return s;
    case OP_BACKREF:
        return match_backref(m, op, s);
    case OP_BALANCE:
        return match_balance(m, op, s);
    case OP_FRONTIER:
        return match_frontier(m, op, s);
    case OP_SUBJECT_END:
        return s == m->subject_end ? s : NULL;
    case OP_END:
        break;
    }
    return s;
}

/* Matches at s. Returns the end of the match, or NULL. */
static const char *match_at(struct matcher *m, const char *s)
{
    struct op *ops = m->ops;
    int i = 0;

    while (ops[i].kind != OP_END) {
        charge(m, 1);
        const char *next = ops[i].repeat ? begin_repeat(m, &ops[i], s) : match_op(m, &ops[i], s);
        for (int r = ops[i].prev_repeat; !next && r >= 0; r = ops[r].prev_repeat) {
            charge(m, 1);
            next = retry_repeat(m, &ops[r]);
            i = r;
        }
        if (!next)
            return NULL;
        s = next;
        i++;
    }
    return s;
}

/* Returns the next position at or after s where a match can start, or NULL. */
static const char *find_candidate(struct matcher *m, const char *s)
{
    const struct op *first = m->ops;

    if (first->kind != OP_CHAR || (first->repeat && first->repeat != '+'))
        return s;
    const char *found = s < m->subject_end ? memchr(s, first->a, (size_t)(m->subject_end - s)) : NULL;
    charge(m, (size_t)((found ? found : m->subject_end) - s) / 8);
    return found;
}

/* Finds the first match at or after *s and sets *s to its start. Returns its end, or NULL. */
static const char *find_match(struct matcher *m, const char **s)
{
    while ((*s = find_candidate(m, *s)) != NULL) {
        const char *e = match_at(m, *s);
        if (e)
            return e;
        if (*s == m->subject_end)
            return NULL;
        ++*s;
    }
    return NULL;
}

/* Pushes capture i, from 0, of the match [s, e). If the pattern has no captures, capture 0 is the whole match. */
static void push_capture(const struct matcher *m, int i, const char *s, const char *e)
{
    const struct capture *c = &m->capture[i];

    if (i == 0 && m->capture_count == 0)
        lua_pushlstring(m->L, s, (size_t)(e - s));
    else if (c->is_position)
        lua_pushinteger(m->L, c->start - m->subject + 1);
    else
        lua_pushlstring(m->L, c->start, c->size);
}

/* Pushes all captures or, if there are none and `allow_whole` is set, the whole match. Returns the number of values. */
static int push_captures(const struct matcher *m, const char *s, const char *e, bool allow_whole)
{
    int n = m->capture_count == 0 && allow_whole ? 1 : m->capture_count;

    luaL_checkstack(m->L, n, "too many captures");
    for (int i = 0; i < n; i++)
        push_capture(m, i, s, e);
    return n;
}

static void init_matcher(struct matcher *m, lua_State *L, struct op *ops, const char *s, size_t n)
{
    m->L = L;
    m->ops = ops;
    m->subject = s;
    m->subject_end = s + n;
    m->work = 16; /* the call itself */
    m->capture_count = 0;
}

/* Returns space for the ops of a pattern of n bytes: `stack_ops`, or a userdata that it pushes. */
static struct op *reserve_ops(lua_State *L, struct op *stack_ops, size_t n)
{
    if (n < MAX_STACK_OPS)
        return stack_ops;
    vm_charge(L, n);
    return lua_newuserdatauv(L, (n + 1) * sizeof *stack_ops, 0);
}

/* ---- find and match ---- */

static bool is_plain(const char *p, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (p[i] && strchr("^$*+?.([%-", p[i]))
            return false;
    return true;
}

/* Returns the first occurrence of p in s, or NULL. */
static const char *find_plain(lua_State *L, const char *s, size_t n, const char *p, size_t pn)
{
    uint64_t work = 0;
    const char *found = NULL;

    if (pn == 0)
        return s;
    while (n >= pn) {
        const char *at = memchr(s, *p, n - pn + 1);
        work += (at ? (size_t)(at - s) : n) / 8 + 1;
        if (!at)
            break;
        if (!memcmp(at, p, pn)) {
            found = at;
            break;
        }
        work += pn / 16;
        n -= (size_t)(at - s) + 1;
        s = at + 1;
        if (work >= CHARGE_EVERY)
            vm_charge(L, work), work = 0;
    }
    vm_charge(L, work);
    return found;
}

static int find_by_pattern(lua_State *L, const char *s, size_t n, size_t init, bool is_find)
{
    size_t pn;
    const char *p = luaL_checklstring(L, 2, &pn), *at = s + init, *e;
    bool is_anchored = pn && *p == '^';
    struct op stack_ops[MAX_STACK_OPS];
    struct matcher m;

    init_matcher(&m, L, reserve_ops(L, stack_ops, pn), s, n);
    m.capture_count = compile(L, m.ops, p + is_anchored, p + pn);
    e = is_anchored ? match_at(&m, at) : find_match(&m, &at);
    charge_pending(&m);
    if (!e)
        return lua_pushnil(L), 1;
    if (!is_find)
        return push_captures(&m, at, e, true);
    lua_pushinteger(L, at - s + 1);
    lua_pushinteger(L, e - s);
    return 2 + push_captures(&m, at, e, false);
}

static int find_or_match(lua_State *L, bool is_find)
{
    size_t n, pn;
    const char *s = luaL_checklstring(L, 1, &n), *p = luaL_checklstring(L, 2, &pn);
    size_t init = luaparts_position(luaL_optinteger(L, 3, 1), n);

    init -= init > 0;
    if (init > n)
        return lua_pushnil(L), 1;
    if (!is_find || !(lua_toboolean(L, 4) || is_plain(p, pn)))
        return find_by_pattern(L, s, n, init, is_find);
    const char *at = find_plain(L, s + init, n - init, p, pn);
    if (!at)
        return lua_pushnil(L), 1;
    lua_pushinteger(L, at - s + 1);
    lua_pushinteger(L, at - s + (lua_Integer)pn);
    return 2;
}

static int string_find(lua_State *L)
{
    return find_or_match(L, true);
}

static int string_match(lua_State *L)
{
    return find_or_match(L, false);
}

/* ---- gmatch ---- */

/* The state of gmatch's iterator, its upvalue 2; upvalue 1 is the subject. */
struct gmatch_state {
    size_t next, last; /* offsets where to continue and of the end of the last match; NOWHERE: none */
    int capture_count;
    struct op ops[];
};

static const size_t NO_OFFSET = SIZE_MAX;

static int next_match(lua_State *L)
{
    size_t n;
    const char *s = lua_tolstring(L, lua_upvalueindex(1), &n);
    struct gmatch_state *w = lua_touserdata(L, lua_upvalueindex(2));
    struct matcher m;

    if (w->next > n)
        return 0;
    init_matcher(&m, L, w->ops, s, n);
    m.capture_count = w->capture_count;
    const char *at = s + w->next, *e;
    while ((e = find_match(&m, &at)) != NULL && (size_t)(e - s) == w->last)
        if (at++ == m.subject_end) {
            e = NULL;
            break;
        }
    charge_pending(&m);
    w->next = w->last = e ? (size_t)(e - s) : NO_OFFSET;
    return e ? push_captures(&m, at, e, true) : 0;
}

static int string_gmatch(lua_State *L)
{
    size_t n, pn;
    luaL_checklstring(L, 1, &n);
    const char *p = luaL_checklstring(L, 2, &pn);
    size_t init = luaparts_position(luaL_optinteger(L, 3, 1), n);

    lua_pushvalue(L, 1);
    struct gmatch_state *w = lua_newuserdatauv(L, sizeof *w + (pn + 1) * sizeof *w->ops, 0);
    w->next = init - (init > 0);
    w->last = NO_OFFSET;
    w->capture_count = compile(L, w->ops, p, p + pn);
    lua_pushcclosure(L, next_match, 2);
    return 1;
}

/* ---- gsub ---- */

/* Adds the replacement string in argument 3, with its %0 to %9 and %% expanded. */
static void expand_replacement(struct matcher *m, luaL_Buffer *out, const char *s, const char *e)
{
    size_t n;
    const char *p = lua_tolstring(m->L, 3, &n), *end = p + n;

    charge(m, n / 4);
    for (const char *q; (q = memchr(p, ESCAPE, (size_t)(end - p))) != NULL; p = q + 1) {
        luaL_addlstring(out, p, (size_t)(q - p));
        if (++q < end && *q == ESCAPE) {
            luaL_addchar(out, ESCAPE);
        } else if (q < end && *q == '0') {
            luaL_addlstring(out, s, (size_t)(e - s));
        } else if (q < end && *q >= '1' && *q <= '9') {
            int i = *q - '1';
            if (i >= m->capture_count && i > 0)
                luaL_error(m->L, "invalid capture index %%%d in replacement string", i + 1);
            push_capture(m, i, s, e);
            luaL_addvalue(out);
        } else {
            luaL_error(m->L, "invalid use of '%%' in replacement string");
        }
    }
    luaL_addlstring(out, p, (size_t)(end - p));
}

/* Adds the replacement of the match [s, e). Returns false if the match is retained unchanged. */
static bool add_replacement(struct matcher *m, luaL_Buffer *out, const char *s, const char *e)
{
    lua_State *L = m->L;

    switch (lua_type(L, 3)) {
    case LUA_TFUNCTION:
        lua_pushvalue(L, 3);
        lua_call(L, push_captures(m, s, e, true), 1);
        break;
    case LUA_TTABLE:
        push_capture(m, 0, s, e);
        lua_gettable(L, 3);
        break;
    default:
        expand_replacement(m, out, s, e);
        return true;
    }
    if (!lua_toboolean(L, -1)) {
        lua_pop(L, 1);
        luaL_addlstring(out, s, (size_t)(e - s));
        return false;
    }
    if (!lua_isstring(L, -1))
        luaL_error(L, "invalid replacement value (a %s)", luaL_typename(L, -1));
    if (lua_type(L, -1) == LUA_TNUMBER) {
        luatext_push_number(L, -1);
        lua_remove(L, -2);
    }
    luaL_addvalue(out);
    return true;
}

enum { MATCH_WORK = 4 /* work per replaced match */ };

/* Replaces up to max matches. Writes the result to out except for the rest of the subject, which starts at *tail.
 * Returns the number of matches. */
static lua_Integer substitute(struct matcher *m, luaL_Buffer *out, const char **tail, bool is_anchored, lua_Integer max,
                              bool *changed)
{
    const char *s = m->subject, *last = NULL, *e;
    lua_Integer n = 0;

    while (n < max) {
        const char *next = is_anchored ? s : find_candidate(m, s);
        if (!next)
            break;
        luaL_addlstring(out, s, (size_t)(next - s));
        s = next;
        e = match_at(m, s);
        if (e && e != last) {
            n++;
            charge(m, MATCH_WORK);
            *changed |= add_replacement(m, out, s, e);
            s = last = e;
        } else if (s < m->subject_end) {
            luaL_addchar(out, *s++);
        } else {
            break;
        }
        if (is_anchored)
            break;
    }
    *tail = s;
    return n;
}

static int string_gsub(lua_State *L)
{
    size_t n, pn;
    const char *s = luaL_checklstring(L, 1, &n), *p = luaL_checklstring(L, 2, &pn), *tail;
    int type = lua_type(L, 3);
    lua_Integer max = luaL_optinteger(L, 4, (lua_Integer)n + 1);
    bool is_anchored = pn && *p == '^', changed = false;
    struct op stack_ops[MAX_STACK_OPS];
    struct matcher m;
    luaL_Buffer out;

    luaL_argexpected(L, type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TFUNCTION || type == LUA_TTABLE, 3,
                     "string/function/table");
    if (type == LUA_TNUMBER) {
        luatext_push_number(L, 3);
        lua_replace(L, 3);
    }
    init_matcher(&m, L, reserve_ops(L, stack_ops, pn), s, n);
    m.capture_count = compile(L, m.ops, p + is_anchored, p + pn);
    luaL_buffinit(L, &out);
    lua_Integer count = substitute(&m, &out, &tail, is_anchored, max, &changed);
    charge_pending(&m);
    if (changed) {
        luaL_addlstring(&out, tail, (size_t)(m.subject_end - tail));
        luaL_pushresult(&out);
    } else {
        lua_pushvalue(L, 1);
    }
    lua_pushinteger(L, count);
    return 2;
}

void luapattern_open(lua_State *L)
{
    static const luaL_Reg functions[] = { { "find", string_find },
                                          { "gmatch", string_gmatch },
                                          { "gsub", string_gsub },
                                          { "match", string_match },
                                          { NULL, NULL } };

    luaL_setfuncs(L, functions, 0);
}

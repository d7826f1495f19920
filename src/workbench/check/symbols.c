/*
 * symbols.c - see symbols.h. The parser has the structure of Lua's own: a function for each rule of the grammar, one
 * token of look-ahead, operator precedences, and a limit for nesting, which protects the stack. An expression may turn
 * out to be the target of an assignment, so its use is recorded later: by read_value if it is read, and by write_value
 * if it is assigned. After a syntax error, the token is T_BAD and stays T_BAD, and every loop ends at T_BAD.
 */
#include "symbols.h"

#include <stdlib.h>
#include "../../base/edit.h"
#include "../../common/array.h"

enum {
    DEPTH = 220, /* nested statements and expressions; Lua allows 200 */
    LOCALS = 200 /* visible at the same time in a function; Lua's limit */
};

struct local {
    const char *s; /* name, inside the text */
    size_t n;
    struct symbol_origin from; /* of its only value */
    int table;                 /* the table that is its only value, or -1 */
    int writes;                /* assignments after its declaration */
    int values;                /* uses as a value */
    bool empty;                /* declared without a value */
    bool unknown;              /* may have other values */
};

/* The context of an expression. */
struct context {
    struct symbol_origin from; /* the argument that contains the expression; name NULL: none */
    int key;                   /* the key that has it as value, or -1 */
};

struct pending_iteration {
    int line, local; /* local -1: `of` is the origin */
    const char *operation;
    struct symbol_origin origin;
};

struct parser {
    struct symbols *f;
    struct lex l;
    struct local *locals; /* all, in order of declaration */
    int *active;          /* visible locals, indices */
    struct pending_iteration *iterations;
    int n_locals, n_active, n_iterations;
    int depth, functions;
    int base; /* the first of `active` in this function */
    bool (*is_builtin)(const char *name);
};

enum kind {
    X_OTHER,
    X_GLOBAL,      /* name */
    X_FIELD,       /* space.name of a global */
    X_INDEX,       /* name[...] of a global */
    X_LOCAL,       /* at: index of locals */
    X_LOCAL_FIELD, /* .name of the local `at` */
    X_LOCAL_INDEX, /* [...] of the local `at` */
    X_CALL,        /* of space.name, or of name */
    X_STRING,      /* at: index of texts */
    X_NUMBER,
    X_TABLE, /* at: index of tables */
};

struct expr {
    enum kind kind;
    int line, at;
    const char *space, *name;
    bool zero;
};

#define ADD(p, list, n, ...)                                                                                           \
    (reserve(p, &(list), n, sizeof *(list)) ? (void)((list)[(n)++] = __VA_ARGS__) : (void)0) /* adds to a list */

/* ---- names ---- */

static void fail(struct parser *p)
{
    p->l.now.type = T_BAD;
}

static bool reserve(struct parser *p, void *list, int n, size_t size)
{
    if (array_append(list, (size_t)n, size))
        return true;
    p->f->arena.failed = true;
    fail(p);
    return false;
}

static const char *copy_text(struct parser *p, struct token t)
{
    bool has_zero = t.n > 0 && memchr(t.s, '\0', t.n) != NULL;

    return arena_copy(&p->f->arena, t.s, has_zero ? 0 : t.n);
}

static int declare(struct parser *p, struct token name)
{
    ADD(p, p->locals, p->n_locals, (struct local){ .s = name.s, .n = name.n, .table = -1 });
    return p->n_locals - 1;
}

static void make_visible(struct parser *p, int local)
{
    if (p->n_active - p->base >= LOCALS)
        fail(p);
    if (p->l.now.type != T_BAD)
        ADD(p, p->active, p->n_active, local);
}

static int declare_unknown(struct parser *p, struct token name)
{
    int local = declare(p, name);

    if (local >= 0)
        p->locals[local].unknown = true;
    return local;
}

static bool is_named(const struct local *l, const char *s, size_t n)
{
    return l->n == n && memcmp(l->s, s, n) == 0;
}

static int find_local(const struct parser *p, const char *s, size_t n)
{
    for (int i = p->n_active; i-- > 0;)
        if (is_named(&p->locals[p->active[i]], s, n))
            return p->active[i];
    return -1;
}

/* Returns the visible local with the most similar name, the innermost of several, or NULL. */
static const char *find_similar_local(struct parser *p, const char *name)
{
    int best = (int)strlen(name) < 3 ? 0 : EDIT_TOO_FAR - 1;
    const struct local *found = NULL;
    char word[33];

    for (int i = p->n_active; i-- > 0;) {
        const struct local *l = &p->locals[p->active[i]];
        if (l->n >= sizeof word || l->n < 2)
            continue;
        memcpy(word, l->s, l->n);
        word[l->n] = '\0';
        int distance = edit_distance(name, word);
        if (distance >= best)
            continue;
        best = distance;
        found = l;
    }
    return found != NULL ? arena_copy(&p->f->arena, found->s, found->n) : NULL;
}

static void use_global(struct parser *p, enum symbol_use how, int line, const char *name, const char *field)
{
    bool sure = p->is_builtin == NULL || p->is_builtin(name);

    ADD(p, p->f->globals, p->f->n_globals,
        (struct symbol_global){ how, line, name, field, sure ? NULL : find_similar_local(p, name) });
}

static int add_text(struct parser *p, struct token t, int how)
{
    ADD(p, p->f->texts, p->f->n_texts, (struct symbol_text){ t.line, copy_text(p, t), how });
    return p->f->n_texts - 1;
}

static void read_value(struct parser *p, const struct expr *e)
{
    if (e->kind == X_GLOBAL)
        use_global(p, USE_VALUE, e->line, e->name, NULL);
    else if (e->kind == X_INDEX)
        use_global(p, USE_INDEX, e->line, e->name, NULL);
    else if (e->kind == X_FIELD)
        use_global(p, USE_FIELD, e->line, e->space, e->name);
    else if (e->kind == X_LOCAL)
        p->locals[e->at].values++;
}

static void write_value(struct parser *p, const struct expr *e)
{
    if (e->kind == X_GLOBAL)
        use_global(p, USE_WRITE, e->line, e->name, NULL);
    else if (e->kind == X_INDEX)
        use_global(p, USE_VALUE, e->line, e->name, NULL);
    else if (e->kind == X_FIELD)
        use_global(p, USE_MEMBER, e->line, e->space, e->name);
    else if (e->kind == X_LOCAL_FIELD)
        ADD(p, p->f->members, p->f->n_members, (struct symbol_member){ e->at, e->name });
    else if (e->kind == X_LOCAL)
        p->locals[e->at].writes++;
    else if (e->kind == X_LOCAL_INDEX)
        p->locals[e->at].values++;
}

static struct symbol_origin origin_of(const struct expr *e)
{
    if (e->kind != X_CALL)
        return (struct symbol_origin){ 0 };
    return (struct symbol_origin){ .space = e->space, .name = e->name };
}

static void set_local(struct parser *p, int local, const struct expr *e)
{
    struct local *l = &p->locals[local];

    l->from = origin_of(e);
    l->table = e->kind == X_TABLE ? e->at : -1;
}

/* ---- tokens ---- */

static int token_type(const struct parser *p)
{
    return p->l.now.type;
}

static bool accept(struct parser *p, int token)
{
    if (token_type(p) != token)
        return false;
    lex_step(&p->l);
    return true;
}

static void expect(struct parser *p, int token)
{
    if (!accept(p, token))
        fail(p);
}

static struct token expect_name(struct parser *p)
{
    struct token t = p->l.now;

    if (t.type != T_NAME)
        fail(p);
    lex_step(&p->l);
    return t.type == T_NAME ? t : (struct token){ .s = "", .line = t.line };
}

static bool enter_level(struct parser *p)
{
    if (++p->depth > DEPTH)
        fail(p);
    return token_type(p) != T_BAD;
}

static void primary(struct parser *p, struct expr *e);
static void expression(struct parser *p, struct expr *e, struct context c);
static void block(struct parser *p);

static const struct context no_context = { { NULL, NULL, NULL, 0, 0 }, -1 };

static void skip_expression(struct parser *p)
{
    struct expr e;

    expression(p, &e, no_context);
}

/* ---- functions ---- */

static void parameters(struct parser *p, struct symbol_origin from)
{
    for (from.param = 1; token_type(p) == T_NAME; from.param++) {
        int local = declare_unknown(p, expect_name(p));
        if (local >= 0) {
            p->locals[local].from = from;
            p->locals[local].unknown = from.name == NULL;
        }
        make_visible(p, local);
        if (!accept(p, ','))
            return;
    }
    accept(p, T_DOTS);
}

/* Parses a function from its ( to its end. */
static void function_body(struct parser *p, struct symbol_origin from, bool method)
{
    int visible = p->n_active, base = p->base;

    p->base = visible;
    p->functions++;
    if (method)
        make_visible(p, declare_unknown(p, (struct token){ .s = "self", .n = 4 }));
    expect(p, '(');
    parameters(p, from);
    expect(p, ')');
    block(p);
    expect(p, T_ENDS);
    p->n_active = visible;
    p->base = base;
    p->functions--;
}

/* ---- tables ---- */

static int add_key(struct parser *p, int table, struct token name)
{
    const char *s = copy_text(p, name);

    ADD(p, p->f->keys, p->f->n_keys, (struct symbol_key){ table, name.line, s, NULL });
    return p->f->n_keys - 1;
}

/* Parses the value of a key. */
static void key_value(struct parser *p, int key, struct context c)
{
    struct expr e;

    c.key = key;
    if (key >= 0 && c.from.name != NULL)
        c.from.key = p->f->keys[key].name;
    expression(p, &e, c);
    if (e.kind == X_STRING && key >= 0)
        p->f->keys[key].value = p->f->texts[e.at].s;
}

static void bracket_key(struct parser *p, int table, struct context c)
{
    struct token t = { .s = "", .line = p->l.now.line };
    struct expr e;

    expect(p, '[');
    if (token_type(p) == T_STRING)
        t = p->l.now;
    expression(p, &e, no_context);
    expect(p, ']');
    expect(p, '=');
    key_value(p, e.kind == X_STRING ? add_key(p, table, t) : -1, c);
}

static void field(struct parser *p, int table, struct context c)
{
    struct expr e;

    if (token_type(p) == '[') {
        bracket_key(p, table, c);
    } else if (token_type(p) == T_NAME && lex_peek(&p->l) == '=') {
        struct token t = expect_name(p);
        add_text(p, t, SYMBOL_KEY);
        lex_step(&p->l);
        key_value(p, add_key(p, table, t), c);
    } else if (token_type(p) == '{') { /* a table in a list has a key without a name */
        c.key = add_key(p, table, (struct token){ .s = "", .line = p->l.now.line });
        expression(p, &e, c);
    } else {
        skip_expression(p);
    }
}

static void constructor(struct parser *p, struct expr *e, struct context c)
{
    int table = p->f->n_tables;

    ADD(p, p->f->tables, p->f->n_tables,
        (struct symbol_table){ p->l.now.line, c.from.space, c.from.name, c.from.arg, c.key });
    *e = (struct expr){ .kind = X_TABLE, .line = p->l.now.line, .at = table };
    expect(p, '{');
    while (token_type(p) != '}' && token_type(p) != T_BAD) {
        field(p, table, c);
        if (!accept(p, ',') && !accept(p, ';'))
            break;
    }
    expect(p, '}');
}

/* ---- calls ---- */

static void add_iteration(struct parser *p, int line, const char *how, const struct expr *e)
{
    if (e->kind == X_CALL)
        ADD(p, p->iterations, p->n_iterations, (struct pending_iteration){ line, -1, how, origin_of(e) });
    else if (e->kind == X_LOCAL)
        ADD(p, p->iterations, p->n_iterations, (struct pending_iteration){ line, e->at, how, { 0 } });
}

/* Parses an argument and adds it to the call. */
static void argument(struct parser *p, struct symbol_call *call, struct expr *e)
{
    struct context c = { { call->space, call->name, NULL, call->args + 1, 0 }, -1 };

    expression(p, e, c);
    if (e->kind == X_STRING && call->args < SYMBOL_ARGS && token_type(p) != T_BAD)
        call->arg[call->args] = p->f->texts[e->at].s;
    call->args++;
}

/* Parses the arguments of a call; *first: the first one. */
static void arguments(struct parser *p, struct symbol_call *call, struct expr *first)
{
    struct expr e;

    *first = (struct expr){ 0 };
    if (token_type(p) == T_STRING || token_type(p) == '{') {
        struct context c = { { call->space, call->name, NULL, 1, 0 }, -1 };
        if (token_type(p) == '{') {
            constructor(p, first, c);
        } else {
            *first = (struct expr){ .kind = X_STRING, .line = p->l.now.line, .at = add_text(p, p->l.now, 0) };
            lex_step(&p->l);
            call->arg[0] = token_type(p) != T_BAD ? p->f->texts[first->at].s : NULL;
        }
        call->args = 1;
        return;
    }
    expect(p, '(');
    while (token_type(p) != ')' && token_type(p) != T_BAD) {
        argument(p, call, call->args == 0 ? first : &e);
        if (token_type(p) != ')')
            expect(p, ',');
    }
    expect(p, ')');
}

static void add_format(struct parser *p, const struct expr *e)
{
    if (e->kind == X_STRING && token_type(p) != T_BAD)
        ADD(p, p->f->formats, p->f->n_formats, (struct symbol_text){ e->line, p->f->texts[e->at].s, 0 });
}

static void call(struct parser *p, struct expr *e)
{
    bool named = e->kind == X_GLOBAL || e->kind == X_FIELD;
    struct symbol_call c = { .line = e->line };
    struct expr first;

    read_value(p, e);
    if (named) {
        c.space = e->kind == X_FIELD ? e->space : NULL;
        c.name = e->name;
    }
    arguments(p, &c, &first);
    if (named) {
        ADD(p, p->f->calls, p->f->n_calls, c);
        if (c.space == NULL && (symbols_same(c.name, "pairs") || symbols_same(c.name, "ipairs")))
            add_iteration(p, c.line, c.name, &first);
        if (symbols_same(c.space, "string") && symbols_same(c.name, "format"))
            add_format(p, &first);
    }
    *e = (struct expr){ named ? X_CALL : X_OTHER, c.line, 0, c.space, c.name, false };
}

static void method(struct parser *p, struct expr *e)
{
    struct symbol_call c = { .line = e->line };
    struct token name = expect_name(p);
    struct expr first;

    add_text(p, name, SYMBOL_KEY);
    if (e->kind == X_GLOBAL)
        use_global(p, USE_METHOD, e->line, e->name, copy_text(p, name));
    else
        read_value(p, e);
    if (name.n == 6 && memcmp(name.s, "format", 6) == 0)
        add_format(p, e);
    arguments(p, &c, &first);
    *e = (struct expr){ .kind = X_OTHER, .line = c.line };
}

/* ---- expressions ---- */

/* Parses .name or ["name"] after e. A field of _G or _ENV is a global. */
static void select_field(struct parser *p, struct expr *e, const char *name)
{
    if (e->kind == X_GLOBAL && (symbols_same(e->name, "_G") || symbols_same(e->name, "_ENV"))) {
        e->name = name;
    } else if (e->kind == X_GLOBAL) {
        e->space = e->name;
        e->name = name;
        e->kind = X_FIELD;
    } else if (e->kind == X_LOCAL) {
        e->name = name;
        e->kind = X_LOCAL_FIELD;
    } else {
        read_value(p, e);
        e->kind = X_OTHER;
    }
}

static void index_with(struct parser *p, struct expr *e)
{
    struct expr key;

    expression(p, &key, no_context);
    expect(p, ']');
    if (key.kind == X_STRING && token_type(p) != T_BAD)
        select_field(p, e, p->f->texts[key.at].s);
    else if (e->kind == X_GLOBAL)
        e->kind = X_INDEX;
    else if (e->kind == X_LOCAL)
        e->kind = X_LOCAL_INDEX;
    else
        read_value(p, e), e->kind = X_OTHER;
}

static void primary_name(struct parser *p, struct expr *e)
{
    struct token t = expect_name(p);
    int local = find_local(p, t.s, t.n);

    *e = (struct expr){ .kind = X_LOCAL, .line = t.line, .at = local };
    if (local >= 0)
        return;
    e->kind = find_local(p, "_ENV", 4) >= 0 ? X_OTHER : X_GLOBAL;
    e->name = copy_text(p, t);
}

static void parenthesized(struct parser *p, struct expr *e)
{
    lex_step(&p->l);
    expression(p, e, no_context);
    expect(p, ')');
    if (e->kind != X_STRING && e->kind != X_NUMBER && e->kind != X_CALL) /* not a target of assignments */
        e->kind = X_OTHER;
}

static void primary(struct parser *p, struct expr *e)
{
    *e = (struct expr){ .line = p->l.now.line };
    if (token_type(p) == '(')
        parenthesized(p, e);
    else
        primary_name(p, e);
    while (token_type(p) != T_BAD) {
        if (accept(p, '.')) {
            struct token t = expect_name(p);
            add_text(p, t, SYMBOL_KEY);
            select_field(p, e, copy_text(p, t));
        } else if (accept(p, '[')) {
            index_with(p, e);
        } else if (accept(p, ':')) {
            method(p, e);
        } else if (token_type(p) == '(' || token_type(p) == '{' || token_type(p) == T_STRING) {
            call(p, e);
        } else {
            return;
        }
    }
}

static void simple(struct parser *p, struct expr *e, struct context c)
{
    struct token t = p->l.now;

    *e = (struct expr){ .line = t.line };
    if (t.type == '{') {
        constructor(p, e, c);
    } else if (t.type == T_NAME || t.type == '(') {
        primary(p, e);
        read_value(p, e);
    } else if (t.type == T_FUNCTION) {
        lex_step(&p->l);
        function_body(p, c.from, false);
    } else if (t.type == T_STRING) {
        e->kind = X_STRING;
        e->at = add_text(p, t, 0);
        lex_step(&p->l);
    } else if (t.type == T_NUMBER) {
        e->kind = X_NUMBER;
        e->zero = t.zero;
        lex_step(&p->l);
    } else if (t.type == T_NIL || t.type == T_TRUE || t.type == T_FALSE || t.type == T_DOTS) {
        lex_step(&p->l);
    } else {
        fail(p);
    }
}

static const struct operator
{
    int token_type, left, right;
}
operators[] = { { '+', 10, 10 },    { '-', 10, 10 }, { '*', 11, 11 }, { '%', 11, 11 }, { '^', 14, 13 }, { '/', 11, 11 },
                { T_IDIV, 11, 11 }, { '&', 6, 6 },   { '|', 4, 4 },   { '~', 5, 5 },   { T_SHL, 7, 7 }, { T_SHR, 7, 7 },
                { T_CONCAT, 9, 8 }, { T_EQ, 3, 3 },  { T_NE, 3, 3 },  { '<', 3, 3 },   { '>', 3, 3 },   { T_LE, 3, 3 },
                { T_GE, 3, 3 },     { T_AND, 2, 2 }, { T_OR, 1, 1 } };

enum { UNARY = 12 };

static const struct operator* find_operator(int token)
{
    for (size_t i = 0; i < sizeof operators / sizeof operators[0]; i++)
        if (operators[i].token_type == token)
            return &operators[i];
    return NULL;
}

static void operation(struct parser *p, struct expr *e, int limit, struct context c);

static void unary(struct parser *p, struct expr *e)
{
    int sign = token_type(p), line = p->l.now.line;

    lex_step(&p->l);
    operation(p, e, UNARY, no_context);
    if (sign == '#' && token_type(p) != T_BAD)
        add_iteration(p, line, "#", e);
    if (sign != '-' || e->kind != X_NUMBER)
        e->kind = X_OTHER;
    e->line = line;
}

static void add_division(struct parser *p, int line, int operator_type, const struct expr *a, const struct expr *b)
{
    const char *how = operator_type == '/' ? "/" : operator_type == '%' ? "%" : "//";

    if (b->kind == X_NUMBER && b->zero)
        ADD(p, p->f->divisions, p->f->n_divisions,
            (struct symbol_division){ line, how, a->kind == X_NUMBER && a->zero, a->kind == X_NUMBER });
}

/* Parses an operator and its right side; *a: the left side and the result. */
static void binary(struct parser *p, struct expr *a, const struct operator* o)
{
    int line = p->l.now.line, text;
    struct expr b;

    lex_step(&p->l);
    text = token_type(p) == T_STRING ? p->f->n_texts : -1;
    if (o->token_type == T_CONCAT && a->kind == X_STRING)
        p->f->texts[a->at].how |= SYMBOL_FIRST;
    operation(p, &b, o->right, no_context);
    if (token_type(p) == T_BAD)
        return;
    if (o->token_type == T_CONCAT && text >= 0)
        p->f->texts[text].how |= SYMBOL_LAST;
    if (o->token_type == '/' || o->token_type == T_IDIV || o->token_type == '%')
        add_division(p, line, o->token_type, a, &b);
    *a = (struct expr){ .line = a->line };
}

/* Parses an expression with operators of a higher priority than the limit. */
static void operation(struct parser *p, struct expr *e, int limit, struct context c)
{
    const struct operator* o;

    *e = (struct expr){ .line = p->l.now.line };
    if (enter_level(p)) {
        if (token_type(p) == T_NOT || token_type(p) == '-' || token_type(p) == '~' || token_type(p) == '#')
            unary(p, e);
        else
            simple(p, e, c);
        while ((o = find_operator(token_type(p))) != NULL && o->left > limit)
            binary(p, e, o);
    }
    if (token_type(p) == T_BAD)
        e->kind = X_OTHER;
    p->depth--;
}

static void expression(struct parser *p, struct expr *e, struct context c)
{
    operation(p, e, 0, c);
}

static void expression_list(struct parser *p)
{
    do
        skip_expression(p);
    while (accept(p, ','));
}

/* ---- statements ---- */

static bool is_block_end(const struct parser *p)
{
    int t = token_type(p);

    return t == T_END || t == T_BAD || t == T_ENDS || t == T_ELSE || t == T_ELSEIF || t == T_UNTIL;
}

static void if_statement(struct parser *p)
{
    do {
        lex_step(&p->l);
        skip_expression(p);
        expect(p, T_THEN);
        block(p);
    } while (token_type(p) == T_ELSEIF);
    if (accept(p, T_ELSE))
        block(p);
    expect(p, T_ENDS);
}

static void statements(struct parser *p);

/* Parses repeat; the locals of the block are visible in the condition. */
static void repeat_statement(struct parser *p)
{
    int visible = p->n_active;

    lex_step(&p->l);
    statements(p);
    expect(p, T_UNTIL);
    skip_expression(p);
    p->n_active = visible;
}

/* Declares *n names, which are not visible yet; returns the first. */
static int name_list(struct parser *p, struct token first, int *n)
{
    int from = declare_unknown(p, first);

    for (*n = 1; accept(p, ','); ++*n)
        declare_unknown(p, expect_name(p));
    return from;
}

static void make_all_visible(struct parser *p, int first, int n)
{
    for (int i = 0; i < n; i++)
        make_visible(p, first + i);
}

static void for_statement(struct parser *p)
{
    int visible = p->n_active, n = 1;

    lex_step(&p->l);
    struct token name = expect_name(p);
    int first = name_list(p, name, &n);
    if (!accept(p, '='))
        expect(p, T_IN);
    expression_list(p);
    make_all_visible(p, first, n);
    expect(p, T_DO);
    block(p);
    expect(p, T_ENDS);
    p->n_active = visible;
}

/* Parses the name after a colon. In the function, e is self. */
static void method_name(struct parser *p, struct expr *e)
{
    const char *name = copy_text(p, expect_name(p));

    if (e->kind == X_GLOBAL)
        use_global(p, USE_SELF, e->line, e->name, name);
    else if (e->kind == X_LOCAL)
        p->locals[e->at].values++;
    if (e->kind == X_GLOBAL)
        return;
    select_field(p, e, name);
    write_value(p, e);
}

/* Parses function a.b.c:d(). */
static void function_statement(struct parser *p)
{
    struct expr e;

    lex_step(&p->l);
    primary_name(p, &e);
    while (token_type(p) == '.') {
        lex_step(&p->l);
        select_field(p, &e, copy_text(p, expect_name(p)));
    }
    bool is_method = accept(p, ':');
    if (is_method)
        method_name(p, &e);
    else
        write_value(p, &e);
    function_body(p, no_context.from, is_method);
}

static void local_function(struct parser *p)
{
    make_visible(p, declare_unknown(p, expect_name(p)));
    function_body(p, no_context.from, false);
}

/* Declares *n names with <attributes>; returns the first. */
static int local_names(struct parser *p, int *n)
{
    int first = p->n_locals;

    *n = 0;
    do {
        declare(p, expect_name(p));
        ++*n;
        if (accept(p, '<')) {
            expect_name(p);
            expect(p, '>');
        }
    } while (accept(p, ','));
    return first;
}

static void local_statement(struct parser *p)
{
    int n, values = 0, first = local_names(p, &n);
    struct expr e;

    if (accept(p, '=')) {
        do {
            expression(p, &e, no_context);
            if (values < n && token_type(p) != T_BAD)
                set_local(p, first + values, &e);
            values++;
        } while (accept(p, ','));
        for (int i = values; i < n && token_type(p) != T_BAD; i++)
            p->locals[first + i].unknown = true;
    } else {
        for (int i = 0; i < n && token_type(p) != T_BAD; i++)
            p->locals[first + i].empty = true;
    }
    make_all_visible(p, first, n);
}

/* Parses an assignment. A local that is declared without a value and assigned once, in an assignment with a single
 * target, is treated as declared with this value. */
static void assign(struct parser *p, struct expr *target)
{
    bool alone = token_type(p) == '=';
    struct expr e;

    write_value(p, target);
    while (accept(p, ',')) {
        struct expr more;
        primary(p, &more);
        write_value(p, &more);
        if (more.kind == X_LOCAL)
            p->locals[more.at].unknown = true;
    }
    expect(p, '=');
    expression(p, &e, no_context);
    if (token_type(p) == T_BAD)
        return;
    if (alone && target->kind == X_LOCAL && p->locals[target->at].empty)
        set_local(p, target->at, &e);
    else if (target->kind == X_LOCAL)
        p->locals[target->at].unknown = true;
    while (accept(p, ','))
        skip_expression(p);
}

static void expression_statement(struct parser *p)
{
    struct expr e;

    primary(p, &e);
    if (token_type(p) == '=' || token_type(p) == ',')
        assign(p, &e);
}

/* Parses return, and records the value that the script returns at its end. */
static void return_statement(struct parser *p)
{
    struct expr e = { 0 };

    lex_step(&p->l);
    if (!is_block_end(p) && token_type(p) != ';') {
        expression(p, &e, no_context);
        while (accept(p, ','))
            skip_expression(p);
    }
    accept(p, ';');
    if (p->functions > 0 || token_type(p) != T_END)
        return;
    if (e.kind == X_TABLE)
        p->f->result_table = e.at;
    if (e.kind != X_LOCAL)
        return;
    p->locals[e.at].values--;
    p->f->result_local = e.at;
}

static void statement(struct parser *p)
{
    switch (token_type(p)) {
    case ';':
    case T_BREAK:
        lex_step(&p->l);
        break;
    case T_IF:
        if_statement(p);
        break;
    case T_WHILE:
        lex_step(&p->l);
        skip_expression(p);
        expect(p, T_DO);
        block(p);
        expect(p, T_ENDS);
        break;
    case T_DO:
        lex_step(&p->l);
        block(p);
        expect(p, T_ENDS);
        break;
    case T_FOR:
        for_statement(p);
        break;
    case T_REPEAT:
        repeat_statement(p);
        break;
    case T_FUNCTION:
        function_statement(p);
        break;
    case T_LOCAL:
        lex_step(&p->l);
        if (accept(p, T_FUNCTION))
            local_function(p);
        else
            local_statement(p);
        break;
    case T_LABEL:
        lex_step(&p->l);
        expect_name(p);
        expect(p, T_LABEL);
        break;
    case T_GOTO:
        lex_step(&p->l);
        expect_name(p);
        break;
    default:
        expression_statement(p);
    }
}

static void statements(struct parser *p)
{
    while (!is_block_end(p)) {
        if (token_type(p) == T_RETURN) {
            return_statement(p);
            return;
        }
        if (enter_level(p))
            statement(p);
        p->depth--;
    }
}

static void block(struct parser *p)
{
    int visible = p->n_active;

    statements(p);
    p->n_active = visible;
}

/* ---- results ---- */

/* Adds the iterations over values with a known origin. */
static void resolve_iterations(struct parser *p)
{
    for (int i = 0; i < p->n_iterations; i++) {
        const struct pending_iteration *w = &p->iterations[i];
        const struct local *l = w->local >= 0 ? &p->locals[w->local] : NULL;
        struct symbol_origin of = l != NULL ? l->from : w->origin;
        if (of.name != NULL && (l == NULL || (!l->unknown && l->writes == (l->empty ? 1 : 0))))
            ADD(p, p->f->iterations, p->f->n_iterations, (struct symbol_iteration){ w->line, w->operation, of });
    }
}

static void resolve_result(struct parser *p)
{
    if (p->f->result_local < 0)
        return;
    const struct local *l = &p->locals[p->f->result_local];
    p->f->result_table = l->table;
    p->f->result_open = l->values > 0 || l->writes > 0 || l->unknown || l->table < 0;
}

bool symbols_read(struct symbols *f, const char *text, size_t n, bool (*is_builtin)(const char *name))
{
    struct parser p = { .f = f, .is_builtin = is_builtin };

    *f = (struct symbols){ .result_local = -1, .result_table = -1 };
    lex_open(&p.l, text, n, &f->arena);
    statements(&p);
    f->complete = token_type(&p) == T_END;
    resolve_iterations(&p);
    resolve_result(&p);
    f->complete = f->complete && !f->arena.failed;
    lex_close(&p.l);
    free(p.locals);
    free(p.active);
    free(p.iterations);
    return f->complete;
}

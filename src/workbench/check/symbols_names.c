/*
 * symbols_names.c - names while a script is read: locals in sight, uses of globals, what becomes of an expression.
 */
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../common/array.h"
#include "symbols_parts.h"

enum { LOCALS = 200 /* in sight at a time in one function: Lua's limit */ };

void symbols_stop(struct parse *p)
{
    p->l.now.type = T_BAD;
}

bool symbols_room(struct parse *p, void *list, int n, size_t size)
{
    if (array_append(list, (size_t)n, size))
        return true;
    p->f->arena.failed = true;
    symbols_stop(p);
    return false;
}

const char *symbols_copy(struct parse *p, struct token t)
{
    bool odd = t.n > 0 && memchr(t.s, '\0', t.n) != NULL;

    return arena_copy(&p->f->arena, t.s, odd ? 0 : t.n);
}

int symbols_declare(struct parse *p, struct token name)
{
    ADD(p, p->locals, p->n_locals, (struct local){ .s = name.s, .n = name.n, .table = -1 });
    return p->n_locals - 1;
}

void symbols_show(struct parse *p, int local)
{
    if (p->n_active - p->base >= LOCALS)
        symbols_stop(p);
    if (p->l.now.type != T_BAD)
        ADD(p, p->active, p->n_active, local);
}

int symbols_declare_unknown(struct parse *p, struct token name)
{
    int local = symbols_declare(p, name);

    if (local >= 0)
        p->locals[local].unknown = true;
    return local;
}

static bool is_named(const struct local *l, const char *s, size_t n)
{
    return l->n == n && memcmp(l->s, s, n) == 0;
}

int symbols_find_local(const struct parse *p, const char *s, size_t n)
{
    for (int i = p->n_active; i-- > 0;)
        if (is_named(&p->locals[p->active[i]], s, n))
            return p->active[i];
    return -1;
}

/* The nearest local in sight of a name that is none, the innermost of equals. */
static const char *near_local(struct parse *p, const char *name)
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

void symbols_use(struct parse *p, enum symbol_use how, int line, const char *name, const char *field)
{
    bool sure = p->is_builtin == NULL || p->is_builtin(name);

    ADD(p, p->f->globals, p->f->n_globals,
        (struct symbol_global){ how, line, name, field, sure ? NULL : near_local(p, name) });
}

int symbols_add_text(struct parse *p, struct token t, int how)
{
    ADD(p, p->f->texts, p->f->n_texts, (struct symbol_text){ t.line, symbols_copy(p, t), how });
    return p->f->n_texts - 1;
}

void symbols_value(struct parse *p, const struct expr *e)
{
    if (e->kind == X_GLOBAL)
        symbols_use(p, USE_VALUE, e->line, e->name, NULL);
    else if (e->kind == X_INDEX)
        symbols_use(p, USE_INDEX, e->line, e->name, NULL);
    else if (e->kind == X_FIELD)
        symbols_use(p, USE_FIELD, e->line, e->space, e->name);
    else if (e->kind == X_LOCAL)
        p->locals[e->at].values++;
}

void symbols_store(struct parse *p, const struct expr *e)
{
    if (e->kind == X_GLOBAL)
        symbols_use(p, USE_WRITE, e->line, e->name, NULL);
    else if (e->kind == X_INDEX)
        symbols_use(p, USE_VALUE, e->line, e->name, NULL);
    else if (e->kind == X_FIELD)
        symbols_use(p, USE_MEMBER, e->line, e->space, e->name);
    else if (e->kind == X_MEMBER)
        ADD(p, p->f->members, p->f->n_members, (struct symbol_member){ e->at, e->name });
    else if (e->kind == X_LOCAL)
        p->locals[e->at].writes++;
    else if (e->kind == X_INSIDE)
        p->locals[e->at].values++;
}

struct symbol_origin symbols_origin(const struct expr *e)
{
    if (e->kind != X_CALL)
        return (struct symbol_origin){ 0 };
    return (struct symbol_origin){ .space = e->space, .name = e->name };
}

void symbols_give(struct parse *p, int local, const struct expr *e)
{
    struct local *l = &p->locals[local];

    l->from = symbols_origin(e);
    l->table = e->kind == X_TABLE ? e->at : -1;
}

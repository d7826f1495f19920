/*
 * api_table.c - see api_table.h.
 */
#include "api_table.h"
#include <stdio.h>
#include <string.h>
#include "../../base/edit.h"

int api_count(const struct api_table *t)
{
    int n = 0;

    for (int m = 0; m < t->n; m++)
        n += t->modules[m]->n;
    return n;
}

const struct api_entry *api_entry(const struct api_table *t, int i)
{
    for (int m = 0; m < t->n; i -= t->modules[m++]->n)
        if (i < t->modules[m]->n)
            return &t->modules[m]->entries[i];
    return NULL;
}

const struct api_entry *api_find(const struct api_table *t, const char *name)
{
    for (int m = 0; m < t->n; m++)
        for (int i = 0; i < t->modules[m]->n; i++) {
            const struct api_entry *e = &t->modules[m]->entries[i];
            if (e->name[0] == name[0] && !strcmp(e->name, name))
                return e;
        }
    return NULL;
}

const char *api_member(const struct api_entry *e, const char *of, char split)
{
    size_t n = strlen(of);

    return !(e->flags & API_LUA) && !strncmp(e->name, of, n) && e->name[n] == split ? e->name + n + 1 : NULL;
}

/* Returns the length of a name without its arguments. */
static size_t name_length(const char *name)
{
    const char *arguments = strchr(name, '(');

    return arguments ? (size_t)(arguments - name) : strlen(name);
}

enum { NEAR_CALLS = 3 };

/* The names nearest to a word, all at the same distance, up to NEAR_CALLS of them. */
struct near_calls {
    const char *word, *found[NEAR_CALLS];
    int best, n; /* n = NEAR_CALLS + 1: more than NEAR_CALLS */
};

/* Adds `name` ("bullet.fire", "say" or "hud.centre(row, ...)") to c if no name so far is nearer. */
static void near_call(struct near_calls *c, const char *name)
{
    char last[32];
    const char *dot = strchr(name, '.'), *from = dot ? dot + 1 : name;

    snprintf(last, sizeof last, "%.*s", (int)name_length(from), from);
    int d = edit_distance(c->word, last);
    if (d < c->best) {
        c->best = d;
        c->n = 0;
    }
    if (d != c->best || d == EDIT_FAR || c->n > NEAR_CALLS)
        return;
    if (c->n < NEAR_CALLS)
        c->found[c->n] = name;
    c->n++;
}

bool api_suggest_calls(const struct api_table *t, const char *name, char *out, size_t size)
{
    struct near_calls c = { .word = name, .best = EDIT_FAR };
    size_t n = 0;

    for (int i = 0; i < api_count(t); i++)
        if (!(api_entry(t, i)->flags & API_SYS))
            near_call(&c, api_entry(t, i)->name);
    for (int i = 0; i < t->plains; i++)
        if (strchr(t->plain[i].name, '('))
            near_call(&c, t->plain[i].name);
    for (int i = 0; i < c.n && c.n <= NEAR_CALLS && n < size; i++)
        n += (size_t)snprintf(out + n, size - n, "%s%.*s", i ? i == c.n - 1 ? " or " : ", " : "",
                              (int)name_length(c.found[i]), c.found[i]);
    return c.n > 0 && c.n <= NEAR_CALLS;
}

bool api_ends(enum handle_kind kind)
{
    return !handle_kind_group(kind) && kind != H_MOTION && kind != H_LAYER && kind != H_PLANE;
}

/*
 * api_table.c - see api_table.h.
 */
#include "api_table.h"
#include <stdio.h>
#include <string.h>
#include "../../base/edit.h"

int api_count_entries(const struct api_table *t)
{
    int n = 0;

    for (int m = 0; m < t->n; m++)
        n += t->modules[m]->n;
    return n;
}

const struct api_entry *api_get_entry(const struct api_table *t, int i)
{
    for (int m = 0; m < t->n; i -= t->modules[m++]->n)
        if (i < t->modules[m]->n)
            return &t->modules[m]->entries[i];
    return NULL;
}

const struct api_entry *api_find_entry(const struct api_table *t, const char *name)
{
    for (int m = 0; m < t->n; m++)
        for (int i = 0; i < t->modules[m]->n; i++) {
            const struct api_entry *e = &t->modules[m]->entries[i];
            if (e->name[0] == name[0] && !strcmp(e->name, name))
                return e;
        }
    return NULL;
}

const char *api_member_name(const struct api_entry *e, const char *owner, char separator)
{
    size_t n = strlen(owner);

    return !(e->flags & API_LUA) && !strncmp(e->name, owner, n) && e->name[n] == separator ? e->name + n + 1 : NULL;
}

/* Returns the length of a name without its arguments. */
static size_t name_length(const char *name)
{
    const char *arguments = strchr(name, '(');

    return arguments ? (size_t)(arguments - name) : strlen(name);
}

enum { MAX_NEAREST_CALLS = 3 };

/* The names nearest to a word, all at the same distance, up to MAX_NEAR_CALLS of them. */
struct nearest_calls {
    const char *word, *names[MAX_NEAREST_CALLS];
    int best_distance, n; /* n = MAX_NEAR_CALLS + 1: more than MAX_NEAR_CALLS */
};

/* Adds `name` ("bullet.fire", "say" or "hud.centre(row, ...)") to c if no name so far is nearer. */
static void consider_call(struct nearest_calls *c, const char *name)
{
    char last[32];
    const char *dot = strchr(name, '.'), *member = dot ? dot + 1 : name;

    snprintf(last, sizeof last, "%.*s", (int)name_length(member), member);
    int d = edit_distance(c->word, last);
    if (d < c->best_distance) {
        c->best_distance = d;
        c->n = 0;
    }
    if (d != c->best_distance || d == EDIT_TOO_FAR || c->n > MAX_NEAREST_CALLS)
        return;
    if (c->n < MAX_NEAREST_CALLS)
        c->names[c->n] = name;
    c->n++;
}

bool api_suggest_calls(const struct api_table *t, const char *name, char *out, size_t size)
{
    struct nearest_calls c = { .word = name, .best_distance = EDIT_TOO_FAR };
    size_t n = 0;

    for (int i = 0; i < api_count_entries(t); i++)
        if (!(api_get_entry(t, i)->flags & API_SYS))
            consider_call(&c, api_get_entry(t, i)->name);
    for (int i = 0; i < t->doc_name_count; i++)
        if (strchr(t->doc_names[i].name, '('))
            consider_call(&c, t->doc_names[i].name);
    for (int i = 0; i < c.n && c.n <= MAX_NEAREST_CALLS && n < size; i++)
        n += (size_t)snprintf(out + n, size - n, "%s%.*s", i ? i == c.n - 1 ? " or " : ", " : "",
                              (int)name_length(c.names[i]), c.names[i]);
    return c.n > 0 && c.n <= MAX_NEAREST_CALLS;
}

bool api_can_die(enum handle_kind kind)
{
    return !handle_kind_is_group(kind) && kind != H_MOTION && kind != H_LAYER && kind != H_PLANE && kind != H_CAMERA;
}

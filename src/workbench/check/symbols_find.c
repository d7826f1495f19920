/*
 * symbols_find.c - see symbols.h: looking up keys and lines.
 */
#include "symbols.h"

#include <stdlib.h>
#include <string.h>

void symbols_free(struct symbols *f)
{
    void *const lists[] = { f->globals, f->iterations, f->divisions, f->formats, f->texts,
                            f->calls,   f->tables,     f->keys,      f->members };

    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++)
        free(lists[i]);
    arena_close(&f->arena);
    *f = (struct symbols){ 0 };
}

/* Returns the key of that name in the table, or -1. */
static int find_key(const struct symbols *f, int table, const char *name)
{
    for (int i = 0; i < f->n_keys; i++)
        if (f->keys[i].table == table && strcmp(f->keys[i].name, name) == 0)
            return i;
    return -1;
}

static int find_table(const struct symbols *f, int key)
{
    for (int i = 0; i < f->n_tables; i++)
        if (f->tables[i].key == key)
            return i;
    return -1;
}

bool symbols_returns(const struct symbols *f, const char *key)
{
    return f->result_table < 0 || find_key(f, f->result_table, key) >= 0;
}

int symbols_line(const struct symbols *f, const char *const *path)
{
    int table = f->result_table, line = 1;

    for (; *path != NULL && table >= 0; path++) {
        int key = find_key(f, table, *path);
        if (key < 0)
            break;
        line = f->keys[key].line;
        table = find_table(f, key);
    }
    return line;
}

/*
 * list.c - see list.h.
 */
#include "list.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool list_read(struct list *l, const char *file, char *err, size_t err_size)
{
    char line[512];
    FILE *f = fopen(file, "r");

    *l = (struct list){ 0 };
    if (!f) {
        snprintf(err, err_size, "%s: cannot be read", file);
        return false;
    }
    while (fgets(line, sizeof line, f)) {
        line[strcspn(line, "\n")] = 0;
        if (!*line || *line == '#')
            continue;
        l->path = realloc(l->path, (size_t)(l->n + 1) * sizeof *l->path);
        if (!l->path || !(l->path[l->n++] = strdup(line)))
            abort();
    }
    fclose(f);
    return true;
}

void list_free(struct list *l)
{
    for (int i = 0; i < l->n; i++)
        free(l->path[i]);
    free(l->path);
    *l = (struct list){ 0 };
}

bool list_has(const struct list *l, const char *path)
{
    for (int i = 0; i < l->n; i++)
        if (!strcmp(l->path[i], path))
            return true;
    return false;
}

const char *list_name(const char *path)
{
    static const char *const before[] = { "/usr/share/games/", "/usr/share/doc/" };
    static char name[256];

    for (size_t i = 0; i < sizeof before / sizeof *before; i++)
        if (!strncmp(path, before[i], strlen(before[i])))
            path += strlen(before[i]);
    snprintf(name, sizeof name, "%s", path);
    if (strlen(name) > 4 && !strcmp(name + strlen(name) - 4, ".xml"))
        name[strlen(name) - 4] = 0;
    return name;
}

/*
 * list.h - lists of documents: a path a line; what begins with # is said to the reader.
 */
#ifndef BULLETML_LIST_H
#define BULLETML_LIST_H

#include <stdbool.h>
#include <stddef.h>

struct list {
    char **path;
    int n;
};

/* False and one sentence: it cannot be read. */
bool list_read(struct list *l, const char *file, char *err, size_t err_size);
void list_free(struct list *l);
bool list_has(const struct list *l, const char *path);

/* "noiz2sa/boss/bit" of "/usr/share/games/noiz2sa/boss/bit.xml"; good until the next call. */
const char *list_name(const char *path);

#endif

/*
 * unsaved.c - files that could not be written (unsaved.h), listed in the order in which they failed.
 */
#include "unsaved.h"

#include <stdlib.h>
#include <string.h>
#include "../../common/files.h"

/* Returns the link to the file of a path, or the link at the list's end. */
static struct unsaved **find(struct unsaved **list, const char *path)
{
    while (*list && strcmp((*list)->path, path) != 0)
        list = &(*list)->next;
    return list;
}

static void drop(struct unsaved **at)
{
    struct unsaved *u = *at;

    *at = u->next;
    free(u->bytes);
    free(u);
}

/* When out of memory, the file is lost. */
static void add(struct unsaved **list, const char *path, const void *bytes, size_t size)
{
    struct unsaved *u = malloc(sizeof *u + strlen(path) + 1);
    uint8_t *copy = malloc(size + 1);

    if (!u || !copy) {
        free(u);
        free(copy);
        return;
    }
    memcpy(copy, bytes, size);
    *u = (struct unsaved){ .bytes = copy, .size = size };
    strcpy(u->path, path);
    *find(list, path) = u;
}

bool unsaved_save(struct unsaved **list, const char *path, const void *bytes, size_t size, char *err, size_t err_size)
{
    struct unsaved **at = find(list, path);

    if (*at)
        drop(at);
    if (files_save(path, bytes, size, err, err_size))
        return true;
    add(list, path, bytes, size);
    return false;
}

const uint8_t *unsaved_bytes(const struct unsaved *list, const char *path, size_t *size)
{
    while (list && strcmp(list->path, path) != 0)
        list = list->next;
    *size = list ? list->size : 0;
    return list ? list->bytes : NULL;
}

bool unsaved_retry(struct unsaved **list, void (*failed)(void *context, const char *err), void *context)
{
    char err[FILES_ERR_SIZE];

    for (struct unsaved **at = list; *at;) {
        if (files_save((*at)->path, (*at)->bytes, (*at)->size, err, sizeof err)) {
            drop(at);
        } else {
            failed(context, err);
            at = &(*at)->next;
        }
    }
    return !*list;
}

void unsaved_free(struct unsaved **list)
{
    while (*list)
        drop(list);
}

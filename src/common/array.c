/*
 * array.c - arrays that grow (array.h).
 */
#include "array.h"

#include <stdlib.h>
#include <string.h>

enum { MIN_CAPACITY = 16 };

void *array_append(void *array, size_t n, size_t size)
{
    char *items;

    memcpy(&items, array, sizeof items); /* a pointer to any type */
    if (!items || (n >= MIN_CAPACITY && (n & (n - 1)) == 0)) {
        items = realloc(items, (n < MIN_CAPACITY ? MIN_CAPACITY : 2 * n) * size);
        if (!items)
            return NULL;
        memcpy(array, &items, sizeof items);
    }
    return memset(items + n * size, 0, size);
}

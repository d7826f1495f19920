/*
 * views.c - the words for views (views.h).
 */
#include "views.h"

#include <stdio.h>
#include <string.h>

const char *const views_dim[] = { "none", "quarter", "half", "most", NULL };
const char *const views_flashes[] = { "full", "soft", NULL };
const char *const views_colours[] = { "normal", "protan", "deutan", "tritan", NULL };

int views_find(const char *const *words, const char *word)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(words[i], word) == 0)
            return i;
    return -1;
}

void views_list(const char *const *words, char *out, size_t size)
{
    size_t n = 0;

    out[0] = 0;
    for (int i = 0; words[i] && n < size; i++)
        n += (size_t)snprintf(out + n, size - n, "%s%s", !i ? "" : words[i + 1] ? ", " : " or ", words[i]);
}

/*
 * api_hint.c - what an error suggests for a word that is not known: the nearest one that is, or, where none is near,
 * all of them, if they are few.
 */
#include <stdio.h>
#include <string.h>
#include "../../base/edit.h"
#include "api_parts.h"

enum { WHOLE = 100 }; /* characters of a list that is still read */

void api_hint_begin(struct api_hint *h, const char *word)
{
    *h = (struct api_hint){ .word = word, .best = EDIT_FAR };
}

void api_hint_add(struct api_hint *h, const char *name)
{
    const size_t n = strlen(h->list);

    api_suggest_nearer(h->word, name, &h->best, &h->found);
    h->n++;
    if (n + strlen(name) + 2 < WHOLE)
        snprintf(h->list + n, sizeof h->list - n, "%s%s", n ? ", " : "", name);
    else
        h->long_ = true;
}

const char *api_hint_push(lua_State *L, const struct api_hint *h, const char *has)
{
    if (h->found)
        return lua_pushfstring(L, " (did you mean \"%s\"?)", h->found);
    if (h->n == 0)
        return lua_pushfstring(L, " (%s none)", has);
    return h->long_ ? lua_pushliteral(L, "") : lua_pushfstring(L, " (%s %s)", has, h->list);
}

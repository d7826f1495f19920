/*
 * as_lua_head.c - the first lines of a document's script: what is not as in the document, and what can be set.
 */
#include "as_lua_parts.h"

#include <string.h>

/* Is there a vanish that no bullet is round? */
static bool root_vanishes(const struct document *d)
{
    for (int32_t i = 0; i < d->n; i++) {
        int32_t in = i;
        if (d->node[i].element != NODE_VANISH)
            continue;
        while (in != 0 && d->node[in].element != NODE_BULLET)
            in = d->node[in].parent;
        if (in == 0)
            return true;
    }
    return false;
}

static bool draws(const struct document *d)
{
    for (int32_t i = 0; i < d->n; i++)
        for (int k = 0; k < d->node[i].ops; k++)
            if (d->node[i].op[k].kind == EXPRESSION_RAND)
                return true;
    return false;
}

static bool has_two(const struct document *d)
{
    for (int32_t i = 0; i < d->n; i++) {
        int n = 0;
        for (int32_t k = d->node[i].first; k != DOCUMENT_NONE; k = d->node[k].next)
            n += d->node[k].element == NODE_ACTION || d->node[k].element == NODE_ACTION_REF;
        if (d->node[i].element == NODE_BULLET && n > 1)
            return true;
    }
    return false;
}

void as_lua_head(struct lua_text *t, const struct document *d, const char *file, const char *body)
{
    as_lua_put(t, "-- ");
    for (const char *c = strrchr(file, '/') ? strrchr(file, '/') + 1 : file; *c; c++)
        as_lua_put(t, "%c", (unsigned char)*c < 32 ? '?' : *c);
    as_lua_put(t, ", as Lua. Directions: 0 is right, as everywhere in Curtain, and 90 down.\n");
    as_lua_put(t,
               "-- Not as in the document: a bullet flies in the frame in which it is fired, one sooner than there.\n");
    if (draws(d))
        as_lua_put(t, "-- Chance is the game's, so it is another than that of bullet.ml's seed.\n");
    if (has_two(d))
        as_lua_put(t, "-- Between a bullet's actions there a frame passes; here the next begins at once.\n");
    if (strstr(body, "motion.def"))
        as_lua_put(t, "-- Changes of a motion program begin one frame sooner.\n");
    if (root_vanishes(d))
        as_lua_put(t, "-- Where the root vanishes there, the thing stays here, unless you remove it.\n");
    if (strstr(body, "_to(") || strstr(body, "_on("))
        as_lua_put(t,
                   "-- Each bullet whose speed or direction changes has a task; thousands of them are bullet.ml's.\n");
    as_lua_put(t, "local unit, rank = 1, 0.5         -- px a frame of speed 1; 0 to 1\n"
                  "local kind, kinds = \"orb\", {}     -- of all bullets; of those of a label: { petal = \"rice\" }\n"
                  "local actions, fires, bullets = {}, {}, {}\n\n");
}

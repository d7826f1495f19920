/*
 * as_lua_head.c - writes the first lines of a script: differences from the document, and settings.
 */
#include "as_lua_parts.h"

#include <string.h>

/* Returns whether a vanish is outside all bullets. */
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

static bool uses_random(const struct document *d)
{
    for (int32_t i = 0; i < d->n; i++)
        for (int k = 0; k < d->node[i].ops; k++)
            if (d->node[i].op[k].kind == EXPRESSION_RAND)
                return true;
    return false;
}

static bool has_parallel_actions(const struct document *d)
{
    for (int32_t i = 0; i < d->n; i++) {
        int n = 0;
        for (int32_t k = d->node[i].first; k != DOCUMENT_NONE; k = d->node[k].next)
            n += document_is_action(d, k);
        if (d->node[i].element == NODE_BULLET && n > 1)
            return true;
    }
    return false;
}

void as_lua_head(struct byte_buffer *t, const struct document *d, const char *file, const char *body)
{
    byte_buffer_print(t, "-- ");
    for (const char *c = strrchr(file, '/') ? strrchr(file, '/') + 1 : file; *c; c++)
        byte_buffer_print(t, "%c", (unsigned char)*c < 32 ? '?' : *c);
    byte_buffer_print(t, ", as Lua. Directions are Curtain's: 0 is right, 90 is down.\n");
    byte_buffer_print(t, "-- A bullet moves in the frame that fires it, one frame earlier than in the document.\n");
    if (uses_random(d))
        byte_buffer_print(t, "-- $rand draws from the game's random numbers, not from the seed of bullet.ml.\n");
    if (has_parallel_actions(d))
        byte_buffer_print(
            t, "-- A bullet's next action starts immediately; in the document, one frame passes between actions.\n");
    if (strstr(body, "motion.def"))
        byte_buffer_print(t, "-- Changes in a motion program start one frame earlier.\n");
    if (root_vanishes(d))
        byte_buffer_print(t,
                          "-- When the document's root vanishes, the thing that runs it stays until you remove it.\n");
    if (strstr(body, "_to(") || strstr(body, "_on("))
        byte_buffer_print(
            t, "-- Each bullet that changes speed or direction has a task; for thousands of them, use bullet.ml.\n");
    byte_buffer_print(
        t, "local unit, rank = 1, 0.5         -- px per frame at speed 1; 0 to 1\nlocal kind, kinds = \"orb\", {}  "
           "   -- for all bullets; by label: { petal = \"rice\" }\nlocal actions, fires, bullets = {}, {}, {}\n\n");
}

/*
 * ahead.c - see ahead.h. A snapshot has all that matters of RAM but what the last tick handed out, which the cabinet
 * still reads; so that is kept beside it.
 */
#include "ahead.h"

#include <stdlib.h>

enum { ALIGN = 64 }; /* bytes more, for snapshots that grow from frame to frame */

static bool keep(struct ahead *a, const struct board *b)
{
    const size_t size = board_snapshot_size(b);

    if (size > a->room) {
        free(a->snapshot);
        a->room = size + size / 4 + ALIGN;
        a->snapshot = malloc(a->room);
        a->room = a->snapshot ? a->room : 0;
    }
    if (!a->output)
        a->output = malloc(board_output_size());
    if (!a->snapshot || !a->output)
        return false;
    board_save(b, a->snapshot);
    board_output_save(b, a->output);
    return true;
}

bool ahead_begin(struct ahead *a, struct guard *g, const uint16_t pads[MAX_PLAYERS])
{
    if (!keep(a, g->board))
        return false;
    a->on = true;
    if (!guard_ahead(g, pads))
        ahead_end(a, g);
    return a->on;
}

void ahead_end(struct ahead *a, struct guard *g)
{
    if (!a->on)
        return;
    a->on = false;
    board_restore(g->board, a->snapshot);
    board_output_restore(g->board, a->output);
}

void ahead_close(struct ahead *a)
{
    free(a->snapshot);
    free(a->output);
    *a = (struct ahead){ 0 };
}

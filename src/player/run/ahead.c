/*
 * ahead.c - look-ahead (ahead.h). A snapshot doesn't contain the output of the last tick, which the program still
 * reads, so the output is saved separately.
 */
#include "ahead.h"

#include <stdlib.h>

enum { SLACK = 64 }; /* bytes, because snapshots grow from frame to frame */

bool ahead_save(struct ahead *a, const struct board *b)
{
    const size_t size = board_snapshot_size(b);

    if (size > a->capacity) {
        free(a->snapshot);
        a->capacity = size + size / 4 + SLACK;
        a->snapshot = malloc(a->capacity);
        a->capacity = a->snapshot ? a->capacity : 0;
    }
    if (!a->output)
        a->output = malloc(board_output_size());
    a->saved = a->snapshot && a->output;
    if (!a->saved)
        return false;
    board_save(b, a->snapshot);
    board_output_save(b, a->output);
    return true;
}

bool ahead_begin(struct ahead *a, struct guard *g, const uint16_t pads[MAX_PLAYERS])
{
    if (ahead_save(a, g->board) && !guard_tick_ahead(g, pads))
        ahead_end(a, g);
    return a->saved;
}

void ahead_end(struct ahead *a, struct guard *g)
{
    if (!a->saved)
        return;
    a->saved = false;
    board_restore(g->board, a->snapshot);
    board_output_restore(g->board, a->output);
}

void ahead_close(struct ahead *a)
{
    free(a->snapshot);
    free(a->output);
    *a = (struct ahead){ 0 };
}

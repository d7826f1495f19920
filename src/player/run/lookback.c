/*
 * lookback.c - see lookback.h.
 */
#include "lookback.h"

#include <stdlib.h>

static bool look(struct guard *g, uint32_t first, uint32_t now, bool (*each)(void *, const struct board *), void *user)
{
    if (first < now && !guard_back(g, first))
        return false;
    for (uint32_t f = first; each(user, g->board); f++) {
        if (f == now)
            return true;
        if (!guard_ahead(g, rewind_pads(g->past, f)))
            return false;
    }
    return false;
}

bool lookback(struct guard *g, uint32_t first, bool (*each)(void *user, const struct board *b), void *user)
{
    const uint32_t now = board_frame(g->board), begin = rewind_first(g->past);
    void *snapshot = malloc(board_snapshot_size(g->board)), *output = malloc(board_output_size());
    bool good = snapshot && output;

    if (good) {
        board_save(g->board, snapshot);
        board_output_save(g->board, output);
        first = first < begin ? begin : first;
        good = look(g, first < now ? first : now, now, each, user);
        board_restore(g->board, snapshot);
        board_output_restore(g->board, output);
    }
    free(snapshot);
    free(output);
    return good;
}

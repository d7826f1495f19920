/*
 * sweep.c - see sweep.h.
 */
#include "sweep.h"

#include <string.h>

enum { FRAMES_PER_DIRECTION = 40 };

void sweep_pads(uint32_t frame, uint16_t pads[MAX_PLAYERS])
{
    memset(pads, 0, MAX_PLAYERS * sizeof *pads);
    pads[0] = PAD_FIRE | (frame / FRAMES_PER_DIRECTION % 2 ? PAD_RIGHT : PAD_LEFT);
}

bool sweep_over(enum section_kind kind, const struct board_out *out)
{
    for (int i = 0; i < out->marker_count; i++) {
        const enum board_marker_kind is = out->marker[i].kind;
        if (is == MARKER_CLEAR || (kind == SECTION_PHASE && (is == MARKER_WON || is == MARKER_LOST)))
            return true;
    }
    return false;
}

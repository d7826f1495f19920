/*
 * sweep.h - a ship that plays a section by itself, for who wants to see what happens there and not how well it is
 * played: it fires and flies from side to side.
 */
#ifndef WORKBENCH_SWEEP_H
#define WORKBENCH_SWEEP_H

#include <stdbool.h>
#include "../../board/board.h"
#include "../../player/run/sections.h"

enum { SWEEP_FRAMES = 18000 /* of a section at most: five minutes */ };

/* What is pressed in the tick after that frame. */
void sweep_pads(uint32_t frame, uint16_t pads[MAX_PLAYERS]);

/* Is a section of that kind over with this tick: the stage cleared, the phase won or lost? A stage's bosses are
 * sections too: what ends a phase of theirs does not end the stage. */
bool sweep_over(enum section_kind kind, const struct board_out *out);

#endif

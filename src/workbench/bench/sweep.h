/*
 * sweep.h - buttons for a section without a player: the ship fires and flies from side to side.
 */
#ifndef WORKBENCH_SWEEP_H
#define WORKBENCH_SWEEP_H

#include <stdbool.h>
#include "../../board/board.h"
#include "../../player/run/sections.h"

enum { SWEEP_FRAMES = 18000 /* limit for a section: five minutes */ };

/* Sets the buttons for the tick after a frame. */
void sweep_pads(uint32_t frame, uint16_t pads[MAX_PLAYERS]);

/* Returns whether the section ends with this tick: the stage is cleared, or the phase is won or lost. The phases of a
 * stage's bosses don't end the stage. */
bool sweep_over(enum section_kind kind, const struct board_out *out);

#endif

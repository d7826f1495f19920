/*
 * map.h - draws the cells that the ship could reach.
 */
#ifndef WORKBENCH_MAP_H
#define WORKBENCH_MAP_H

#include "../../rom/cart.h"
#include "section.h"

/* Returns a contact sheet of the run as a PNG (malloc; NULL: out of memory), and restarts the simulation. Frames are
 * darkened. Cells that the ship could reach are blue, or green if they lead to the end. A white cross is the ship of
 * the run. */
uint8_t *map_sheet(struct section_run *s, const struct cart *cart, size_t *size);

/* The same for the last frame, the frame after it, and a frame a quarter of a second before, at twice the size. */
uint8_t *map_last(struct section_run *s, const struct cart *cart, size_t *size);

#endif

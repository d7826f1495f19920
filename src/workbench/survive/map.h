/*
 * map.h - pictures of the cells that the ship could reach.
 */
#ifndef WORKBENCH_MAP_H
#define WORKBENCH_MAP_H

#include "../../rom/cart.h"
#include "section.h"

/* Returns a contact sheet of the run as a PNG (malloc; NULL: out of memory), and restarts the simulation. In each
 * darkened frame, cells that the ship could reach are blue, those that lead to the end green, and the run's ship is a
 * white cross. */
uint8_t *map_sheet(struct section_run *s, const struct cart *cart, size_t *size);

/* The same with the last frame, the frame after it and one a quarter of a second before, at twice the size. */
uint8_t *map_last(struct section_run *s, const struct cart *cart, size_t *size);

#endif

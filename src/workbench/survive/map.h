/*
 * map.h - pictures of where a ship could be.
 */
#ifndef WORKBENCH_MAP_H
#define WORKBENCH_MAP_H

#include "../../rom/cart.h"
#include "section.h"

/* A sheet of frames of a run, evenly over it: on the picture, darkened, the cells where a ship could be are blue, and
 * those from which it could go on to the end green; the run's own ship is a white cross. The numbers are frames. A PNG,
 * malloc'ed; NULL: no memory. The trial is powered anew. */
uint8_t *map_sheet(struct section_run *s, const struct cart *cart, size_t *size);

/* The frame in which it ended, three times as large, beside the one a quarter of a second before. */
uint8_t *map_last(struct section_run *s, const struct cart *cart, size_t *size);

#endif

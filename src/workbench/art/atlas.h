/*
 * atlas.h - draws all sprites of a game in one picture, enlarged, with their names, origins and hit shapes.
 */
#ifndef WORKBENCH_ATLAS_H
#define WORKBENCH_ATLAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../board/inspect.h"
#include "../../rom/cart.h"

enum { ATLAS_SCALE = 3 /* pixels of the atlas per pixel of a sprite */ };

/* The hit shapes of a game's kinds, each with its sprite. */
struct atlas_shapes {
    struct inspect_kind_shape *list; /* malloc; names point into the board */
    int n;
    bool failed; /* out of memory */
};
void atlas_shapes_add(void *shapes, const struct inspect_kind_shape *kind); /* for inspect_kinds */
void atlas_shapes_free(struct atlas_shapes *shapes);

/* Writes a shape as text: "bullet moon: circle 8". */
void atlas_shape_describe(const struct inspect_kind_shape *shape, char *out, size_t size);

/* Draws the picture into *rgb (malloc; 3 bytes per pixel), grouped by bank, the tallest sprites of a bank first. False:
 * out of memory, or larger than a PNG can be. */
bool atlas_make(const struct cart *cart, const struct atlas_shapes *shapes, uint8_t **rgb, int *w, int *h);

#endif

/*
 * atlas.h - all sprites of a game on one picture: large enough to be looked at, with name, origin and what hits.
 */
#ifndef WORKBENCH_ATLAS_H
#define WORKBENCH_ATLAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../board/inspect.h"
#include "../../rom/cart.h"

enum { ATLAS_SCALE = 3 /* pixels of the atlas for one of a sprite */ };

/* The hit shapes that kinds of a game have, each with the sprite it belongs to. */
struct atlas_shapes {
    struct inspect_kind_shape *list; /* malloc; names point into the board */
    int n;
    bool failed; /* out of memory */
};
void atlas_shapes_add(void *shapes, const struct inspect_kind_shape *kind); /* for inspect_kinds */
void atlas_shapes_close(struct atlas_shapes *shapes);

/* A shape in words: "bullet moon: circle 8". */
void atlas_shape_words(const struct inspect_kind_shape *shape, char *out, size_t size);

/* Makes the picture, R G B a pixel: *rgb (free it). By banks, and in a bank large ones first. False: out of memory, or
 * larger than a PNG may be. */
bool atlas_make(const struct cart *cart, const struct atlas_shapes *shapes, uint8_t **rgb, int *w, int *h);

#endif

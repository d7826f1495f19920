/*
 * scale.h - enlarges pictures by any factor. If the edge between two scaled pixels falls inside a pixel, the colour of
 * that pixel is a mix, weighted by area.
 *
 * The result is the same as scaling by a very large integer and averaging. With an integer factor, nothing is mixed.
 * Only integers are used, so all hosts give the same result.
 */
#ifndef PLAYER_SCALE_H
#define PLAYER_SCALE_H

#include <stdbool.h>
#include <stdint.h>

/* One axis of a picture: the source of each pixel of the large picture. */
struct scale_axis {
    int n;           /* pixels of the large picture */
    uint16_t *from;  /* index of a pixel of the small picture; malloc */
    uint16_t *share; /* of the next pixel, of 256; 0 if there is none; malloc */
};

/* small and large: 1 to 65535 pixels. When out of memory, returns false, and there is nothing to close. */
bool scale_open(struct scale_axis *a, int small, int large);
void scale_close(struct scale_axis *a);

/* Makes pixels x0 to x1 of a large row from a small one. */
void scale_row(const struct scale_axis *a, const uint32_t *small, uint32_t *large, int x0, int x1);

/* Mixes two rows of n colours, 0xRRGGBB: `share` / 256 of the second and the rest of the first. */
void scale_mix(uint32_t *out, const uint32_t *first, const uint32_t *second, int share, int n);

#endif

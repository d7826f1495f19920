/*
 * scale.h - pictures of colours made larger, by any factor: squares stay squares, and where an edge between two falls
 * within a pixel, that one is mixed of both as far as it belongs to each.
 *
 * This is what a very large whole number and then the mean of all that a pixel covers would give. Where the size is a
 * whole multiple nothing is mixed at all. Integers only: the same on every host.
 */
#ifndef PLAYER_SCALE_H
#define PLAYER_SCALE_H

#include <stdbool.h>
#include <stdint.h>

/* One way of a picture: what a pixel of the large one is made of. */
struct scale_axis {
    int n;           /* pixels of the large one */
    uint16_t *from;  /* a pixel of the small one, and how much of the next one there is in it, of 256; malloc */
    uint16_t *share; /* with a share there is a next one */
};

/* small and large: 1 to 65535 pixels. False: no memory, and nothing to close. */
bool scale_open(struct scale_axis *a, int small, int large);
void scale_close(struct scale_axis *a);

/* Pixels x0 to x1 of a large row, of a small one. */
void scale_row(const struct scale_axis *a, const uint32_t *small, uint32_t *large, int x0, int x1);

/* out[i]: the mean of both, with `share` of 256 of the second; all are 0xRRGGBB. */
void scale_mix(uint32_t *out, const uint32_t *first, const uint32_t *second, int share, int n);

#endif

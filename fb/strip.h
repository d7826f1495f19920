/*
 * strip.h - draws a picture along a line with many corners, of any width and direction, with round ends.
 *
 * Positions are integers and square roots are correctly rounded (fx_root), so every host draws the same pixels. The
 * first guess of a root is a double: the caller must have set the board's arithmetic (host.h). No pixel is drawn twice
 * where two segments of the line meet (unless they meet at more than half a right angle), so blended strips show no
 * seams.
 */
#ifndef FB_STRIP_H
#define FB_STRIP_H

#include <stdbool.h>
#include <stdint.h>
#include "blit.h"

struct strip {
    const struct image *image;  /* its rows lie along the line, the first to the left of the direction of travel;
                                  repeated along the line */
    uint8_t bank;               /* as in blit_sprite */
    const uint8_t *blend_table; /* a table as in blit_blended, or NULL: opaque */
    int32_t width; /* Q16 px, 0 to 4096 px: the picture's height is stretched to it; below 1/8 px nothing is drawn */
    uint16_t offset_along; /* px by which the picture is moved along the line */
    bool dashed;           /* 4 px on, 4 px off, in the colours of the picture's first column */
};

/* A corner: Q16 px on the surface, within +-30000 px. */
struct strip_corner {
    int32_t x, y;
};

enum { STRIP_MAX_CORNERS = 512 };

/* Draws the strip along `n` corners, 1 to STRIP_MAX_CORNERS, clipped. Covers everything within half the width of the
 * line, and the outer corners of the bends. */
void strip_draw(struct fb *fb, const struct strip *s, const struct strip_corner *corner, int n);

#endif

/*
 * contrast.h - measures how well bullets stand out from the picture behind them.
 */
#ifndef MACHINE_CONTRAST_H
#define MACHINE_CONTRAST_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../fb/fb.h"

struct board;

/* A bullet with a hitbox, at least partly inside the field. */
struct contrast_bullet {
    const char *kind; /* name of the bullet's kind, valid until the next tick */
    int bank;
    int x, y;  /* in the field, px */
    int share; /* percent of the bullet's pixels that stand out; up to CONTRAST_FAINT_SHARE it is hardly visible */
};
typedef void contrast_visit(void *context, const struct contrast_bullet *bullet);

/* A pixel stands out if its weighted difference from the pixel behind it, 2 * red + 3 * green + 1 * blue, is at least
 * CONTRAST_THRESHOLD, out of 6 * 255. */
enum {
    CONTRAST_THRESHOLD = 6 * 40,
    CONTRAST_FAINT_SHARE = 10,
    CONTRAST_MAX_BULLETS = 512 /* most visited per picture */
};

/* Draws the picture behind the bullets into fb, then calls visit for up to CONTRAST_MAX_BULLETS bullets, in slot order.
 * scratch: board_scratch_size bytes. */
void contrast_sample(const struct board *b, struct fb *fb, void *scratch, contrast_visit *visit, void *context);

#endif

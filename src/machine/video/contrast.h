/*
 * contrast.h - do bullets stand out from what lies behind them?
 */
#ifndef MACHINE_CONTRAST_H
#define MACHINE_CONTRAST_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../fb/fb.h"

struct board;

/* A bullet that can hit, or can be met, of which some is inside the field. */
struct contrast_bullet {
    const char *kind; /* good until the next tick */
    int bank;
    int x, y;  /* in the field, px */
    int share; /* percent of its pixels that stand out; CONTRAST_FAINT and less: it can hardly be seen */
};
typedef void contrast_visit(void *context, const struct contrast_bullet *bullet);

/* A pixel stands out if 2 red, 3 green and 1 blue of its difference from the one behind it come to CONTRAST_STEP or
 * more, of 6 * 255. */
enum { CONTRAST_STEP = 6 * 40, CONTRAST_FAINT = 10, CONTRAST_BULLETS = 512 /* of a picture: the first so many */ };

/* Draws what lies behind the bullets into fb, and visits them. scratch: board_scratch bytes. */
void contrast_sample(const struct board *b, struct fb *fb, void *scratch, contrast_visit *visit, void *context);

#endif

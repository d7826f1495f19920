/*
 * screen.h - what moves or colours the picture as a whole: a shake of the field, a flash, bars, a dimmed picture.
 * Nothing here reaches a place or a hit.
 *
 * Each is what was asked for and the clock then; what it is now follows from the clock, so nothing counts down. A dim
 * goes by the frames since power-on, which go on while a pause menu stands over it.
 */
#ifndef MACHINE_SCREEN_H
#define MACHINE_SCREEN_H

#include "../../base/fx.h"
#include "../../base/slots.h"

enum { SHAKE_MOST = 64 /* px */, BARS_MOST = 2048 /* px */, SCREEN_FRAMES = 65535 };

struct screen {
    struct slots s;
    int32_t shake; /* px */
    uint32_t shake_over, shake_at;
    ang shake_dir;
    uint32_t shake_aimed; /* 1: to and fro along shake_dir; 0: all ways */
    uint32_t flash;       /* 0xRRGGBB */
    fx flash_share;       /* 0 to 1 */
    uint32_t flash_over, flash_at;
    int32_t bars_from, bars; /* px: from, to */
    uint32_t bars_over, bars_at;
    fx dim_from, dim; /* share of black, 0 to 1: from, to */
    uint32_t dim_over, dim_at;
};

extern const struct chip screen_chip;

/* None of them. */
void screen_empty(struct screen *s);

/* Bars of h px from now on over n frames, from what they are now. */
void screen_bars_to(struct screen *s, uint32_t clock, int32_t h, uint32_t n);

/* So many px the field's picture is off. In frame k of n, from 1 on, that is size * (n - k + 1) / n px: along the
 * direction with the turns of a quarter (there, middle, back, middle), or in a direction that goes on by the golden
 * angle. */
void screen_shake(const struct screen *s, uint32_t clock, int *dx, int *dy);

/* The share of the flash's colour in every colour, 0 to 1: in frame k of n, from 1 on, share * (n - k + 1) / n. */
fx screen_flash(const struct screen *s, uint32_t clock);

/* The height of each bar, px. After k of n frames it is from + (to - from) * k / n, cut off towards 0. */
int screen_bars(const struct screen *s, uint32_t clock);

/* Dims to that share of black from now on over n frames, from what it is now; and the share, by the same rule as the
 * bars' height. frame: since power-on. */
void screen_dim_to(struct screen *s, uint32_t frame, fx share, uint32_t n);
fx screen_dim(const struct screen *s, uint32_t frame);

#endif

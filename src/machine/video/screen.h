/*
 * screen.h - effects on the picture as a whole: a shake of the field, a flash, bars, and a dim. They affect neither
 * positions nor collisions.
 *
 * Each effect stores its parameters and the clock at which it started. Its current strength is computed from the clock,
 * so nothing counts down. A dim uses the frames since power-on instead, because they advance while the game is paused
 * behind a menu.
 */
#ifndef MACHINE_SCREEN_H
#define MACHINE_SCREEN_H

#include "../../base/fx.h"
#include "../../base/slots.h"

enum { MAX_SHAKE = 64 /* px */, MAX_BAR_HEIGHT = 2048 /* px */, MAX_EFFECT_FRAMES = 65535 };

struct screen {
    struct slots s;
    int32_t shake; /* amplitude, px */
    uint32_t shake_frames, shake_start;
    ang shake_dir;
    uint32_t shake_aimed;  /* 1: back and forth along shake_dir; 0: in all directions */
    uint32_t flash_colour; /* 0xRRGGBB */
    fx flash_share;        /* initial strength, 0 to 1 */
    uint32_t flash_frames, flash_start;
    int32_t bars_from, bars; /* height at the start and at the end, px */
    uint32_t bars_frames, bars_start;
    fx dim_from, dim; /* share of black at the start and at the end, 0 to 1 */
    uint32_t dim_frames, dim_start;
    uint32_t shows_whole; /* 1: the field's picture continues over the whole screen, as behind the title */
};

extern const struct chip screen_chip;

/* Ends all effects; leaves shows_whole unchanged. */
void screen_reset(struct screen *s);

/* Moves the bars from their current height to h px over n frames, starting now. */
void screen_move_bars(struct screen *s, uint32_t clock, int32_t h, uint32_t n);

/* Sets *dx and *dy to the px by which the field's picture is offset. In frame k of n, k from 1, the amplitude is shake
 * * (n - k + 1) / n px. An aimed shake repeats every four frames (forward, centre, backward, centre); otherwise the
 * direction advances by the golden angle each frame. */
void screen_get_shake(const struct screen *s, uint32_t clock, int *dx, int *dy);

/* Returns the share of the flash's colour to mix into every palette entry, 0 to 1. In frame k of n, k from 1, it is
 * flash_share * (n - k + 1) / n. */
fx screen_get_flash(const struct screen *s, uint32_t clock);

/* Returns the height of each bar, px. After k of n frames it is from + (to - from) * k / n, where the quotient is
 * truncated towards 0. */
int screen_get_bars(const struct screen *s, uint32_t clock);

/* screen_set_dim changes the dim from its current share of black to `share` over n frames, starting now. screen_get_dim
 * returns the current share, interpolated like the bars' height. frame: frames since power-on. */
void screen_set_dim(struct screen *s, uint32_t frame, fx share, uint32_t n);
fx screen_get_dim(const struct screen *s, uint32_t frame);

#endif

/*
 * window.h - the window on the screen that shows the field or, if rom.lua has a `view`, the part of the field at which
 * the camera is. Everything that converts between the field and the screen does it with these functions.
 */
#ifndef MACHINE_WINDOW_H
#define MACHINE_WINDOW_H

#include "machine.h"

struct window {
    int x, y, w, h; /* px of the screen */
    int left, top;  /* the field's pixel that the top left corner shows */
    int zoom;       /* px of the screen per px of the field */
};

/* Returns the window. A camera between two pixels shows the field from the lower one on, as entities are drawn at the
 * floor of their positions; so what moves with the camera does not tremble. */
struct window window_of(const struct board *b);

/* Return a position of the field in Q16 px of the screen, clamped to the range of fx. */
static inline int32_t window_screen_x(const struct window *w, fx x)
{
    return fx_sat(((int64_t)x - w->left * FX_ONE) * w->zoom + w->x * FX_ONE);
}

static inline int32_t window_screen_y(const struct window *w, fx y)
{
    return fx_sat(((int64_t)y - w->top * FX_ONE) * w->zoom + w->y * FX_ONE);
}

/* Return the position in the field, Q16 px, of a position of the screen: the inverse functions. */
static inline fx window_field_x(const struct window *w, int32_t x)
{
    return (fx)(((int64_t)x - w->x * FX_ONE) / w->zoom) + w->left * FX_ONE;
}

static inline fx window_field_y(const struct window *w, int32_t y)
{
    return (fx)(((int64_t)y - w->y * FX_ONE) / w->zoom) + w->top * FX_ONE;
}

/* Moves the camera towards the middle of the players in the game, other than ships that play on a page (input_play). If
 * there are none, it stays. */
void window_move_camera(struct board *b);

#endif

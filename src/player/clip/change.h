/*
 * change.h - what of a picture is another colour than in the one before.
 */
#ifndef PLAYER_CHANGE_H
#define PLAYER_CHANGE_H

#include <stdint.h>

/* Pixels; w 0: nothing. */
struct change {
    int x, y, w, h;
};

/* The smallest rectangle with all pixels whose colour is not the shown one. pix: w x h palette indices, rows on end. */
struct change change_find(const uint32_t *shown, const uint8_t *pix, const uint32_t rgb[256], int w, int h);

/* From then on the rectangle is shown. */
void change_take(uint32_t *shown, const uint8_t *pix, const uint32_t rgb[256], int w, const struct change *c);

#endif

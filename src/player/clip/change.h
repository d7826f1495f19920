/*
 * change.h - finds the part of a picture that differs from the previous one.
 */
#ifndef PLAYER_CHANGE_H
#define PLAYER_CHANGE_H

#include <stdint.h>

/* A rectangle of pixels; w is 0 if nothing changed. */
struct change {
    int x, y, w, h;
};

/* Returns the smallest rectangle that contains all pixels whose colours differ from `shown`. pix: w x h palette
 * indices, rows without padding. */
struct change change_find(const uint32_t *shown, const uint8_t *pix, const uint32_t rgb[256], int w, int h);

/* Copies the rectangle's colours to `shown`. */
void change_copy(uint32_t *shown, const uint8_t *pix, const uint32_t rgb[256], int w, const struct change *c);

#endif

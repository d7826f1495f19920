/*
 * words.h - reads what the program wrote over a picture, pixel by pixel.
 */
#ifndef TESTS_WORDS_H
#define TESTS_WORDS_H

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/player/overlay/canvas.h"

enum { WORDS_H = CANVAS_CELL_H - 1 };

/* Does the text stand at (x, y), on paper and in another colour? shape: it, drawn in a picture of its own. */
static inline bool words_at(const struct canvas *canvas, const struct fb *shape, int w, int x, int y)
{
    for (int i = 0; i < w * WORDS_H; i++) {
        bool inked = shape->pix[i / w * shape->pitch + i % w] != 0;
        uint8_t is = canvas->fb->pix[(y + i / w) * canvas->fb->pitch + x + i % w];
        if (inked == (is == canvas->colour[CANVAS_DARK]))
            return false;
    }
    return true;
}

/* Does it stand anywhere on the picture? Then x, y (unless NULL) are where, the topmost. */
static inline bool words_seen(const struct canvas *canvas, const char *text, int *at_x, int *at_y)
{
    int w = canvas_text_width(text) - 1, W = canvas->fb->w, H = canvas->fb->h;
    uint32_t rgb[256] = { 0 };
    void *mem = malloc(fb_size(w + 1, WORDS_H));
    bool seen = false;
    struct fb shape;
    struct canvas on;

    fb_init(&shape, mem, w + 1, WORDS_H);
    on = (struct canvas){ .fb = &shape, .rgb = rgb };
    memset(on.colour, 1, sizeof on.colour);
    canvas_text(&on, 0, 0, CANVAS_WHITE, text);
    for (int y = 0; y + WORDS_H <= H && !seen; y++)
        for (int x = 0; x + w <= W && !seen; x++) {
            seen = words_at(canvas, &shape, w, x, y);
            if (seen && at_x) {
                *at_x = x;
                *at_y = y;
            }
        }
    free(mem);
    return seen;
}

#endif

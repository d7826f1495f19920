/*
 * gif.h - makes an animated GIF in memory, one picture at a time.
 *
 * Colours are exact, as both pictures and GIF frames have at most 256. The first picture's palette is the global one;
 * a picture that needs other colours gets a local palette. Only the rectangle that changed is written. If an index is
 * unused and the result is smaller, unchanged pixels in the rectangle are transparent. A picture equal to the previous
 * one only extends its duration. The animation loops forever. The file depends only on the pictures and their times.
 */
#ifndef PLAYER_GIF_H
#define PLAYER_GIF_H

#include "change.h"
#include "../../common/byte_buffer.h"

enum {
    GIF_MAX_SIDE = 65535,
    GIF_UNITS_PER_SECOND = 100,
    GIF_MAX_FPS = 50 /* browsers slow down faster animations */
};

struct gif {
    struct byte_buffer out; /* the file */
    int w, h;
    uint32_t *canvas;                       /* the colours that are shown; malloc */
    uint8_t *rect;                          /* the changed rectangle; malloc */
    uint32_t palette[256];                  /* of the file */
    struct byte_buffer opaque, transparent; /* the rectangle compressed without and with transparency */
    size_t delay_at;                        /* offset of the last picture's delay; 0: no picture yet */
    uint32_t start;                         /* time of the last picture */
};

/* Starts a GIF of w x h pixels. Returns false when out of memory or too large. Close it either way. */
bool gif_open(struct gif *g, int w, int h);

/* Adds a picture that starts at the time `at`, in hundredths of a second: 0 for the first one, then increasing. pix:
 * palette indices, rows without padding. Colours are 0xRRGGBB. */
void gif_add(struct gif *g, const uint8_t *pix, const uint32_t rgb[256], uint32_t at);

/* Ends the last picture at `at` and completes the file in g->out. Returns false without a picture or when out of
 * memory. */
bool gif_end(struct gif *g, uint32_t at);

void gif_close(struct gif *g);

#endif

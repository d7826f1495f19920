/*
 * gif.h - an animated GIF, made in memory picture by picture.
 *
 * Every pixel has its exact colour: a picture has 256 at most, and so has a GIF's. The first picture's palette is the
 * whole file's; a picture that needs other colours brings its own. Only the rectangle that changed is written, and in
 * it, where an index is free, what stays is transparent if that is smaller. A picture like the one before is none: the
 * other one lasts longer. The animation repeats for ever. The bytes depend on the pictures and their times alone.
 */
#ifndef PLAYER_GIF_H
#define PLAYER_GIF_H

#include "change.h"
#include "../../common/byte_buffer.h"

enum {
    GIF_MAX_SIDE = 65535,
    GIF_SECOND = 100, /* units of time */
    GIF_RATE = 50     /* pictures a second: browsers slow down what is faster */
};

struct gif {
    struct byte_buffer out; /* the file */
    int w, h;
    uint32_t *shown;               /* malloc: colours */
    uint8_t *part;                 /* malloc: the rectangle */
    uint32_t palette[256];         /* of the file */
    struct byte_buffer solid, see; /* the rectangle, packed in two ways */
    size_t control;                /* where the last picture's delay is; 0: there is no picture */
    uint32_t begun;                /* when it begins */
};

/* Pictures of w x h. False: out of memory, or too large. Close it either way. */
bool gif_open(struct gif *g, int w, int h);

/* Adds a picture that is shown from `at` on, in hundredths of a second; the first one's is 0, each later one's is
 * later. pix: palette indices, rows on end; colours are 0xRRGGBB. */
void gif_add(struct gif *g, const uint8_t *pix, const uint32_t rgb[256], uint32_t at);

/* The last picture ends at `at`, and the file is in g->out. False: there is no picture, or there was no memory. */
bool gif_end(struct gif *g, uint32_t at);

void gif_close(struct gif *g);

#endif

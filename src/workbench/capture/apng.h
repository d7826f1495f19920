/*
 * apng.h - an animated PNG, made in memory picture by picture.
 *
 * Time is counted in sixtieths of a second, which an APNG can say exactly. Every pixel has its exact colour: as an
 * index while all pictures together have 256 colours at most, else in full. Only the rectangle that changed is written,
 * and a picture like the one before makes that one last longer. The animation repeats for ever; a reader that knows no
 * APNG shows its first picture.
 */
#ifndef WORKBENCH_APNG_H
#define WORKBENCH_APNG_H

#include "../../player/clip/change.h"
#include "../../common/byte_buffer.h"

enum { APNG_SECOND = 60 };

struct apng {
    struct byte_buffer out; /* the file */
    int w, h;
    bool full;             /* colours are in full, 3 bytes */
    bool too_many;         /* colours for indices: nothing is added any more */
    uint32_t *shown;       /* malloc: colours */
    uint8_t *part;         /* malloc: the rectangle's rows */
    uint32_t colours[256]; /* of all pictures, in the order they came in */
    int n_colours;
    uint32_t pictures, chunks; /* chunks: those with a running number */
    size_t control;            /* where the last picture's fcTL is */
    uint32_t begun;            /* when it begins */
};

/* Pictures of w x h; full: of any number of colours. False: out of memory, or too large. Close it either way. */
bool apng_open(struct apng *a, int w, int h, bool full);

/* Adds a picture that is shown from `at` on, in sixtieths; else as gif_add. Where its colours are too many for indices,
 * a->too_many is set, and all has to be done again in full. */
void apng_add(struct apng *a, const uint8_t *pix, const uint32_t rgb[256], uint32_t at);

/* The last picture ends at `at`, and the file is in a->out. False: there is no picture, too_many, or no memory. */
bool apng_end(struct apng *a, uint32_t at);

void apng_close(struct apng *a);

#endif

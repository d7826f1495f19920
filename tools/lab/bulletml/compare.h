/*
 * compare.h - two sides of one document, frame by frame and bullet by bullet.
 *
 * Bullets are matched by their numbers, which are those of creation: one too many or too few, at any time, and nothing
 * after it fits. That a bullet goes too far is no matter of a document: what is beyond COMPARE_X, COMPARE_Y on the
 * first side leaves on both.
 */
#ifndef BULLETML_COMPARE_H
#define BULLETML_COMPARE_H

#include "side.h"

#define COMPARE_X    192.40625 /* a field of 320 x 240 and some more: no bullet of a round speed ends a frame there */
#define COMPARE_Y    152.40625
#define COMPARE_MOST (1.0 / 16) /* px that a bullet may be off */

struct compared {
    int32_t frames;              /* compared */
    int32_t bullets;             /* that appeared */
    int64_t places;              /* compared: a bullet in a frame */
    double greatest;             /* distance, px */
    int32_t at_frame, at_bullet; /* where it was */
    bool alone;                  /* a bullet was on one side only: nothing was compared after it */
    bool broke;                  /* the reference crashed, or had no end, after so many frames */
    bool failed;                 /* the other side had an error */
    int32_t most;                /* bullets alive at once */
    int64_t left; /* bullets that went too far; those that the second side would have sent in another frame */
    int64_t otherwise;
    char what[SIDE_ERROR + 60]; /* a sentence, with alone, broke and failed */
};

/* Runs both for so many frames. Both are closed after it. */
void compare_sides(struct side *a, struct side *b, int32_t frames, struct compared *out);

/* Are the two alike? */
static inline bool compared_alike(const struct compared *c)
{
    return !c->alone && !c->broke && !c->failed && c->greatest <= COMPARE_MOST;
}

#endif

/*
 * flaws.h - what is measured of a recording to find mistakes in it.
 */
#ifndef WORKBENCH_FLAWS_H
#define WORKBENCH_FLAWS_H

#include "pcm.h"

/* Levels are of full scale. */
struct flaws {
    uint32_t clipped;   /* samples louder than full scale, or at full scale three and more times in a row */
    uint32_t first;     /* the frame of the first one */
    double mean;        /* of the channel with the larger one */
    bool clicks;        /* where the loop's end meets its beginning */
    double jump, usual; /* how far it bends there, and at most in the frames around */
};

/* Of all frames; p as it was read. */
void flaws_of_frames(const struct pcm *p, struct flaws *out);

/* Of the loop; p was prepared. */
void flaws_of_loop(const struct pcm *p, struct flaws *out);

#endif

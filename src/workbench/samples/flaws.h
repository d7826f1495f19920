/*
 * flaws.h - measurements that show mistakes in samples: clipping, offset, clicks.
 */
#ifndef WORKBENCH_FLAWS_H
#define WORKBENCH_FLAWS_H

#include "pcm.h"

/* Levels are of full scale. */
struct flaws {
    uint32_t clipped;   /* samples above full scale, or three or more at full scale in a row */
    uint32_t first;     /* the frame of the first one */
    double mean;        /* DC offset, of the worse channel */
    bool clicks;        /* between the loop's end and start */
    double jump, usual; /* second difference there, and the largest one nearby */
};

/* Of all frames; p as it was read. */
void flaws_of_frames(const struct pcm *p, struct flaws *out);

/* Of the loop; p was prepared. */
void flaws_of_loop(const struct pcm *p, struct flaws *out);

#endif

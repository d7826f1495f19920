/*
 * flaws.h - measures common flaws of samples: clipping, DC offset, clicks.
 */
#ifndef WORKBENCH_FLAWS_H
#define WORKBENCH_FLAWS_H

#include "pcm.h"

/* Levels are fractions of full scale. */
struct flaws {
    uint32_t clipped;       /* samples above full scale, or three or more at full scale in a row */
    uint32_t first_clipped; /* frame of the first clipped sample */
    double dc_offset;       /* of the worse channel */
    bool clicks;            /* between the loop's end and start */
    double jump, nearby;    /* the largest second difference at the loop point, and nearby */
};

/* Measures clipping and DC offset. Call it before pcm_prepare. */
void flaws_measure_frames(const struct pcm *p, struct flaws *out);

/* Measures clicks at the loop point. Call it after pcm_prepare. */
void flaws_measure_loop(const struct pcm *p, struct flaws *out);

#endif

/*
 * pcm.h - a recording as it was read from a file, before it is packed.
 */
#ifndef WORKBENCH_PCM_H
#define WORKBENCH_PCM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { PCM_CHANNELS = 2, PCM_RATE = 384000 /* the most that is read; what is above SND_RATE is lowered to it */ };

struct pcm {
    int16_t *frames; /* malloc; `channels` samples each */
    uint32_t n, room;
    uint32_t rate;
    int channels;
    uint32_t clipped, clipped_at; /* samples that were louder than full scale; the frame of the first */
    double tempo;                 /* beats a minute, if the file says it; else 0 */
    int64_t loop, loop_end;       /* frames; loop_end is the one behind its last. loop -1: none; loop_end -1: the end */
};

/* Adds n frames, full scale from -1 to 1; what is louder is cut. False: out of memory, or too long. */
bool pcm_add(struct pcm *p, const float *frames, size_t n);

/* Adds the frames of another one that has as many channels. False: the same. */
bool pcm_join(struct pcm *p, const struct pcm *more);

/* Is its loop within it, is it as long as may be? False and one sentence. */
bool pcm_check(const struct pcm *p, char *err, size_t err_size);

/* Cuts off what lies behind the loop's end, and takes a higher rate down to SND_RATE. False: out of memory. */
bool pcm_prepare(struct pcm *p);

/* One channel, or the mean of two where side is -1. out: p->n samples. */
void pcm_side(const struct pcm *p, int side, int16_t *out);

void pcm_free(struct pcm *p);

#endif

/*
 * pcm.h - samples as read from a file, before packing.
 */
#ifndef WORKBENCH_PCM_H
#define WORKBENCH_PCM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { PCM_CHANNELS = 2, PCM_RATE = 384000 /* the highest rate of a file; rates above SND_RATE are lowered to it */ };

struct pcm {
    int16_t *frames; /* malloc; `channels` samples each */
    uint32_t n, room;
    uint32_t rate;
    int channels;
    uint32_t clipped, clipped_at; /* samples that were louder than full scale; the frame of the first */
    double tempo;                 /* beats per minute, 0: not in the file */
    int64_t loop, loop_end;       /* frames; loop_end: after the last one. loop -1: none; loop_end -1: the end */
};

/* Adds n frames, full scale from -1 to 1; louder samples are clipped. False: out of memory, or too long. */
bool pcm_add(struct pcm *p, const float *frames, size_t n);

/* Adds frames with the same number of channels. False: the same. */
bool pcm_join(struct pcm *p, const struct pcm *more);

/* Checks length and loop. False and one sentence. */
bool pcm_check(const struct pcm *p, char *err, size_t err_size);

/* Cuts everything after the loop, and lowers a higher rate to SND_RATE. False: out of memory. */
bool pcm_prepare(struct pcm *p);

/* One channel, or the mean of two where side is -1. out: p->n samples. */
void pcm_side(const struct pcm *p, int side, int16_t *out);

void pcm_free(struct pcm *p);

/* Readers of files' bytes; pcm_free the result. False and one sentence without the file's name.
 *
 * WAV: PCM of 8, 16, 24 or 32 bits or floats, one or two channels, SAMPLE_MIN_RATE to PCM_RATE frames a second. The
 * loop is the first one of the chunk "smpl".
 *
 * sndfile: OGG (Vorbis, Opus) and FLAC, with libsndfile. The loop is that of the tags LOOPSTART and LOOPLENGTH (or
 * LOOPEND, the frame after it); those of Opus count at 48 kHz.
 *
 * module: tracker modules (.xm .it .s3m .mod), rendered by libopenmpt. A pass is everything from where the module
 * repeats to its end. If `loops`, the first pass is followed by the one that repeats exactly, if that is another
 * one. */
bool pcm_read_wav(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size);
bool pcm_read_sndfile(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size);
bool pcm_read_module(const uint8_t *data, size_t n, bool loops, struct pcm *out, char *err, size_t err_size);

#endif

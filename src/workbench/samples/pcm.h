/*
 * pcm.h - samples as read from a file, before packing.
 */
#ifndef WORKBENCH_PCM_H
#define WORKBENCH_PCM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { PCM_CHANNELS = 2, PCM_RATE = 384000 /* highest rate of a file; rates above SND_RATE are resampled */ };

struct pcm {
    int16_t *frames; /* malloc; `channels` samples each */
    uint32_t n, capacity;
    uint32_t rate;
    int channels;
    uint32_t clipped, clipped_at; /* samples above full scale; frame of the first */
    double tempo;                 /* beats per minute; 0: not in the file */
    int64_t loop, loop_end;       /* frames; loop_end: after the last one. loop -1: none; loop_end -1: the end */
};

/* Appends n frames; full scale is -1 to 1, and louder samples are clipped. False: out of memory, or too long. */
bool pcm_add(struct pcm *p, const float *frames, size_t n);

/* Appends the frames of `more`, which has as many channels. False: out of memory, or too long. */
bool pcm_join(struct pcm *p, const struct pcm *more);

/* Checks length and loop. */
bool pcm_check(const struct pcm *p, char *err, size_t err_size);

/* Removes everything after the loop, and resamples a rate above SND_RATE. False: out of memory. */
bool pcm_prepare(struct pcm *p);

/* Copies a channel to out, p->n samples. channel -1: the mean of both. */
void pcm_channel(const struct pcm *p, int channel, int16_t *out);

void pcm_free(struct pcm *p);

/* Read a file; free the result with pcm_free. Errors don't name the file.
 *
 * WAV: PCM of 8, 16, 24 or 32 bits or floats, one or two channels, SAMPLE_MIN_RATE to PCM_RATE frames a second. The
 * loop is the first one of the chunk "smpl".
 *
 * sndfile: OGG (Vorbis, Opus) and FLAC, with libsndfile. The loop is that of the tags LOOPSTART and LOOPLENGTH (or
 * LOOPEND, the frame after it); those of Opus count at 48 kHz.
 *
 * module: tracker modules (.xm .it .s3m .mod), rendered by libopenmpt. A pass lasts from the position at which the
 * module restarts to its end. If `loops`, passes are added until one repeats exactly. */
bool pcm_read_wav(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size);
bool pcm_read_sndfile(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size);
bool pcm_read_module(const uint8_t *data, size_t n, bool loops, struct pcm *out, char *err, size_t err_size);

#endif

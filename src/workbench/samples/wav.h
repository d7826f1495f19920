/*
 * wav.h - recordings in WAV files.
 *
 * PCM of 8, 16, 24 or 32 bits or floats, one or two channels, SAMPLE_MIN_RATE to PCM_RATE frames a second. The first
 * loop of the chunk "smpl" is kept.
 */
#ifndef WORKBENCH_WAV_H
#define WORKBENCH_WAV_H

#include "pcm.h"

/* Reads a file's bytes; pcm_free what it gives. False and one sentence without the file's name. */
bool wav_read(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size);

#endif

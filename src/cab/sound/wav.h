/*
 * wav.h - recordings in WAV files, to a sample (adpcm.h).
 * floor: cab
 *
 * PCM of 8, 16, 24 or 32 bits, one or two channels, SAMPLE_RATE to SND_RATE frames a second; two channels become one.
 * A loop of the chunk "smpl" is kept: what lies behind its end goes.
 */
#ifndef CAB_WAV_H
#define CAB_WAV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Reads a file's bytes. *out (free it) is a sample. False and one sentence without the file's name. */
bool wav_read(const uint8_t *data, size_t n, uint8_t **out, size_t *size, char *err, size_t err_size);

#endif

/*
 * loudness.h - the loudness of stereo samples at 48 kHz in LUFS, as in ITU-R BS.1770-4. A sound shorter than a block of
 * 0.4 s is measured as one block.
 */
#ifndef WORKBENCH_LOUDNESS_H
#define WORKBENCH_LOUDNESS_H

#include <stddef.h>
#include <stdint.h>

/* Returns the loudness; -70 for silence, and when out of memory. */
double loudness(const int16_t *lr, size_t frames);

/* Return the largest sample and the root mean square in decibels of full scale. */
double loudness_peak(const int16_t *lr, size_t frames);
double loudness_mean(const int16_t *lr, size_t frames);

#endif

/*
 * loudness.h - the loudness of two channels at 48 kHz in LUFS, as in ITU-R BS.1770-4. A sound shorter than a block of
 * 0.4 s counts as one block.
 */
#ifndef WORKBENCH_LOUDNESS_H
#define WORKBENCH_LOUDNESS_H

#include <stddef.h>
#include <stdint.h>

/* Returns the loudness; -70 for silence, and when out of memory. */
double loudness(const int16_t *lr, size_t frames);

/* The largest sample and the root of the mean square, in decibels of full scale. */
double loudness_peak(const int16_t *lr, size_t frames);
double loudness_mean(const int16_t *lr, size_t frames);

#endif

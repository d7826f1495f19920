/*
 * loudness.h - how loud sound is to an ear: ITU-R BS.1770-4, in LUFS, of two channels at 48 kHz.
 *
 * What is shorter than a block of 0.4 s counts as one.
 */
#ifndef WORKBENCH_LOUDNESS_H
#define WORKBENCH_LOUDNESS_H

#include <stddef.h>
#include <stdint.h>

/* -70 and less: nothing is heard; so it is for a lack of memory. */
double loudness(const int16_t *lr, size_t frames);

/* The largest sample and the root of the mean square, in decibels of full scale. */
double loudness_peak(const int16_t *lr, size_t frames);
double loudness_mean(const int16_t *lr, size_t frames);

#endif

/*
 * encode.h - encodes samples for adpcm.h.
 */
#ifndef WORKBENCH_ENCODE_H
#define WORKBENCH_ENCODE_H

#include "../../sound/adpcm.h"

/* Writes n samples with their header, sample_size bytes. */
void encode_sample(uint8_t *out, const int16_t *in, uint32_t n, uint32_t rate, uint32_t loop,
                   enum sample_coding coding);

#endif

/*
 * lzw.h - LZW compression for GIF: codes of 9 to 12 bits, in blocks of at most 255 bytes.
 */
#ifndef PLAYER_LZW_H
#define PLAYER_LZW_H

#include "../../common/byte_buffer.h"

/* Appends the code size, the blocks and the terminating empty block. */
void lzw_append(struct byte_buffer *out, const uint8_t *bytes, size_t n);

#endif

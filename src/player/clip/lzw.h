/*
 * lzw.h - the compression of GIF: bytes to codes of 9 to 12 bits, in blocks of at most 255 bytes.
 */
#ifndef PLAYER_LZW_H
#define PLAYER_LZW_H

#include "../../common/byte_buffer.h"

/* Adds the code size, the blocks and the empty one that ends them. The output depends on nothing but the bytes. */
void lzw_put(struct byte_buffer *out, const uint8_t *bytes, size_t n);

#endif

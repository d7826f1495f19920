/*
 * compress.h - compresses a ROM (format: src/rom/compressed.h).
 */
#ifndef WORKBENCH_COMPRESS_H
#define WORKBENCH_COMPRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Compresses to *out (malloc) of `size` bytes, which depend only on the ROM. *out is NULL if the ROM should stay
 * uncompressed: it would not be smaller, or no reader would accept it. False: out of memory. */
bool compress_rom(const void *rom, size_t rom_size, uint8_t **out, size_t *size);

#endif

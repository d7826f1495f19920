/*
 * compress.h - a ROM to its compressed file (src/rom/compressed.h).
 */
#ifndef WORKBENCH_COMPRESS_H
#define WORKBENCH_COMPRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Makes *out (free it) of `size` bytes. They depend on nothing but the ROM. NULL: it stays plain, for compressed it
 * would be no smaller, or is one that no reader takes. False: out of memory. */
bool compress_rom(const void *rom, size_t rom_size, uint8_t **out, size_t *size);

#endif

/*
 * png.h - PNG files in and out: the only place that knows stb.
 */
#ifndef PLAYER_PNG_H
#define PLAYER_PNG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    PNG_MAX_SIDE = 16384,     /* px, read or written */
    PNG_MAX_PIXELS = 1 << 24, /* of a picture read */
    PNG_MAX_BYTES = 1 << 28   /* of a file read */
};

/* Makes a whole PNG file of w x h palette indices: *out (free it) and *size. Colours are 0xRRGGBB. The bytes depend on
 * nothing but the picture. False: no memory, or a side out of range. */
bool png_write(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256], uint8_t **out, size_t *size);

/* The same of full colours: 3 bytes R G B a pixel, rows on end. */
bool png_write_rgb(const uint8_t *rgb, int w, int h, uint8_t **out, size_t *size);

/* For files that are made of chunks elsewhere. A big-endian number of 4 bytes. A chunk of n bytes of data at p, which
 * has room for 12 more; returns its end. Compressed pixels, each row after its filter byte: *out (free it); false: no
 * memory. */
void png_be32(uint8_t *p, uint32_t v);
uint8_t *png_chunk(uint8_t *p, const char type[4], const uint8_t *data, uint32_t n);
bool png_deflate(uint8_t *raw, size_t n, uint8_t **out, size_t *size);

/* Reads a PNG file of any kind into *rgba (free it), 4 bytes a pixel, rows on end. False and one sentence, without the
 * file's name, for anything damaged or too large. */
bool png_read(const uint8_t *data, size_t n, uint8_t **rgba, int *w, int *h, char *err, size_t err_size);

/* The same, and of a PNG of palette indices those too, in *index (free it), a byte a pixel; of others NULL. */
bool png_read_indexed(const uint8_t *data, size_t n, uint8_t **rgba, uint8_t **index, int *w, int *h, char *err,
                      size_t err_size);

/* Inflates zlib data, which files elsewhere hold too, into `out`, which has room for size + 1 bytes. False: it is
 * damaged, or does not inflate to just that size. */
bool png_inflate(const uint8_t *packed, size_t n, uint8_t *out, size_t size);

/* Was a file written by png_write or png_write_rgb? Tells from its first n bytes. */
bool png_is_signed(const uint8_t *head, size_t n);

#endif

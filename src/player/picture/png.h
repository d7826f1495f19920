/*
 * png.h - reads and writes PNG files. Only png.c uses stb.
 */
#ifndef PLAYER_PNG_H
#define PLAYER_PNG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    PNG_MAX_SIDE = 16384,     /* px, read or written */
    PNG_MAX_PIXELS = 1 << 24, /* when reading */
    PNG_MAX_BYTES = 1 << 28   /* of a file, when reading */
};

/* Makes a PNG file of w x h palette indices and stores it in *out (free it) and *size. Colours are 0xRRGGBB. The file
 * depends only on the picture. Returns false when out of memory, or if a side is out of range. */
bool png_write(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256], uint8_t **out, size_t *size);

/* The same for true-colour pictures: 3 bytes R G B or 4 bytes R G B A per pixel, rows without padding. */
bool png_write_rgb(const uint8_t *rgb, int w, int h, uint8_t **out, size_t *size);
bool png_write_rgba(const uint8_t *rgba, int w, int h, uint8_t **out, size_t *size);

/* Helpers for other files made of chunks. png_be32 writes a big-endian number of 4 bytes. png_chunk writes a chunk of
 * 12 + n bytes to p and returns its end. png_deflate compresses data into *out (free it) and returns false when out of
 * memory. */
void png_be32(uint8_t *p, uint32_t v);
uint8_t *png_chunk(uint8_t *p, const char type[4], const uint8_t *data, uint32_t n);
bool png_deflate(uint8_t *raw, size_t n, uint8_t **out, size_t *size);

/* Reads any PNG file into *rgba (free it): 4 bytes per pixel, rows without padding. If the file is damaged or too
 * large, returns false and sets err to a sentence without the file's name. */
bool png_read(const uint8_t *data, size_t n, uint8_t **rgba, int *w, int *h, char *err, size_t err_size);

/* Like png_read. Also stores palette indices in *index (free it), one byte per pixel; NULL if the PNG has none. */
bool png_read_indexed(const uint8_t *data, size_t n, uint8_t **rgba, uint8_t **index, int *w, int *h, char *err,
                      size_t err_size);

/* Inflates zlib data into `out`, a buffer of size + 1 bytes. Returns false if the data is damaged or does not inflate
 * to exactly `size` bytes. */
bool png_inflate(const uint8_t *packed, size_t n, uint8_t *out, size_t size);

/* Returns whether png_write or png_write_rgb wrote a file, judging by its first n bytes. */
bool png_is_signed(const uint8_t *head, size_t n);

#endif

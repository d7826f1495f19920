/*
 * face.h - a game's proportional font, compiled by the packer from one of `fonts` in rom.lua.
 *
 * The lump "fonts/NAME": u16 height of a line in px, u16 zero, u32 number of glyphs; for each glyph, ascending by code,
 * u32 code, u32 offset of its pixels in the lump, u8 w h, i8 x y of the glyph's top left corner, relative to the pen
 * and the line's top, u8 advance, 3 zero bytes; then the pixels, in rows of w padded with zeros to a multiple of 8,
 * shades 0 to 15.
 */
#ifndef ROM_FACE_H
#define ROM_FACE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    FACE_HEADER_SIZE = 8,
    FACE_GLYPH_SIZE = 16, /* bytes */
    FACE_MAX_GLYPHS = 65536,
    FACE_MAX_SIDE = 64, /* maximum width and height of a glyph, px */
    FACE_MAX_HEIGHT = 128
};

struct face {
    const uint8_t *data;
    uint32_t n;
    int height;
};

struct face_glyph {
    const uint8_t *pix;
    int w, h, pitch;
    int x, y, advance;
};

/* Checks a lump and opens it. The lump must outlive f. Returns false, with one sentence in err, if it is not a valid
 * font. */
bool face_open(struct face *f, const uint8_t *data, size_t size, char *err, size_t err_size);

/* Opens a lump that face_open has accepted. */
struct face face_of(const uint8_t *data);

/* Finds the glyph of a character code. Returns false if the font has no such glyph. */
bool face_find(const struct face *f, uint32_t code, struct face_glyph *out);

#endif

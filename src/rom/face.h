/*
 * face.h - a font of a game whose characters have widths of their own: what the packer makes of one of `fonts` in
 * rom.lua.
 *
 * The lump "fonts/NAME": u16 height of a line in px, u16 zero, u32 how many glyphs; for each, ascending by code, u32
 * code, u32 where its pixels begin in the lump, u8 w h, i8 x y of its top left corner from the pen and the line's top,
 * u8 advance, 3 zero bytes; then the pixels, rows of w padded with zeros to a multiple of 8, shades 0 to 15.
 */
#ifndef ROM_FACE_H
#define ROM_FACE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    FACE_HEAD = 8,
    FACE_GLYPH = 16, /* bytes */
    FACE_MAX = 65536,
    FACE_SIDE = 64, /* px of a glyph, each way */
    FACE_HEIGHT = 128
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

/* Checks a lump once; it must outlive face. False and one sentence else. */
bool face_open(struct face *f, const uint8_t *data, size_t size, char *err, size_t err_size);

/* The same of a lump that was checked. */
struct face face_of(const uint8_t *data);

/* The glyph of a code; false: it has none. */
bool face_find(const struct face *f, uint32_t code, struct face_glyph *out);

#endif

/*
 * face.c - see face.h. Every pixel is checked, because a blit copies eight pixels at a time and would show padding that
 * is not 0.
 */
#include "face.h"

#include <inttypes.h>
#include "../base/bytes.h"
#include "../base/err.h"

static const uint8_t *entry(const struct face *f, uint32_t i)
{
    return f->data + FACE_HEADER_SIZE + (size_t)i * FACE_GLYPH_SIZE;
}

static uint32_t code_at(const struct face *f, uint32_t i)
{
    return bytes_get32(entry(f, i));
}

static void glyph_at(const struct face *f, uint32_t i, struct face_glyph *g)
{
    const uint8_t *p = entry(f, i);

    *g = (struct face_glyph){ .pix = f->data + bytes_get32(p + 4),
                              .w = p[8],
                              .h = p[9],
                              .pitch = (p[8] + 7) / 8 * 8,
                              .x = (int8_t)p[10],
                              .y = (int8_t)p[11],
                              .advance = p[12] };
}

struct face face_of(const uint8_t *data)
{
    return (struct face){ data, bytes_get32(data + 4), bytes_get16(data) };
}

static bool pixels_ok(const struct face_glyph *g)
{
    for (int y = 0; y < g->h; y++)
        for (int x = 0; x < g->pitch; x++)
            if (g->pix[y * g->pitch + x] > (x < g->w ? 15 : 0))
                return false;
    return true;
}

static bool glyph_ok(const struct face *f, uint32_t i, size_t size)
{
    const uint8_t *p = entry(f, i);
    const size_t first = FACE_HEADER_SIZE + (size_t)f->n * FACE_GLYPH_SIZE, at = bytes_get32(p + 4);
    struct face_glyph g;

    glyph_at(f, i, &g);
    return g.w <= FACE_MAX_SIDE && g.h <= FACE_MAX_SIDE && g.advance <= FACE_MAX_HEIGHT && p[13] == 0 && p[14] == 0 &&
           p[15] == 0 && at >= first && at <= size && (size_t)(g.pitch * g.h) <= size - at && pixels_ok(&g);
}

bool face_open(struct face *f, const uint8_t *data, size_t size, char *err, size_t err_size)
{
    if (size < FACE_HEADER_SIZE)
        return err_set(err, err_size, "not a font (%zu bytes)", size);
    *f = face_of(data);
    if (f->height < 1 || f->height > FACE_MAX_HEIGHT || bytes_get16(data + 2) != 0 || f->n > FACE_MAX_GLYPHS ||
        size - FACE_HEADER_SIZE < (size_t)f->n * FACE_GLYPH_SIZE)
        return err_set(err, err_size, "its header is out of range");
    for (uint32_t i = 0; i < f->n; i++) {
        if (i > 0 && code_at(f, i) <= code_at(f, i - 1))
            return err_set(err, err_size, "glyph %" PRIu32 " is out of order (expected ascending codes)", i);
        if (!glyph_ok(f, i, size))
            return err_set(err, err_size, "glyph %" PRIu32 " is out of range", i);
    }
    return true;
}

bool face_find(const struct face *f, uint32_t code, struct face_glyph *out)
{
    uint32_t lo = 0, hi = f->n;

    while (lo < hi) {
        uint32_t mid = lo + (hi - lo) / 2;
        if (code_at(f, mid) == code) {
            glyph_at(f, mid, out);
            return true;
        }
        if (code_at(f, mid) < code)
            lo = mid + 1;
        else
            hi = mid;
    }
    return false;
}

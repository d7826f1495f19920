/*
 * ttf.c - see ttf.h. stb_truetype converts outlines to coverage.
 *
 * stb_truetype trusts every offset in a font. Therefore this file reads the tables and the character map itself, with
 * bounds, and stb_truetype gets only outlines that check_glyph has accepted: all bytes that it reads are in the glyph,
 * components are not nested deeper than MAX_DEPTH, and the picture is at most FACE_MAX_SIDE px wide and high.
 *
 * A ROM must not depend on the host. stb_truetype computes in floating point, but only with additions, multiplications,
 * divisions, square roots and roundings of floats, which IEEE 754 defines exactly; the build turns fused operations off
 * (-ffp-contract=off), and FLT_EVAL_METHOD is checked below.
 */
#include "ttf.h"

#include <float.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../rom/face.h"

_Static_assert(FLT_EVAL_METHOD == 0, "floats must be computed as floats");

/* stb_truetype reads the point after a contour's first point, even if there is none. */
enum { SPARE = 64 /* bytes, at least a point */ };

/* Allocates zeros. Remembers a failure in *failed, because stb_truetype then draws an empty glyph. */
static void *allocate(size_t n, bool *failed)
{
    void *p = calloc(1, n + SPARE);

    *failed = *failed || p == NULL;
    return p;
}

#define STBTT_malloc(n, failed) allocate(n, failed)
#define STBTT_free(p, failed)   ((void)(failed), free(p))
#define STBTT_assert(x)         ((void)0)
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

enum {
    MAX_DEPTH = 8,     /* of components in components */
    MAX_PARTS = 256,   /* components of a character */
    MAX_POINTS = 65536 /* of a character */
};

/* A table of the font, or a part of one. */
struct table {
    const uint8_t *data; /* NULL: the font has no such table */
    size_t n;
};

struct font {
    struct table head, hhea, hmtx, maxp, loca, glyf, cmap;
    struct table map; /* the Unicode part of cmap, of format 4 or 12 */
    int glyphs, units /* per em */, size, ascent;
    int parts, points; /* of the glyph that is checked */
    stbtt_fontinfo info;
    bool out_of_memory;
    char *err;
    size_t err_size;
};

/* ---- bounded reading; beyond the end are zeros ---- */

static uint32_t get16(const struct table *t, size_t at)
{
    return at + 2 <= t->n ? (uint32_t)t->data[at] << 8 | t->data[at + 1] : 0;
}

static int get_signed(const struct table *t, size_t at)
{
    return (int16_t)get16(t, at);
}

static uint32_t get32(const struct table *t, size_t at)
{
    return get16(t, at) << 16 | get16(t, at + 2);
}

static struct table part(const struct table *t, size_t at, size_t n)
{
    return at <= t->n && n <= t->n - at ? (struct table){ t->data + at, n } : (struct table){ 0 };
}

/* ---- tables ---- */

static struct table find_table(const struct table *file, const char *tag)
{
    const size_t n = get16(file, 4);

    for (size_t i = 0, at = 12; i < n && at + 16 <= file->n; i++, at += 16)
        if (memcmp(file->data + at, tag, 4) == 0)
            return part(file, get32(file, at + 8), get32(file, at + 12));
    return (struct table){ 0 };
}

/* Finds the tables. Returns the tag of one that is missing or too short, or NULL. */
static const char *find_tables(struct font *f, const struct table *file)
{
    const struct {
        const char *tag;
        struct table *table;
        size_t n; /* the least */
    } all[] = { { "head", &f->head, 54 }, { "hhea", &f->hhea, 36 }, { "maxp", &f->maxp, 6 }, { "cmap", &f->cmap, 4 },
                { "hmtx", &f->hmtx, 4 },  { "loca", &f->loca, 4 },  { "glyf", &f->glyf, 0 } };

    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        *all[i].table = find_table(file, all[i].tag);
        if (all[i].table->data == NULL || all[i].table->n < all[i].n)
            return all[i].tag;
    }
    f->glyphs = (int)get16(&f->maxp, 4);
    f->units = (int)get16(&f->head, 18);
    const size_t widths = get16(&f->hhea, 34);
    if (f->units == 0 || get16(&f->head, 50) > 1)
        return "head";
    if (f->cmap.n < 4 + 8 * (size_t)get16(&f->cmap, 2))
        return "cmap";
    if (f->loca.n / (get16(&f->head, 50) ? 4 : 2) < (size_t)f->glyphs + 1)
        return "loca";
    return widths == 0 || f->hmtx.n < 4 * widths ? "hmtx" : NULL;
}

/* Finds the Unicode part of cmap, preferably the one with all of Unicode. */
static bool find_map(struct font *f)
{
    for (size_t i = 0, n = get16(&f->cmap, 2); i < n; i++) {
        const uint32_t platform = get16(&f->cmap, 4 + 8 * i), encoding = get16(&f->cmap, 6 + 8 * i),
                       at = get32(&f->cmap, 8 + 8 * i);
        const bool unicode = platform == 0 || (platform == 3 && (encoding == 1 || encoding == 10));
        const struct table map = unicode && at < f->cmap.n ? part(&f->cmap, at, f->cmap.n - at) : (struct table){ 0 };
        const uint32_t format = get16(&map, 0);
        if (format == 12 || (format == 4 && f->map.data == NULL))
            f->map = map;
    }
    return f->map.data != NULL;
}

/* ---- characters ---- */

static uint32_t glyph_in_segments(const struct table *map, uint32_t code)
{
    const size_t n2 = get16(map, 6) & ~1u; /* bytes of each array */

    for (size_t at = 14; at < 14 + n2 && code <= 0xffff; at += 2) {
        const uint32_t first = get16(map, at + n2 + 2), delta = get16(map, at + 2 * n2 + 2),
                       offset = get16(map, at + 3 * n2 + 2);
        if (code > get16(map, at))
            continue;
        if (code < first)
            return 0;
        const uint32_t glyph = offset ? get16(map, at + 3 * n2 + 2 + offset + 2 * (size_t)(code - first)) : code;
        return glyph ? (glyph + delta) & 0xffff : 0;
    }
    return 0;
}

static uint32_t glyph_in_groups(const struct table *map, uint32_t code)
{
    size_t lo = 0, hi = get32(map, 12);

    hi = map->n < 16 ? 0 : hi > (map->n - 16) / 12 ? (map->n - 16) / 12 : hi;
    while (lo < hi) {
        const size_t mid = lo + (hi - lo) / 2, at = 16 + 12 * mid;
        if (code < get32(map, at))
            hi = mid;
        else if (code > get32(map, at + 4))
            lo = mid + 1;
        else
            return get32(map, at + 8) + code - get32(map, at);
    }
    return 0;
}

/* Returns the character's glyph, or 0 if the font has none. */
static int find_glyph(const struct font *f, uint32_t code)
{
    const uint32_t glyph = get16(&f->map, 0) == 12 ? glyph_in_groups(&f->map, code) : glyph_in_segments(&f->map, code);

    return glyph < (uint32_t)f->glyphs ? (int)glyph : 0;
}

/* ---- outlines ---- */

static bool check_outline(struct font *f, const struct table *glyph, int contours)
{
    size_t at = 10 + 2 * (size_t)contours + 2, coordinates = 0;
    int n = 0, repeats = 0;
    uint8_t flags = 0;

    if (at > glyph->n)
        return false;
    for (int i = 0; i < contours; i++) {
        const int end = (int)get16(glyph, 10 + 2 * (size_t)i) + 1;
        if (end <= n)
            return false;
        n = end;
    }
    f->points += n;
    at += get16(glyph, at - 2); /* instructions */
    for (int i = 0; i < n; i++, repeats--) {
        if (repeats == 0) {
            if (at + 2 > glyph->n)
                return false;
            flags = glyph->data[at++];
            repeats = flags & 8 ? glyph->data[at++] + 1 : 1;
        }
        coordinates += flags & 2 ? 1 : flags & 16 ? 0 : 2;
        coordinates += flags & 4 ? 1 : flags & 32 ? 0 : 2;
    }
    return f->points <= MAX_POINTS && at <= glyph->n && coordinates <= glyph->n - at;
}

static bool check_glyph(struct font *f, int glyph, int depth);

/* Components are placed by distances; those placed by points are not supported. */
static bool check_parts(struct font *f, const struct table *glyph, int depth)
{
    enum { WORDS = 1, DISTANCES = 2, SCALE = 8, MORE = 32, TWO_SCALES = 64, MATRIX = 128 };
    uint32_t flags = MORE;

    for (size_t at = 10; flags & MORE;) {
        flags = get16(glyph, at);
        const int component = (int)get16(glyph, at + 2);
        at += flags & WORDS ? 8 : 6;
        at += flags & SCALE ? 2 : flags & TWO_SCALES ? 4 : flags & MATRIX ? 8 : 0;
        if (at > glyph->n || !(flags & DISTANCES) || ++f->parts > MAX_PARTS || !check_glyph(f, component, depth + 1))
            return false;
    }
    return true;
}

/* Returns whether stb_truetype can read the glyph. */
static bool check_glyph(struct font *f, int glyph, int depth)
{
    const bool wide = get16(&f->head, 50) == 1;
    const size_t i = (size_t)glyph, at = wide ? get32(&f->loca, 4 * i) : 2 * (size_t)get16(&f->loca, 2 * i),
                 end = wide ? get32(&f->loca, 4 * i + 4) : 2 * (size_t)get16(&f->loca, 2 * i + 2);

    if (glyph >= f->glyphs || depth > MAX_DEPTH || at > end || end > f->glyf.n)
        return false;
    if (at == end)
        return true;
    const struct table data = part(&f->glyf, at, end - at);
    const int contours = get_signed(&data, 0);
    if (data.n < 10)
        return false;
    return contours < 0 ? check_parts(f, &data, depth) : contours == 0 || check_outline(f, &data, contours);
}

/* Rounds font units to pixels. */
static int to_pixels(const struct font *f, int units)
{
    const int doubled = 2 * units * f->size + f->units;

    return doubled >= 0 ? doubled / (2 * f->units) : -((2 * f->units - 1 - doubled) / (2 * f->units));
}

struct box {
    int x0, y0, x1, y1;
};

/* Sets the pixels around an outline, y downwards from the baseline. */
static struct box find_box(const stbtt_vertex *v, int n, float scale)
{
    int x0 = INT_MAX, y0 = INT_MAX, x1 = INT_MIN, y1 = INT_MIN;

    for (int i = 0; i < n; i++)
        for (int k = 0; k <= (v[i].type == STBTT_vcurve); k++) {
            const int x = k ? v[i].cx : v[i].x, y = k ? v[i].cy : v[i].y;
            x0 = x < x0 ? x : x0;
            x1 = x > x1 ? x : x1;
            y0 = y < y0 ? y : y0;
            y1 = y > y1 ? y : y1;
        }
    if (n == 0)
        return (struct box){ 0 };
    return (struct box){ STBTT_ifloor((float)x0 * scale), STBTT_ifloor((float)-y1 * scale),
                         STBTT_iceil((float)x1 * scale), STBTT_iceil((float)-y0 * scale) };
}

/* Draws an outline as shades. */
static uint8_t *draw_outline(struct font *f, stbtt_vertex *v, int n, struct box b, float scale)
{
    const size_t pixels = (size_t)(b.x1 - b.x0) * (size_t)(b.y1 - b.y0);
    uint8_t *pix = calloc(pixels + 1, 1);
    stbtt__bitmap to = { .w = b.x1 - b.x0, .h = b.y1 - b.y0, .stride = b.x1 - b.x0, .pixels = pix };

    f->out_of_memory = f->out_of_memory || pix == NULL;
    if (pix == NULL || pixels == 0)
        return pix;
    stbtt_Rasterize(&to, 0.35f /* px, flatness */, v, n, scale, scale, 0, 0, b.x0, b.y0, 1, &f->out_of_memory);
    for (size_t i = 0; i < pixels; i++)
        pix[i] = pix[i] >= 128 ? 15 : 0;
    return pix;
}

/* Refuses a glyph that doesn't fit in a font of face.h. */
static bool check_size(const struct font *f, uint32_t code, const struct pack_font_glyph *g)
{
    if (g->w > FACE_MAX_SIDE || g->h > FACE_MAX_SIDE || g->advance > FACE_MAX_HEIGHT)
        return err_set(f->err, f->err_size, "U+%04X: %dx%d px; expected at most %d in each direction", (unsigned)code,
                       g->w, g->h, FACE_MAX_SIDE);
    if (g->x < -128 || g->x > 127 || g->y < -128 || g->y > 127)
        return err_set(f->err, f->err_size, "U+%04X is too far from the baseline", (unsigned)code);
    return true;
}

static bool add_glyph(struct font *f, struct pack_font *to, uint32_t code, int glyph)
{
    const int widths = (int)get16(&f->hhea, 34), width = glyph < widths ? glyph : widths - 1;
    const float scale = (float)f->size / (float)f->units;
    stbtt_vertex *v = NULL;

    f->parts = f->points = 0;
    if (!check_glyph(f, glyph, 0))
        return err_set(f->err, f->err_size, "U+%04X: the outline is damaged or not supported", (unsigned)code);
    const int n = stbtt_GetGlyphShape(&f->info, glyph, &v);
    const struct box b = find_box(v, n, scale);
    struct pack_font_glyph g = { .code = code,
                                 .w = b.x1 - b.x0,
                                 .h = b.y1 - b.y0,
                                 .x = b.x0,
                                 .y = f->ascent + b.y0,
                                 .advance = to_pixels(f, (int)get16(&f->hmtx, 4 * (size_t)width)) };
    bool good = check_size(f, code, &g);
    if (good)
        g.pix = draw_outline(f, v, n, b, scale);
    free(v);
    if (good && !f->out_of_memory && pack_font_add_glyph(to, g))
        return true;
    if (good && f->out_of_memory)
        free(g.pix);
    return good ? result_set_host_error(f->err, f->err_size, "out of memory") : false;
}

/* Checks and opens the font. */
static bool open_font(struct font *f, const struct table *file)
{
    const uint32_t kind = get32(file, 0);

    if (kind == 0x4f54544f || kind == 0x74746366) /* OTTO, ttcf */
        return err_set(f->err, f->err_size, "%s; convert it to a TrueType font (.ttf)",
                       kind == 0x74746366 ? "a collection of fonts" : "an OpenType font with PostScript outlines");
    if (kind != 0x00010000 && kind != 0x74727565) /* true */
        return err_set(f->err, f->err_size, "not a TrueType font");
    const char *wrong = file->n < 12 + 16 * (size_t)get16(file, 4) ? "table directory" : find_tables(f, file);
    if (wrong != NULL)
        return err_set(f->err, f->err_size, "%s: missing or damaged", wrong);
    if (!find_map(f))
        return err_set(f->err, f->err_size, "no Unicode character map (cmap of format 4 or 12)");
    f->info.userdata = &f->out_of_memory;
    return stbtt_InitFont(&f->info, file->data, 0) ? true : err_set(f->err, f->err_size, "not a TrueType font");
}

bool ttf_read(struct pack_font *f, const uint8_t *data, size_t n, int size, const struct pack_font_chars *wanted,
              char *err, size_t err_size)
{
    const struct table file = { data, n };
    struct font font = { .size = size, .err = err, .err_size = err_size };

    *f = (struct pack_font){ 0 };
    if (!open_font(&font, &file))
        return false;
    font.ascent = to_pixels(&font, get_signed(&font.hhea, 4));
    f->height = font.ascent - to_pixels(&font, get_signed(&font.hhea, 6));
    if (f->height < 1 || f->height > FACE_MAX_HEIGHT)
        return err_set(err, err_size, "line height %d px; expected 1 to %d", f->height, FACE_MAX_HEIGHT);
    for (uint32_t code = 0; code <= UTF8_MAX_CODE; code++) {
        const int glyph = pack_font_has(wanted, code) ? find_glyph(&font, code) : 0;
        if (glyph > 0 && !add_glyph(&font, f, code, glyph))
            return false;
    }
    return f->n > 0 ? true : err_set(err, err_size, "the font has no character that the game's text uses");
}

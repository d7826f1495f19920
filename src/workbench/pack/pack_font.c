/*
 * pack_font.c - see pack_font.h.
 */
#include "pack_font.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/result.h"
#include "../../base/cursor.h"
#include "../../rom/face.h"

/* ---- characters ---- */

void pack_font_add_text(struct pack_font_chars *s, const char *text, size_t n)
{
    const char *end = text + n;

    while (text < end)
        pack_font_add(s, utf8_next(&text, end));
}

/* Skips the comment at at->p. */
static void skip_comment(struct cursor *at)
{
    at->p += 2;
    int level = cursor_peek(at, 0) == '[' ? cursor_long_level(at) : -1;

    if (level < 0) {
        while (at->p < at->end && *at->p != '\n')
            at->p++;
        return;
    }
    while (at->p < at->end && !cursor_is_at_long_close(at, level))
        at->p++;
}

/* Adds the character of the escape sequence at at->p if it is \u{...}. */
static void add_escape(struct pack_font_chars *s, const struct cursor *at)
{
    uint32_t code = 0;

    if (cursor_peek(at, 1) != 'u' || cursor_peek(at, 2) != '{')
        return;
    for (size_t i = 3; cursor_hex_value(cursor_peek(at, i)) >= 0 && code <= UTF8_MAX_CODE; i++)
        code = code * 16 + (uint32_t)cursor_hex_value(cursor_peek(at, i));
    pack_font_add(s, code);
}

static void add_quoted(struct pack_font_chars *s, struct cursor *at)
{
    const char quote = *at->p++;

    while (at->p < at->end && *at->p != quote && *at->p != '\n') {
        if (*at->p == '\\') {
            add_escape(s, at);
            at->p += at->end - at->p > 1 ? 2 : 1;
        } else {
            pack_font_add(s, utf8_next(&at->p, at->end));
        }
    }
    at->p += at->p < at->end;
}

void pack_font_add_script(struct pack_font_chars *s, const char *text, size_t n)
{
    struct cursor at = { text, text + n, 1 };

    while (at.p < at.end) {
        if (*at.p == '-' && cursor_peek(&at, 1) == '-')
            skip_comment(&at);
        else if (*at.p == '"' || *at.p == '\'')
            add_quoted(s, &at);
        else
            pack_font_add(s, utf8_next(&at.p, at.end));
    }
}

/* ---- glyphs ---- */

bool pack_font_add_glyph(struct pack_font *f, struct pack_font_glyph g)
{
    if (!array_append(&f->list, (size_t)f->n, sizeof g)) {
        free(g.pix);
        return false;
    }
    f->list[f->n++] = g;
    return true;
}

void pack_font_free(struct pack_font *f)
{
    for (int i = 0; i < f->n; i++)
        free(f->list[i].pix);
    free(f->list);
    *f = (struct pack_font){ 0 };
}

static int by_code(const void *a, const void *b)
{
    const struct pack_font_glyph *x = a, *y = b;

    return (x->code > y->code) - (x->code < y->code);
}

bool pack_font_sort(struct pack_font *f, uint32_t *code)
{
    if (f->n > 0)
        qsort(f->list, (size_t)f->n, sizeof *f->list, by_code);
    for (int i = 1; i < f->n; i++) {
        *code = f->list[i].code;
        if (f->list[i - 1].code == *code)
            return false;
    }
    return true;
}

static bool has_ink(const struct pack_font_glyph *g)
{
    for (int i = 0; i < g->w * g->h; i++)
        if (g->pix[i] != 0)
            return true;
    return false;
}

void pack_font_darken(struct pack_font *f, int ink)
{
    for (int i = 0; i < f->n; i++)
        for (int k = 0; k < f->list[i].w * f->list[i].h; k++)
            f->list[i].pix[k] = (uint8_t)((f->list[i].pix[k] * ink + 14) / 15);
}

bool pack_font_add_shadow(struct pack_font *f)
{
    for (int i = 0; i < f->n; i++) {
        struct pack_font_glyph *g = &f->list[i];
        const int w = g->w + 1, h = g->h + 1;
        if (!has_ink(g) || w > FACE_MAX_SIDE || h > FACE_MAX_SIDE)
            continue;
        uint8_t *pix = calloc((size_t)w, (size_t)h);
        if (pix == NULL)
            return false;
        for (int k = 0; k < g->w * g->h; k++) {
            int at = k / g->w * w + k % g->w;
            if (g->pix[k] == 0)
                continue;
            pix[at] = g->pix[k];
            const int to[] = { at + 1, at + w, at + w + 1 };
            for (int n = 0; n < 3; n++)
                if (pix[to[n]] == 0)
                    pix[to[n]] = 1;
        }
        free(g->pix);
        g->pix = pix;
        g->w = w;
        g->h = h;
    }
    return true;
}

size_t pack_font_make(const struct pack_font *f, uint8_t **out)
{
    size_t at = FACE_HEADER_SIZE + (size_t)f->n * FACE_GLYPH_SIZE, size = at;

    for (int i = 0; i < f->n; i++)
        size += (size_t)((f->list[i].w + 7) / 8 * 8) * (size_t)f->list[i].h;
    *out = calloc(1, size);
    if (*out == NULL)
        return 0;
    bytes_put16(*out, (uint16_t)f->height);
    bytes_put32(*out + 4, (uint32_t)f->n);
    for (int i = 0; i < f->n; i++) {
        const struct pack_font_glyph *g = &f->list[i];
        const int pitch = (g->w + 7) / 8 * 8;
        uint8_t *p = *out + FACE_HEADER_SIZE + (size_t)i * FACE_GLYPH_SIZE;
        bytes_put32(p, g->code);
        bytes_put32(p + 4, (uint32_t)at);
        p[8] = (uint8_t)g->w;
        p[9] = (uint8_t)g->h;
        p[10] = (uint8_t)g->x;
        p[11] = (uint8_t)g->y;
        p[12] = (uint8_t)g->advance;
        for (int y = 0; y < g->h; y++, at += (size_t)pitch)
            memcpy(*out + at, g->pix + y * g->w, (size_t)g->w);
    }
    return size;
}

/* ---- a picture as a grid of cells ---- */

/* Removes the empty columns at both sides of a glyph and sets its advance. An empty cell becomes a space, half a cell
 * wide. */
static void trim_columns(struct pack_font_glyph *g, bool fixed)
{
    int first = g->w, last = -1;

    for (int i = 0; i < g->w * g->h; i++)
        if (g->pix[i] != 0) {
            first = i % g->w < first ? i % g->w : first;
            last = i % g->w > last ? i % g->w : last;
        }
    g->advance = fixed ? g->w : last < 0 ? (g->w + 1) / 2 : last - first + 2;
    if (fixed || last < 0)
        return;
    const int w = last - first + 1;
    for (int y = 0; y < g->h; y++)
        memmove(g->pix + y * w, g->pix + y * g->w + first, (size_t)w);
    g->w = w;
}

static bool cut_cell(struct pack_font_glyph *g, const struct art_picture *p, int x0, int y0, const uint8_t *rgb,
                     bool nearest, char *err, size_t err_size)
{
    g->pix = calloc((size_t)g->w, (size_t)g->h);
    if (g->pix == NULL)
        return result_set_host_error(err, err_size, "out of memory");
    for (int i = 0; i < g->w * g->h; i++) {
        int shade = art_shade(p, x0 + i % g->w, y0 + i / g->w, 0, rgb, nearest, err, err_size);
        if (shade < 0) {
            free(g->pix);
            return false;
        }
        g->pix[i] = (uint8_t)shade;
    }
    return true;
}

bool pack_font_cut(struct pack_font *f, const struct art_picture *picture, const struct art_font *font,
                   const struct pack_font_chars *wanted, const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, char *err,
                   size_t err_size)
{
    const int across = picture->w / font->w, cells = across * (picture->h / font->h);
    const char *chars = font->chars, *end = chars + strlen(chars);
    const int n = (int)utf8_count(chars, strlen(chars), SIZE_MAX, NULL);

    f->height = font->h;
    if (n > cells)
        return err_set(err, err_size, "%dx%d pixels hold %d cells of %dx%d, but `chars` has %d characters", picture->w,
                       picture->h, cells, (int)font->w, (int)font->h, n);
    for (int i = 0; chars < end; i++) {
        struct pack_font_glyph g = { .code = utf8_next(&chars, end), .w = font->w, .h = font->h };
        if (!pack_font_has(wanted, g.code))
            continue;
        if (!cut_cell(&g, picture, i % across * font->w, i / across * font->h, rgb, nearest, err, err_size))
            return false;
        trim_columns(&g, font->fixed);
        if (!pack_font_add_glyph(f, g))
            return result_set_host_error(err, err_size, "out of memory");
    }
    return true;
}

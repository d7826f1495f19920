/*
 * gif.c - makes animated GIFs (gif.h). The GIF89a specification describes the format. The block that repeats the
 * animation is Netscape's extension, which every reader supports.
 */
#include "gif.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "lzw.h"

enum {
    COLOURS = 256,
    MAX_DELAY = 65534,     /* hundredths of a second, a multiple of the shortest picture */
    KEEP_PICTURE = 1 << 2, /* control block: the next picture is drawn over this one */
    HAS_TRANSPARENT = 1,   /* control block */
    HAS_PALETTE = 0x80,    /* header and descriptor; the low three bits are PALETTE_BITS */
    PALETTE_BITS = 8 - 1,  /* the palette has 2^(n + 1) colours */
    CHANNEL_BITS = 8 - 1   /* header: bits per colour channel, minus one */
};

bool gif_open(struct gif *g, int w, int h)
{
    const size_t n = (size_t)w * (size_t)h;

    *g = (struct gif){ .w = w, .h = h };
    if (w < 1 || h < 1 || w > GIF_MAX_SIDE || h > GIF_MAX_SIDE || n > BYTE_BUFFER_MAX / 4)
        return false;
    g->canvas = malloc(n * sizeof *g->canvas);
    g->rect = malloc(n);
    return g->canvas && g->rect;
}

void gif_close(struct gif *g)
{
    byte_buffer_close(&g->out);
    byte_buffer_close(&g->opaque);
    byte_buffer_close(&g->transparent);
    free(g->canvas);
    free(g->rect);
    *g = (struct gif){ 0 };
}

static void put_palette(struct gif *g, const uint32_t rgb[256])
{
    uint8_t *p = byte_buffer_take(&g->out, 3 * COLOURS);

    for (int i = 0; p && i < COLOURS; i++, p += 3) {
        p[0] = (uint8_t)(rgb[i] >> 16);
        p[1] = (uint8_t)(rgb[i] >> 8);
        p[2] = (uint8_t)rgb[i];
    }
}

static void put_head(struct gif *g, const uint32_t rgb[256])
{
    static const uint8_t loop_block[] = "!\377\013NETSCAPE2.0\003\001\0\0"; /* the string's NUL ends the block */
    uint8_t header[13] = "GIF89a";

    bytes_put16(header + 6, (uint16_t)g->w);
    bytes_put16(header + 8, (uint16_t)g->h);
    header[10] = HAS_PALETTE | CHANNEL_BITS << 4 | PALETTE_BITS;
    byte_buffer_put(&g->out, header, sizeof header);
    memcpy(g->palette, rgb, sizeof g->palette);
    put_palette(g, rgb);
    byte_buffer_put(&g->out, loop_block, sizeof loop_block);
}

/* Finds the indices that occur in the rectangle. */
static void find_used(const struct gif *g, const uint8_t *pix, const struct change *c, bool is[COLOURS])
{
    memset(is, 0, COLOURS);
    for (int y = c->y; y < c->y + c->h; y++)
        for (int x = c->x; x < c->x + c->w; x++)
            is[pix[(size_t)y * (size_t)g->w + (size_t)x]] = true;
}

/* Compresses the rectangle. free_index: replaces the index of unchanged pixels; -1: none. */
static void pack(struct gif *g, struct byte_buffer *to, const uint8_t *pix, const uint32_t rgb[256],
                 const struct change *c, int free_index)
{
    uint8_t *rect = g->rect;

    for (int y = c->y; y < c->y + c->h; y++)
        for (int x = c->x; x < c->x + c->w; x++) {
            const size_t at = (size_t)y * (size_t)g->w + (size_t)x;
            *rect++ = free_index >= 0 && g->canvas[at] == rgb[pix[at]] ? (uint8_t)free_index : pix[at];
        }
    to->n = 0;
    lzw_append(to, g->rect, (size_t)(rect - g->rect));
}

static void put_control(struct gif *g, int transparent)
{
    uint8_t control[8] = { '!', 0xf9, 4, KEEP_PICTURE };

    if (transparent >= 0) {
        control[3] |= HAS_TRANSPARENT;
        control[6] = (uint8_t)transparent;
    }
    g->delay_at = g->out.n + 4;
    byte_buffer_put(&g->out, control, sizeof control);
}

static void put_descriptor(struct gif *g, const struct change *c, bool has_palette)
{
    uint8_t d[10] = { ',' };

    bytes_put16(d + 1, (uint16_t)c->x);
    bytes_put16(d + 3, (uint16_t)c->y);
    bytes_put16(d + 5, (uint16_t)c->w);
    bytes_put16(d + 7, (uint16_t)c->h);
    d[9] = has_palette ? HAS_PALETTE | PALETTE_BITS : 0;
    byte_buffer_put(&g->out, d, sizeof d);
}

static void put_picture(struct gif *g, const uint8_t *pix, const uint32_t rgb[256], const struct change *c)
{
    bool is[COLOURS], needs_palette = false;
    int spare = -1;

    find_used(g, pix, c, is);
    for (int i = 0; i < COLOURS; i++) {
        needs_palette = needs_palette || (is[i] && rgb[i] != g->palette[i]);
        spare = spare < 0 && !is[i] && g->delay_at ? i : spare;
    }
    pack(g, &g->opaque, pix, rgb, c, -1);
    if (spare >= 0)
        pack(g, &g->transparent, pix, rgb, c, spare);
    const bool transparent = spare >= 0 && g->transparent.n < g->opaque.n;
    const struct byte_buffer *smaller = transparent ? &g->transparent : &g->opaque;
    g->out.failed = g->out.failed || g->opaque.failed || g->transparent.failed;
    put_control(g, transparent ? spare : -1);
    put_descriptor(g, c, needs_palette);
    if (needs_palette)
        put_palette(g, rgb);
    byte_buffer_put(&g->out, smaller->bytes, smaller->n);
    change_copy(g->canvas, pix, rgb, g->w, c);
}

/* Extends the last picture to the time `at`. If that is longer than MAX_DELAY, repeats one pixel of the picture. */
static void extend_to(struct gif *g, const uint8_t *pix, const uint32_t rgb[256], uint32_t at)
{
    const struct change pixel = { 0, 0, 1, 1 };

    for (; !g->out.failed && at - g->start > MAX_DELAY; g->start += MAX_DELAY) {
        bytes_put16(g->out.bytes + g->delay_at, MAX_DELAY);
        put_picture(g, pix, rgb, &pixel);
    }
    if (!g->out.failed)
        bytes_put16(g->out.bytes + g->delay_at, (uint16_t)(at - g->start));
    g->start = at;
}

/* The same, with the picture that is shown: extend_to needs only its first pixel. */
static void extend_last(struct gif *g, uint32_t at)
{
    const uint8_t pix = 0;
    uint32_t rgb[COLOURS];

    memcpy(rgb, g->palette, sizeof rgb);
    rgb[0] = g->canvas[0];
    extend_to(g, &pix, rgb, at);
}

void gif_add(struct gif *g, const uint8_t *pix, const uint32_t rgb[256], uint32_t at)
{
    struct change c = { 0, 0, g->w, g->h };

    if (g->out.failed)
        return;
    if (g->delay_at) {
        c = change_find(g->canvas, pix, rgb, g->w, g->h);
        if (c.w)
            extend_last(g, at);
    } else {
        put_head(g, rgb);
    }
    if (c.w)
        put_picture(g, pix, rgb, &c);
}

bool gif_end(struct gif *g, uint32_t at)
{
    if (!g->delay_at || g->out.failed)
        return false;
    extend_last(g, at);
    byte_buffer_byte(&g->out, ';');
    return !g->out.failed;
}

/*
 * gif.c - see gif.h. What a byte means is in the GIF89a specification; the block that repeats the animation is
 * Netscape's, which every reader knows.
 */
#include "gif.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "lzw.h"

enum {
    COLOURS = 256,
    LONGEST = 65534,      /* hundredths of a delay: the most it holds, in whole pictures */
    STAYS = 1 << 2,       /* a picture is left as it is when the next one comes */
    HAS_TRANSPARENT = 1,  /* in a control block */
    HAS_PALETTE = 0x80,   /* and 2 to the power of the low three bits, and one */
    PALETTE_BITS = 8 - 1, /* those */
    CHANNEL_BITS = 8 - 1  /* what the colours were chosen from */
};

bool gif_open(struct gif *g, int w, int h)
{
    const size_t n = (size_t)w * (size_t)h;

    *g = (struct gif){ .w = w, .h = h };
    if (w < 1 || h < 1 || w > GIF_MAX_SIDE || h > GIF_MAX_SIDE || n > BYTE_BUFFER_MAX / 4)
        return false;
    g->shown = malloc(n * sizeof *g->shown);
    g->part = malloc(n);
    return g->shown && g->part;
}

void gif_close(struct gif *g)
{
    byte_buffer_close(&g->out);
    byte_buffer_close(&g->solid);
    byte_buffer_close(&g->see);
    free(g->shown);
    free(g->part);
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
    static const uint8_t again[] = "!\377\013NETSCAPE2.0\003\001\0\0"; /* and its NUL ends the block */
    uint8_t head[13] = "GIF89a";

    bytes_put16(head + 6, (uint16_t)g->w);
    bytes_put16(head + 8, (uint16_t)g->h);
    head[10] = HAS_PALETTE | CHANNEL_BITS << 4 | PALETTE_BITS;
    byte_buffer_put(&g->out, head, sizeof head);
    memcpy(g->palette, rgb, sizeof g->palette);
    put_palette(g, rgb);
    byte_buffer_put(&g->out, again, sizeof again);
}

/* Indices that the rectangle has. */
static void used(const struct gif *g, const uint8_t *pix, const struct change *c, bool is[COLOURS])
{
    memset(is, 0, COLOURS);
    for (int y = c->y; y < c->y + c->h; y++)
        for (int x = c->x; x < c->x + c->w; x++)
            is[pix[(size_t)y * (size_t)g->w + (size_t)x]] = true;
}

/* The rectangle packed; free: the index for what is shown already, -1: none. */
static void pack(struct gif *g, struct byte_buffer *to, const uint8_t *pix, const uint32_t rgb[256],
                 const struct change *c, int free_index)
{
    uint8_t *part = g->part;

    for (int y = c->y; y < c->y + c->h; y++)
        for (int x = c->x; x < c->x + c->w; x++) {
            const size_t at = (size_t)y * (size_t)g->w + (size_t)x;
            *part++ = free_index >= 0 && g->shown[at] == rgb[pix[at]] ? (uint8_t)free_index : pix[at];
        }
    to->n = 0;
    lzw_put(to, g->part, (size_t)(part - g->part));
}

static void put_control(struct gif *g, int transparent)
{
    uint8_t control[8] = { '!', 0xf9, 4, STAYS };

    if (transparent >= 0) {
        control[3] |= HAS_TRANSPARENT;
        control[6] = (uint8_t)transparent;
    }
    g->control = g->out.n + 4;
    byte_buffer_put(&g->out, control, sizeof control);
}

static void put_descriptor(struct gif *g, const struct change *c, bool own_palette)
{
    uint8_t d[10] = { ',' };

    bytes_put16(d + 1, (uint16_t)c->x);
    bytes_put16(d + 3, (uint16_t)c->y);
    bytes_put16(d + 5, (uint16_t)c->w);
    bytes_put16(d + 7, (uint16_t)c->h);
    d[9] = own_palette ? HAS_PALETTE | PALETTE_BITS : 0;
    byte_buffer_put(&g->out, d, sizeof d);
}

static void put_picture(struct gif *g, const uint8_t *pix, const uint32_t rgb[256], const struct change *c)
{
    bool is[COLOURS], own = false;
    int spare = -1;

    used(g, pix, c, is);
    for (int i = 0; i < COLOURS; i++) {
        own = own || (is[i] && rgb[i] != g->palette[i]);
        spare = spare < 0 && !is[i] && g->control ? i : spare;
    }
    pack(g, &g->solid, pix, rgb, c, -1);
    if (spare >= 0)
        pack(g, &g->see, pix, rgb, c, spare);
    const bool see = spare >= 0 && g->see.n < g->solid.n;
    const struct byte_buffer *smaller = see ? &g->see : &g->solid;
    g->out.failed = g->out.failed || g->solid.failed || g->see.failed;
    put_control(g, see ? spare : -1);
    put_descriptor(g, c, own);
    if (own)
        put_palette(g, rgb);
    byte_buffer_put(&g->out, smaller->bytes, smaller->n);
    change_take(g->shown, pix, rgb, g->w, c);
}

/* The last picture lasts until then. What lasts longer than a delay can say goes on as a pixel of itself. */
static void last_until(struct gif *g, const uint8_t *pix, const uint32_t rgb[256], uint32_t at)
{
    const struct change pixel = { 0, 0, 1, 1 };

    for (; !g->out.failed && at - g->begun > LONGEST; g->begun += LONGEST) {
        bytes_put16(g->out.bytes + g->control, LONGEST);
        put_picture(g, pix, rgb, &pixel);
    }
    if (!g->out.failed)
        bytes_put16(g->out.bytes + g->control, (uint16_t)(at - g->begun));
    g->begun = at;
}

/* The pixel at 0, 0 as it is shown: all that last_until asks for. */
static void last_as_shown(struct gif *g, uint32_t at)
{
    const uint8_t pix = 0;
    uint32_t rgb[COLOURS];

    memcpy(rgb, g->palette, sizeof rgb);
    rgb[0] = g->shown[0];
    last_until(g, &pix, rgb, at);
}

void gif_add(struct gif *g, const uint8_t *pix, const uint32_t rgb[256], uint32_t at)
{
    struct change c = { 0, 0, g->w, g->h };

    if (g->out.failed)
        return;
    if (g->control) {
        c = change_find(g->shown, pix, rgb, g->w, g->h);
        if (c.w)
            last_as_shown(g, at);
    } else {
        put_head(g, rgb);
    }
    if (c.w)
        put_picture(g, pix, rgb, &c);
}

bool gif_end(struct gif *g, uint32_t at)
{
    if (!g->control || g->out.failed)
        return false;
    last_as_shown(g, at);
    byte_buffer_byte(&g->out, ';');
    return !g->out.failed;
}

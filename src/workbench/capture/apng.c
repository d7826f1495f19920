/*
 * apng.c - see apng.h. The chunks beyond PNG's own are acTL (how many pictures), fcTL (where and how long one is) and
 * fdAT (a later one's pixels). Numbers of pictures, delays and colours are known late, so their chunks are written
 * again over what stood there.
 */
#include "apng.h"

#include <stdlib.h>
#include <string.h>
#include "../../player/picture/png.h"

enum {
    SIGNATURE = 8,
    AROUND = 12, /* bytes of a chunk beside its data */
    HEAD = 13,
    AT_ACTL = SIGNATURE + AROUND + HEAD,
    ACTL = 8,
    AT_PLTE = AT_ACTL + AROUND + ACTL,
    PLTE = 768,
    FCTL = 26,
    LONGEST = 65535 /* sixtieths that a delay holds */
};

bool apng_open(struct apng *a, int w, int h, bool full)
{
    const size_t n = (size_t)w * (size_t)h;

    *a = (struct apng){ .w = w, .h = h, .full = full };
    if (w < 1 || h < 1 || w > PNG_MAX_SIDE || h > PNG_MAX_SIDE || n > REEL_MOST / 8)
        return false;
    a->shown = malloc(n * sizeof *a->shown);
    a->part = malloc(n * 3 + (size_t)h);
    return a->shown && a->part;
}

void apng_close(struct apng *a)
{
    byte_buffer_close(&a->out);
    free(a->shown);
    free(a->part);
    *a = (struct apng){ 0 };
}

static void put_chunk(struct apng *a, const char type[4], const uint8_t *data, uint32_t n)
{
    uint8_t *p = byte_buffer_take(&a->out, n + AROUND);

    if (p)
        png_chunk(p, type, data, n);
}

static void actl(const struct apng *a, uint8_t data[ACTL])
{
    png_be32(data, a->pictures);
    png_be32(data + 4, 0); /* for ever */
}

static void palette(const struct apng *a, uint8_t data[PLTE])
{
    memset(data, 0, PLTE);
    for (int i = 0; i < a->n_colours; i++) {
        data[3 * i] = (uint8_t)(a->colours[i] >> 16);
        data[3 * i + 1] = (uint8_t)(a->colours[i] >> 8);
        data[3 * i + 2] = (uint8_t)a->colours[i];
    }
}

static void put_head(struct apng *a)
{
    static const uint8_t signature[SIGNATURE] = { 137, 'P', 'N', 'G', 13, 10, 26, 10 };
    uint8_t head[HEAD] = { 0 }, data[PLTE];

    png_be32(head, (uint32_t)a->w);
    png_be32(head + 4, (uint32_t)a->h);
    head[8] = 8;
    head[9] = a->full ? 2 : 3;
    byte_buffer_put(&a->out, signature, sizeof signature);
    put_chunk(a, "IHDR", head, sizeof head);
    actl(a, data);
    put_chunk(a, "acTL", data, ACTL);
    palette(a, data);
    if (!a->full)
        put_chunk(a, "PLTE", data, PLTE);
}

/* The index of a colour, which is given one if it has none; -1: there are no more. */
static int index_of(struct apng *a, uint32_t colour)
{
    int i = 0;

    while (i < a->n_colours && a->colours[i] != colour)
        i++;
    if (i == 256)
        return -1;
    a->colours[i] = colour;
    a->n_colours += i == a->n_colours;
    return i;
}

/* The rectangle's rows in a->part, each after a filter byte; 0: too many colours. */
static size_t rows(struct apng *a, const uint8_t *pix, const uint32_t rgb[256], const struct change *c)
{
    int index[256];
    uint8_t *to = a->part;

    for (int i = 0; i < 256; i++)
        index[i] = -1;
    for (int y = c->y; y < c->y + c->h; y++) {
        const uint8_t *from = pix + (size_t)y * (size_t)a->w + c->x;
        *to++ = 0;
        for (int x = 0; x < c->w; x++) {
            if (a->full) {
                *to++ = (uint8_t)(rgb[from[x]] >> 16);
                *to++ = (uint8_t)(rgb[from[x]] >> 8);
                *to++ = (uint8_t)rgb[from[x]];
                continue;
            }
            index[from[x]] = index[from[x]] < 0 ? index_of(a, rgb[from[x]]) : index[from[x]];
            if (index[from[x]] < 0)
                return 0;
            *to++ = (uint8_t)index[from[x]];
        }
    }
    return (size_t)(to - a->part);
}

static void put_control(struct apng *a, const struct change *c)
{
    uint8_t data[FCTL] = { 0 };

    png_be32(data, a->chunks++);
    png_be32(data + 4, (uint32_t)c->w);
    png_be32(data + 8, (uint32_t)c->h);
    png_be32(data + 12, (uint32_t)c->x);
    png_be32(data + 16, (uint32_t)c->y);
    data[23] = APNG_SECOND; /* what the delay, at 20, is counted in */
    a->control = a->out.n;
    put_chunk(a, "fcTL", data, FCTL);
}

/* The first picture's pixels are the PNG's own. */
static void put_pixels(struct apng *a, size_t n)
{
    const size_t number = a->pictures ? 4 : 0;
    uint8_t *packed, *data;
    size_t size;

    if (!png_deflate(a->part, n, &packed, &size)) {
        a->out.failed = true;
        return;
    }
    data = malloc(size + number);
    a->out.failed = a->out.failed || !data;
    if (data) {
        if (number)
            png_be32(data, a->chunks++);
        memcpy(data + number, packed, size);
        put_chunk(a, number ? "fdAT" : "IDAT", data, (uint32_t)(size + number));
    }
    free(packed);
    free(data);
}

static void put_picture(struct apng *a, const uint8_t *pix, const uint32_t rgb[256], const struct change *c)
{
    const size_t n = rows(a, pix, rgb, c);

    a->too_many = n == 0;
    if (a->too_many)
        return;
    put_control(a, c);
    put_pixels(a, n);
    a->pictures++;
    change_take(a->shown, pix, rgb, a->w, c);
}

static void put_delay(struct apng *a, uint32_t sixtieths)
{
    uint8_t data[FCTL], *chunk = a->out.bytes + a->control;

    if (a->out.failed)
        return;
    memcpy(data, chunk + 8, FCTL);
    data[20] = (uint8_t)(sixtieths >> 8);
    data[21] = (uint8_t)sixtieths;
    png_chunk(chunk, "fcTL", data, FCTL);
}

/* What lasts longer than a delay can say goes on as a pixel of itself. */
static void last_until(struct apng *a, uint32_t at)
{
    const struct change pixel = { 0, 0, 1, 1 };
    const uint8_t pix = 0;
    uint32_t rgb[256] = { a->shown[0] };

    for (; !a->out.failed && at - a->begun > LONGEST; a->begun += LONGEST) {
        put_delay(a, LONGEST);
        put_picture(a, &pix, rgb, &pixel);
    }
    put_delay(a, at - a->begun);
    a->begun = at;
}

void apng_add(struct apng *a, const uint8_t *pix, const uint32_t rgb[256], uint32_t at)
{
    struct change c = { 0, 0, a->w, a->h };

    if (a->out.failed || a->too_many)
        return;
    if (a->pictures)
        c = change_find(a->shown, pix, rgb, a->w, a->h);
    else
        put_head(a);
    if (!c.w)
        return;
    if (a->pictures)
        last_until(a, at);
    put_picture(a, pix, rgb, &c);
}

bool apng_end(struct apng *a, uint32_t at)
{
    uint8_t data[PLTE];

    if (!a->pictures || a->too_many || a->out.failed)
        return false;
    last_until(a, at);
    put_chunk(a, "IEND", NULL, 0);
    if (a->out.failed)
        return false;
    actl(a, data);
    png_chunk(a->out.bytes + AT_ACTL, "acTL", data, ACTL);
    palette(a, data);
    if (!a->full)
        png_chunk(a->out.bytes + AT_PLTE, "PLTE", data, PLTE);
    return true;
}

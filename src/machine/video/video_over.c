/*
 * video_over.c - what stands between the picture and its text: the dim, plates; and the shade that a view asks for
 * between backgrounds and what matters.
 *
 * A shade is a table of the ROM: what is drawn and blended over it afterwards finds colours of the palette as ever. The
 * dim is exact, but comes when all of the picture is drawn. Pixels are indices, and all share 256 colours, so a dim
 * cannot darken the colours of the picture alone. But few of the 256 are drawn in one frame: a colour that text or a
 * portrait has too moves to an entry that nobody draws with. Then each entry is either the picture's, and dark, or
 * theirs. Only where all entries are taken is a colour shown by the one that comes nearest.
 */
#include <string.h>
#include "../../../fb/fb.h"
#include "video.h"

static void find_drawn(const struct fb *fb, bool drawn[COLOURS])
{
    memset(drawn, 0, COLOURS * sizeof *drawn);
    for (int y = 0; y < fb->h; y++)
        for (int x = 0; x < fb->w; x++)
            drawn[fb->pix[y * fb->pitch + x]] = true;
}

static int squared(uint32_t a, uint32_t b, int shift)
{
    int d = (int)(a >> shift & 255) - (int)(b >> shift & 255);

    return d * d;
}

/* The entry that comes nearest to a colour; of several the first. */
static uint8_t nearest(const uint32_t rgb[COLOURS], uint32_t colour)
{
    int best = 0, off = 3 * 256 * 256;

    for (int i = 0; i < COLOURS; i++) {
        int d = squared(rgb[i], colour, 16) + squared(rgb[i], colour, 8) + squared(rgb[i], colour, 0);
        best = d < off ? i : best;
        off = d < off ? d : off;
    }
    return (uint8_t)best;
}

/* The next entry from i on that nobody draws with, or COLOURS. */
static int next_free(const bool drawn[COLOURS], const bool over[COLOURS], int i)
{
    while (i < COLOURS && (drawn[i] || over[i]))
        i++;
    return i;
}

/* rgb becomes the colours of the dimmed picture; `to` tells where each that is drawn went. */
static void share_out(uint32_t rgb[COLOURS], const bool drawn[COLOURS], const bool over[COLOURS], fx share,
                      uint8_t to[COLOURS])
{
    bool lost[COLOURS] = { false };
    uint32_t dark[COLOURS];
    int spare = next_free(drawn, over, 0);

    for (int i = 0; i < COLOURS; i++)
        dark[i] = pal_mix(rgb[i], 0, share, FX_ONE);
    for (int i = 0; i < COLOURS; i++) {
        to[i] = (uint8_t)i;
        if (!over[i] && drawn[i])
            rgb[i] = dark[i];
        if (!over[i] || !drawn[i])
            continue;
        lost[i] = spare == COLOURS;
        if (lost[i])
            continue;
        to[i] = (uint8_t)spare;
        rgb[spare] = dark[i];
        spare = next_free(drawn, over, spare + 1);
    }
    for (int i = 0; i < COLOURS; i++)
        if (lost[i])
            to[i] = nearest(rgb, dark[i]);
}

void video_dim(const struct draw_target *c, uint32_t rgb[COLOURS], const bool over[COLOURS], fx share)
{
    struct fb *fb = c->fb;
    bool drawn[COLOURS];
    uint8_t to[COLOURS];

    find_drawn(fb, drawn);
    share_out(rgb, drawn, over, share, to);
    for (int y = 0; y < fb->h; y++)
        for (int x = 0; x < fb->w; x++) {
            uint8_t *p = &fb->pix[y * fb->pitch + x];
            *p = to[*p];
        }
}

void video_shade(const struct draw_target *c)
{
    const struct fb *fb = c->fb;

    for (int y = fb->y0; y < fb->y1; y++) {
        uint8_t *row = fb->pix + (ptrdiff_t)y * fb->pitch;
        for (int x = fb->x0; x < fb->x1; x++)
            row[x] = c->shade[row[x]];
    }
}

/* A rectangle whose corners are rounded off: its first and last rows begin so many pixels further in. */
static void rounded(struct fb *fb, int x, int y, int w, int h, const int in[3], uint8_t colour)
{
    for (int k = 0; k < 3; k++) {
        fb_rect(fb, x + in[k], y + k, w - 2 * in[k], 1, colour);
        fb_rect(fb, x + in[k], y + h - 1 - k, w - 2 * in[k], 1, colour);
    }
    fb_rect(fb, x, y + 3, w, h - 6, colour);
}

void video_plate(struct draw_target *c, int x, int y, int w, int h, uint8_t bank)
{
    static const int edge[3] = { 3, 1, 1 }, rim[3] = { 2, 1, 0 }, inside[3] = { 1, 0, 0 };
    const uint8_t dark = (uint8_t)(bank * 16 + 1), light = (uint8_t)(bank * 16 + 10);

    rounded(c->fb, x, y, w, h, edge, dark);
    rounded(c->fb, x + 1, y + 1, w - 2, h - 2, rim, light);
    rounded(c->fb, x + 2, y + 2, w - 4, h - 4, inside, dark);
    c->drawn++;
}

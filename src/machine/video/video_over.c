/*
 * video_over.c - draws what is between the picture and its text (the dim and plates), and the shade with which a view
 * dims backgrounds.
 *
 * A shade is a lookup table from palette entries to darker entries of the same palette, so pictures drawn and blended
 * over it afterwards still find the colours they expect. A dim is exact, but is applied when the whole picture has been
 * drawn. Pixels are indices into 256 shared colours, so darkening the picture's colours would darken text as well. But
 * a frame uses only some of the 256 entries: a colour that the picture shares with text or a portrait is moved to an
 * unused entry, so that each entry belongs either to the dark picture or to what is drawn over it. If no entry is free,
 * the dark colour is replaced by the nearest one available.
 */
#include <string.h>
#include "../../../fb/fb.h"
#include "video.h"

void video_find_drawn_entries(const struct fb *fb, bool drawn[COLOURS])
{
    memset(drawn, 0, COLOURS * sizeof *drawn);
    for (int y = 0; y < fb->h; y++)
        for (int x = 0; x < fb->w; x++)
            drawn[fb->pix[y * fb->pitch + x]] = true;
}

static int squared_difference(uint32_t a, uint32_t b, int shift)
{
    int d = (int)(a >> shift & 255) - (int)(b >> shift & 255);

    return d * d;
}

/* Returns the entry nearest to a colour; of several equally near ones, the first. */
static uint8_t find_nearest_entry(const uint32_t rgb[COLOURS], uint32_t colour)
{
    int best = 0, best_distance = 3 * 256 * 256;

    for (int i = 0; i < COLOURS; i++) {
        int d = squared_difference(rgb[i], colour, 16) + squared_difference(rgb[i], colour, 8) +
                squared_difference(rgb[i], colour, 0);
        best = d < best_distance ? i : best;
        best_distance = d < best_distance ? d : best_distance;
    }
    return (uint8_t)best;
}

/* Returns the first entry from i that is neither in the picture nor used by what is drawn over it, or COLOURS. */
static int find_free_entry(const bool drawn[COLOURS], const bool reserved[COLOURS], int i)
{
    while (i < COLOURS && (drawn[i] || reserved[i]))
        i++;
    return i;
}

/* Changes rgb to the colours of the dimmed picture. Sets replacement[i] to the entry that replaces entry i in the
 * picture. */
static void assign_entries(uint32_t rgb[COLOURS], const bool drawn[COLOURS], const bool reserved[COLOURS], fx share,
                           uint8_t replacement[COLOURS])
{
    bool lost[COLOURS] = { false };
    uint32_t dark[COLOURS];
    int spare = find_free_entry(drawn, reserved, 0);

    for (int i = 0; i < COLOURS; i++)
        dark[i] = pal_mix(rgb[i], 0, share, FX_ONE);
    for (int i = 0; i < COLOURS; i++) {
        replacement[i] = (uint8_t)i;
        if (!reserved[i] && drawn[i])
            rgb[i] = dark[i];
        if (!reserved[i] || !drawn[i])
            continue;
        lost[i] = spare == COLOURS;
        if (lost[i])
            continue;
        replacement[i] = (uint8_t)spare;
        rgb[spare] = dark[i];
        spare = find_free_entry(drawn, reserved, spare + 1);
    }
    for (int i = 0; i < COLOURS; i++)
        if (lost[i])
            replacement[i] = find_nearest_entry(rgb, dark[i]);
}

void video_dim(const struct draw_target *c, uint32_t rgb[COLOURS], const bool reserved[COLOURS], fx share)
{
    struct fb *fb = c->fb;
    bool drawn[COLOURS];
    uint8_t replacement[COLOURS];

    video_find_drawn_entries(fb, drawn);
    assign_entries(rgb, drawn, reserved, share, replacement);
    for (int y = 0; y < fb->h; y++)
        for (int x = 0; x < fb->w; x++) {
            uint8_t *p = &fb->pix[y * fb->pitch + x];
            *p = replacement[*p];
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

void video_draw_plate(struct draw_target *c, int x, int y, int w, int h, uint8_t bank)
{
    fb_plate(c->fb, x, y, w, h, (uint8_t)(bank * 16 + 1), (uint8_t)(bank * 16 + 10));
    c->drawn_count++;
}

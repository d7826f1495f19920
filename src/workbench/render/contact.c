/*
 * contact.c - see contact.h.
 */
#include "contact.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../player/overlay/letters.h"
#include "../../player/picture/png.h"

enum {
    GAP = 4,     /* px around each picture with its label */
    GREY = 0x28, /* brightness of the background */
    TEXT = 0xd0, /* brightness of the digits */
    LARGE = 240, /* px; wider pictures have digits of double size */
    CAPITAL = 7, /* rows of a digit */
    UNDER = 2,   /* px between digits and picture */
    MAX_PIXELS = 1 << 26
};

bool contact_open(struct contact *s, int64_t n, int w, int h)
{
    const int scale = w < LARGE ? 1 : 2, label = CAPITAL * scale + UNDER;
    const int64_t cell_w = w + GAP, cell_h = h + label + GAP;
    int64_t columns = 1;

    while (columns * columns * cell_w < n * cell_h)
        columns++;
    const int64_t rows = (n + columns - 1) / columns;
    const int64_t sheet_w = columns * cell_w + GAP, sheet_h = rows * cell_h + GAP;
    if (sheet_w > PNG_MAX_SIDE || sheet_h > PNG_MAX_SIDE || sheet_w * sheet_h > MAX_PIXELS)
        return false;
    *s = (struct contact){
        .w = (int)sheet_w, .h = (int)sheet_h, .columns = (int)columns, .label = label, .scale = scale
    };
    s->rgb = malloc((size_t)(sheet_w * sheet_h * 3));
    if (s->rgb)
        memset(s->rgb, GREY, (size_t)(sheet_w * sheet_h * 3));
    return s->rgb != NULL;
}

static uint8_t *pixel_at(const struct contact *s, int x, int y)
{
    return s->rgb + ((size_t)y * (size_t)s->w + (size_t)x) * 3;
}

/* Draws a letter with the top left corner of a capital at (x, y); returns the x after it. */
static int add_letter(const struct contact *s, int x, int y, char c)
{
    struct letter l;

    letter_load(&l, (unsigned char)c);
    for (int row = 0; row < CAPITAL * s->scale; row++)
        for (int i = 0; i < l.w * s->scale; i++)
            if (l.rows[LETTER_ACCENT_HEIGHT + row / s->scale] >> (i / s->scale) & 1)
                memset(pixel_at(s, x + i, y + row), TEXT, 3);
    return x + (l.w + 1) * s->scale;
}

/* Draws a frame number. A picture is at least 64 px wide, which is enough for any number. */
static void add_label(const struct contact *s, int x, int y, uint32_t frame)
{
    char text[16];

    snprintf(text, sizeof text, "%u", (unsigned)frame);
    for (const char *c = text; *c; c++)
        x = add_letter(s, x, y, *c);
}

void contact_add(struct contact *s, const struct fb *fb, const uint32_t rgb[256], uint32_t frame)
{
    const int x0 = GAP + s->count % s->columns * (fb->w + GAP);
    const int y0 = GAP + s->count / s->columns * (fb->h + s->label + GAP);

    s->count++;
    add_label(s, x0, y0, frame);
    for (int y = 0; y < fb->h; y++) {
        uint8_t *to = pixel_at(s, x0, y0 + s->label + y);
        const uint8_t *from = fb->pix + (ptrdiff_t)y * fb->pitch;
        for (int x = 0; x < fb->w; x++, to += 3) {
            to[0] = (uint8_t)(rgb[from[x]] >> 16);
            to[1] = (uint8_t)(rgb[from[x]] >> 8);
            to[2] = (uint8_t)rgb[from[x]];
        }
    }
}

void contact_close(struct contact *s)
{
    free(s->rgb);
    s->rgb = NULL;
}

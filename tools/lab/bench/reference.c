/*
 * reference.c - see reference.h: what both references share, and the painter.
 */
#include "reference.h"
#include <string.h>

void reference_order(const struct crowd *c, uint32_t *order)
{
    int n = 0;

    for (uint16_t k = 0; k < CROWD_KINDS; k++)
        for (int i = 0; i < c->n; i++)
            if (c->bullets[i].kind == k)
                order[n++] = (uint32_t)i;
}

void reference_expand(uint32_t *out, const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            out[y * w + x] = rgb[pix[y * pitch + x]];
}

/* A position's pixel; right shifts of negative numbers are not the same everywhere. */
static int whole(int32_t v)
{
    return v >= 0 ? v / 65536 : -((65535 - v) / 65536);
}

static void paint(const struct crowd *c, const uint8_t *pix, int32_t x, int32_t y, uint8_t *out)
{
    int left = whole(x) - CROWD_SIDE / 2, top = whole(y) - CROWD_SIDE / 2;

    for (int j = 0; j < CROWD_SIDE; j++)
        for (int i = 0; i < CROWD_SIDE; i++) {
            uint8_t colour = pix[j * CROWD_SIDE + i];
            if (colour && left + i >= 0 && left + i < c->w && top + j >= 0 && top + j < c->h)
                out[(top + j) * c->w + left + i] = colour;
        }
}

void reference_paint(const struct crowd *c, const int32_t *xy, const struct crowd_player *p, uint8_t *out)
{
    memset(out, 0, (size_t)(c->w * c->h));
    paint(c, c->ship, p->x, p->y, out);
    for (int k = 0; k < CROWD_KINDS; k++)
        for (int i = 0; i < c->n; i++)
            if (c->bullets[i].kind == k)
                paint(c, c->pix[k], xy[2 * i], xy[2 * i + 1], out);
}

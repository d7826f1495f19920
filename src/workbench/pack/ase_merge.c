/*
 * ase_merge.c - see ase.h: merges the layers of a frame. Colours must be exactly those that Aseprite shows and exports,
 * because they are looked up in the palette. The arithmetic is therefore Aseprite's, to the last bit: integers from 0
 * to 255, products rounded to nearest, quotients truncated. Over a translucent pixel, the result of a blend mode is
 * mixed with the result of the normal mode, twice. Source: src/doc/blend_funcs.cpp of Aseprite 1.2.18 to 1.3.
 */
#include "ase.h"

#include <string.h>
#include "../../base/err.h"
#include "../../base/int.h"

/* Returns a * b / 255, rounded to nearest; a may be negative. */
static int mul(int a, int b)
{
    const int t = a * b + 128;

    return ((t >> 8) + t) >> 8;
}

static int screen(int a, int b)
{
    return a + b - mul(a, b);
}

/* Multiplies if `over` is dark, and screens if it is light. */
static int hard_light(int under, int over)
{
    return over < 128 ? mul(under, 2 * over) : screen(under, 2 * over - 255);
}

/* Blends a channel of two opaque colours. */
static int blend_channel(enum ase_blend mode, int under, int over)
{
    switch (mode) {
    case ASE_MULTIPLY:
        return mul(under, over);
    case ASE_SCREEN:
        return screen(under, over);
    case ASE_OVERLAY:
        return hard_light(over, under);
    case ASE_DARKEN:
        return int_min(under, over);
    case ASE_LIGHTEN:
        return int_max(under, over);
    case ASE_DODGE:
        return under == 0 ? 0 : over == 255 ? 255 : int_min(255, (under * 255 + (255 - over) / 2) / (255 - over));
    case ASE_BURN:
        return under == 255 ? 255 : over == 0 ? 0 : 255 - int_min(255, ((255 - under) * 255 + over / 2) / over);
    case ASE_HARD_LIGHT:
        return hard_light(under, over);
    case ASE_DIFFERENCE:
        return under > over ? under - over : over - under;
    case ASE_EXCLUSION:
        return under + over - 2 * mul(under, over);
    case ASE_ADDITION:
        return int_min(255, under + over);
    case ASE_SUBTRACT:
        return int_max(0, under - over);
    case ASE_DIVIDE:
        return under == 0 ? 0 : over == 0 ? 255 : int_min(255, (under * 255 + over / 2) / over);
    default:
        return over;
    }
}

/* Composites `colour` over `under` in normal mode. */
static void blend_normal(const uint8_t under[4], const uint8_t colour[4], uint8_t out[4])
{
    const int alpha = colour[3], out_alpha = alpha + under[3] - mul(under[3], alpha);

    if (under[3] == 0) {
        memcpy(out, colour, 4);
        return;
    }
    for (int c = 0; c < 3; c++)
        out[c] = (uint8_t)(under[c] + (colour[c] - under[c]) * alpha / out_alpha);
    out[3] = (uint8_t)out_alpha;
}

/* Mixes part / 255 of `to`, which has the same opacity, into `from`. */
static void mix(uint8_t from[4], const uint8_t to[4], int part)
{
    for (int c = 0; c < 3; c++)
        from[c] = (uint8_t)(from[c] + mul(to[c] - from[c], part));
}

void ase_blend(enum ase_blend mode, uint8_t under[4], const uint8_t colour[4])
{
    uint8_t normal[4], blended[4] = { 0, 0, 0, colour[3] };

    blend_normal(under, colour, normal);
    if (mode != ASE_NORMAL && under[3] != 0) {
        for (int c = 0; c < 3; c++)
            blended[c] = (uint8_t)blend_channel(mode, under[c], colour[c]);
        blend_normal(under, blended, blended);
        mix(normal, blended, under[3]);
        mix(normal, blended, mul(under[3], colour[3]));
    }
    memcpy(under, normal, 4);
}

/* Reads the colour of a cel's pixel. False: it is transparent, or *wrong: its index is not in the palette. */
static bool read_colour(const struct ase *a, const struct ase_layer *l, const uint8_t *p, uint8_t out[4], bool *wrong)
{
    if (a->depth == 4) {
        memcpy(out, p, 4);
    } else if (a->depth == 2) {
        memset(out, p[0], 3);
        out[3] = p[1];
    } else if (*p == a->transparent_index && !l->background) {
        return false;
    } else if (*p >= a->colours) {
        *wrong = true;
        return false;
    } else
        memcpy(out, a->palette[*p], 4);
    return out[3] > 0;
}

static bool merge_cel(const struct ase *a, const struct ase_cel *c, uint8_t *rgba, uint8_t *index, char *err,
                      size_t err_size)
{
    const struct ase_layer *l = &a->layers[c->layer];
    const struct ase_image *i = &a->images[c->image];
    const int x0 = int_max(0, -c->x), x1 = int_min(i->w, a->w - c->x);
    bool wrong = false;
    uint8_t colour[4];

    for (int y = int_max(0, -c->y); y < int_min(i->h, a->h - c->y); y++)
        for (int x = x0; x < x1; x++) {
            const uint8_t *p = i->pix + ((size_t)y * (size_t)i->w + (size_t)x) * (size_t)a->depth;
            const size_t to = (size_t)(y + c->y) * (size_t)a->w + (size_t)(x + c->x);
            const bool opaque = read_colour(a, l, p, colour, &wrong);
            if (wrong)
                return err_set(err, err_size, "layer \"%s\": index %d, but the palette has %d colours", l->name, *p,
                               a->colours);
            if (!opaque)
                continue;
            colour[3] = (uint8_t)mul(colour[3], mul(c->opacity, l->opacity));
            ase_blend((enum ase_blend)l->blend, rgba + 4 * to, colour);
            if (index && colour[3] >= 128)
                index[to] = *p;
        }
    return true;
}

/* Returns whether cel a is drawn before b: by the sum of layer and z, then by z. */
static bool is_below(const struct ase_cel *a, const struct ase_cel *b)
{
    const int at = a->layer + a->z, other = b->layer + b->z;

    return at != other ? at < other : a->z < b->z;
}

bool ase_merge(const struct ase *a, int frame, uint8_t *rgba, uint8_t *index, char *err, size_t err_size)
{
    const struct ase_frame *f = &a->frames[frame];
    const struct ase_cel *order[ASE_MAX_LAYERS];
    const size_t size = (size_t)a->w * (size_t)a->h;
    int n = 0;

    memset(rgba, 0, 4 * size);
    if (index)
        memset(index, 0, size);
    for (int i = 0; i < f->cels; i++) {
        const struct ase_cel *c = &a->cels[f->first_cel + i];
        int at = n;
        if (!a->layers[c->layer].visible)
            continue;
        for (; at > 0 && is_below(c, order[at - 1]); at--)
            order[at] = order[at - 1];
        order[at] = c;
        n++;
    }
    for (int i = 0; i < n; i++)
        if (!merge_cel(a, order[i], rgba, index, err, err_size))
            return false;
    return true;
}

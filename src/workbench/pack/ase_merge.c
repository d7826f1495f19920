/*
 * ase_merge.c - see ase.h: the layers of a frame over each other. A palette must have the very colours that Aseprite
 * shows and exports, so the arithmetic is Aseprite's, to the last bit: whole numbers of 255ths, where products are
 * rounded to the nearest and quotients cut. Over something half transparent the result of a blend mode is mixed with
 * the plain one twice. Source: src/doc/blend_funcs.cpp of Aseprite 1.2.18 to 1.3.
 */
#include "ase.h"

#include <string.h>
#include "../../base/err.h"
#include "../../base/int.h"

/* a * b / 255, to the nearest; a may be negative. */
static int mul(int a, int b)
{
    const int t = a * b + 128;

    return ((t >> 8) + t) >> 8;
}

static int screen(int a, int b)
{
    return a + b - mul(a, b);
}

/* Multiplies below the middle, lightens above it: which, the second decides. */
static int hard(int under, int over)
{
    return over < 128 ? mul(under, 2 * over) : screen(under, 2 * over - 255);
}

/* One channel of `over` on one of `under`, both opaque. */
static int channel(enum ase_blend mode, int under, int over)
{
    switch (mode) {
    case ASE_MULTIPLY:
        return mul(under, over);
    case ASE_SCREEN:
        return screen(under, over);
    case ASE_OVERLAY:
        return hard(over, under);
    case ASE_DARKEN:
        return int_min(under, over);
    case ASE_LIGHTEN:
        return int_max(under, over);
    case ASE_DODGE:
        return under == 0 ? 0 : over == 255 ? 255 : int_min(255, (under * 255 + (255 - over) / 2) / (255 - over));
    case ASE_BURN:
        return under == 255 ? 255 : over == 0 ? 0 : 255 - int_min(255, ((255 - under) * 255 + over / 2) / over);
    case ASE_HARD_LIGHT:
        return hard(under, over);
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

/* `colour` over `under`: R G B and opacity. Quotients are cut towards 0. */
static void put_over(const uint8_t under[4], const uint8_t colour[4], uint8_t out[4])
{
    const int ours = colour[3], all = ours + under[3] - mul(under[3], ours);

    if (under[3] == 0) {
        memcpy(out, colour, 4);
        return;
    }
    for (int c = 0; c < 3; c++)
        out[c] = (uint8_t)(under[c] + (colour[c] - under[c]) * ours / all);
    out[3] = (uint8_t)all;
}

/* Moves `from` towards `to`, which has the same opacity, by part / 255. */
static void move_towards(uint8_t from[4], const uint8_t to[4], int part)
{
    for (int c = 0; c < 3; c++)
        from[c] = (uint8_t)(from[c] + mul(to[c] - from[c], part));
}

void ase_blend(enum ase_blend mode, uint8_t under[4], const uint8_t colour[4])
{
    uint8_t plain[4], blended[4] = { 0, 0, 0, colour[3] };

    put_over(under, colour, plain);
    if (mode != ASE_NORMAL && under[3] != 0) {
        for (int c = 0; c < 3; c++)
            blended[c] = (uint8_t)channel(mode, under[c], colour[c]);
        put_over(under, blended, blended);
        move_towards(plain, blended, under[3]);
        move_towards(plain, blended, mul(under[3], colour[3]));
    }
    memcpy(under, plain, 4);
}

/* The colour of a pixel of a cel; false: it is transparent, or (with a sentence) its index is none of the palette. */
static bool colour_of(const struct ase *a, const struct ase_layer *l, const uint8_t *p, uint8_t out[4], bool *wrong)
{
    if (a->depth == 4) {
        memcpy(out, p, 4);
    } else if (a->depth == 2) {
        memset(out, p[0], 3);
        out[3] = p[1];
    } else if (*p == a->clear && !l->background) {
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
            const bool seen = colour_of(a, l, p, colour, &wrong);
            if (wrong)
                return err_set(err, err_size, "layer \"%s\": index %d, but the palette has %d colours", l->name, *p,
                               a->colours);
            if (!seen)
                continue;
            colour[3] = (uint8_t)mul(colour[3], mul(c->opacity, l->opacity));
            ase_blend((enum ase_blend)l->blend, rgba + 4 * to, colour);
            if (index && colour[3] >= 128)
                index[to] = *p;
        }
    return true;
}

/* Cels are drawn by the sum of layer and z, and of equals the lower z first. */
static bool before(const struct ase_cel *a, const struct ase_cel *b)
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
        if (!a->layers[c->layer].shown)
            continue;
        for (; at > 0 && before(c, order[at - 1]); at--)
            order[at] = order[at - 1];
        order[at] = c;
        n++;
    }
    for (int i = 0; i < n; i++)
        if (!merge_cel(a, order[i], rgba, index, err, err_size))
            return false;
    return true;
}

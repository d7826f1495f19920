/*
 * atlas.c - see atlas.h. The same code lays the picture out twice: first without memory, to measure it, then to paint
 * it.
 */
#include "atlas.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../player/overlay/letters.h"
#include "../../player/picture/png.h"
#include "../../common/array.h"

enum {
    WIDTH = 1080, /* px; more, if one sprite needs it, or all of them would be higher than a PNG can be */
    EDGE = 24,
    GAP = 22,         /* between two sprites */
    LEAST = 132,      /* px of a sprite's text */
    TEXT = 2,         /* px of a pixel of letters */
    LINE = 12 * TEXT, /* from line to line */
    HEAD = 44,        /* of a bank: its name and colours */
    SWATCH = 18,      /* px of a colour there */
    SMALL = 10,       /* px above and below the frames */
    BETWEEN = 4,      /* px between two frames */
    MOST_WORDS = 5,   /* listed hit shapes of a sprite */
    MOST_FRAMES = 12, /* of one sprite that are shown small */
    ARM = 7           /* px of the cross at the origin */
};

#define GROUND 0x17181d
#define TILE_A 0x26272e
#define TILE_B 0x2d2e36
#define INK    0xf2f2ee
#define FAINT  0x9a9ca6
#define RULE   0x3a3b44
#define DARK   0x000000

struct atlas {
    const struct cart *cart;
    const struct atlas_shapes *shapes;
    const uint8_t *palette;
    uint8_t *rgb; /* NULL: only measuring */
    int w, h;
};

struct colour_of {
    const char *of;
    uint32_t rgb;
};
static const struct colour_of colours[] = {
    { "player", 0x5fe3ff }, { "bullet", 0xff6a7a }, { "shot", 0x7dff8a }, { "enemy", 0xffd24a }
};

void atlas_shapes_add(void *shapes, const struct inspect_kind_shape *kind)
{
    struct atlas_shapes *s = shapes;

    if (array_append(&s->list, (size_t)s->n, sizeof *s->list))
        s->list[s->n++] = *kind;
    else
        s->failed = true;
}

void atlas_shapes_close(struct atlas_shapes *shapes)
{
    free(shapes->list);
    *shapes = (struct atlas_shapes){ 0 };
}

static double px(int32_t v)
{
    return v / 65536.0;
}

/* Rounds to a hundredth. */
static double rounded(double v)
{
    return floor(v * 100 + 0.5) / 100;
}

void atlas_shape_words(const struct inspect_kind_shape *s, char *out, size_t size)
{
    switch (s->shape) {
    case INSPECT_BOX:
        snprintf(out, size, "%s %s: box %g x %g", s->entity, s->name, rounded(px(s->x1) * 2), rounded(px(s->y1) * 2));
        break;
    case INSPECT_CAPSULE:
        snprintf(out, size, "%s %s: capsule %g, %g", s->entity, s->name, rounded(2 * hypot(px(s->bar_x), px(s->bar_y))),
                 rounded(px(s->r)));
        break;
    case INSPECT_CIRCLES:
        snprintf(out, size, "%s %s: %d circle%s", s->entity, s->name, s->n, s->n == 1 ? "" : "s");
        break;
    default:
        snprintf(out, size, "%s %s: circle %g", s->entity, s->name, rounded(px(s->r)));
    }
}

/* ---- paint ---- */

static void dot(const struct atlas *a, int x, int y, uint32_t rgb)
{
    if (!a->rgb || x < 0 || y < 0 || x >= a->w || y >= a->h)
        return;
    uint8_t *to = a->rgb + ((size_t)y * (size_t)a->w + (size_t)x) * 3;
    to[0] = (uint8_t)(rgb >> 16);
    to[1] = (uint8_t)(rgb >> 8);
    to[2] = (uint8_t)rgb;
}

static void fill(const struct atlas *a, int x, int y, int w, int h, uint32_t rgb)
{
    for (int j = 0; j < h; j++)
        for (int i = 0; i < w; i++)
            dot(a, x + i, y + j, rgb);
}

/* Draws a line of text with the top of capitals at y; returns its width in px. Without memory it only measures. */
static int say(const struct atlas *a, int x, int y, uint32_t rgb, const char *text)
{
    const char *end = text + strlen(text);
    const int from = x;

    while (text < end) {
        const uint32_t code = utf8_next(&text, end);
        struct letter l;
        letter_load(&l, code);
        for (int row = 0; row < LETTER_ROWS; row++)
            for (int k = 0; k < l.w; k++)
                if (code != ' ' && l.rows[row] >> k & 1)
                    fill(a, x + k * TEXT, y + (row - LETTER_ACCENT_HEIGHT) * TEXT, TEXT, TEXT, rgb);
        x += ((code == ' ' ? LETTER_SPACE_WIDTH : l.w) + 1) * TEXT;
    }
    return x - from;
}

static uint32_t entry(const struct atlas *a, int i)
{
    return (uint32_t)a->palette[3 * i] << 16 | (uint32_t)a->palette[3 * i + 1] << 8 | a->palette[3 * i + 2];
}

/* One picture of a sprite, each pixel a square. */
static void paint(const struct atlas *a, const struct sprite *s, int frame, int x, int y, int scale)
{
    const uint8_t *pix = s->pix + (size_t)frame * s->rotations * s->pitch * s->h;

    for (int j = 0; j < s->h; j++)
        for (int i = 0; i < s->w; i++)
            if (pix[j * s->pitch + i])
                fill(a, x + i * scale, y + j * scale, scale, scale, entry(a, pix[j * s->pitch + i]));
}

/* A chequered background, which shows through transparent pixels. */
static void ground(const struct atlas *a, int x, int y, int w, int h)
{
    enum { SIDE = 8 * ATLAS_SCALE };

    for (int j = 0; j < h; j++)
        for (int i = 0; i < w; i++)
            dot(a, x + i, y + j, (i / SIDE + j / SIDE) % 2 ? TILE_A : TILE_B);
}

/* ---- hit shapes ---- */

static double from_bar(double x, double y, double bar_x, double bar_y)
{
    const double length = bar_x * bar_x + bar_y * bar_y;
    double at = length > 0 ? (x * bar_x + y * bar_y) / length : 0;

    at = at < -1 ? -1 : at > 1 ? 1 : at;
    return hypot(x - at * bar_x, y - at * bar_y);
}

/* Distance of a point from the shape, px; negative inside. */
static double outside(const struct inspect_kind_shape *s, double x, double y)
{
    double least = 1e9;

    switch (s->shape) {
    case INSPECT_BOX: {
        const double dx = fabs(x) - px(s->x1), dy = fabs(y) - px(s->y1);
        return dx > dy ? dx : dy;
    }
    case INSPECT_CAPSULE:
        return from_bar(x, y, px(s->bar_x), px(s->bar_y)) - px(s->r);
    case INSPECT_CIRCLES:
        for (int i = 0; i < s->n; i++) {
            const double d = hypot(x - px(s->circle[i].x), y - px(s->circle[i].y)) - px(s->circle[i].r);
            least = d < least ? d : least;
        }
        return least;
    default:
        return hypot(x, y) - px(s->r);
    }
}

static uint32_t colour_for(const struct inspect_kind_shape *s)
{
    for (size_t i = 0; i < sizeof colours / sizeof *colours; i++)
        if (strcmp(colours[i].of, s->entity) == 0)
            return colours[i].rgb;
    return INK;
}

/* The outline around (ox, oy), with a dark rim, inside the sprite's cell. */
static void outline(const struct atlas *a, const struct inspect_kind_shape *s, int x, int y, int w, int h, double ox,
                    double oy)
{
    for (int rim = 1; rim >= 0; rim--)
        for (int j = 0; a->rgb && j < h; j++)
            for (int i = 0; i < w; i++) {
                const double d = outside(s, (i + 0.5) / ATLAS_SCALE - ox, (j + 0.5) / ATLAS_SCALE - oy) * ATLAS_SCALE;
                if (d >= (rim ? -2 : -1) && d < (rim ? 2 : 1))
                    dot(a, x + i, y + j, rim ? DARK : colour_for(s));
            }
}

/* The origin: a cross, smaller in small pictures. */
static void cross(const struct atlas *a, int x, int y, int side)
{
    const int third = side * ATLAS_SCALE / 3, arm = third > ARM ? ARM : third < 2 ? 2 : third;

    fill(a, x - arm - 1, y - 1, 2 * arm + 3, 3, DARK);
    fill(a, x - 1, y - arm - 1, 3, 2 * arm + 3, DARK);
    fill(a, x - arm, y, 2 * arm + 1, 1, INK);
    fill(a, x, y - arm, 1, 2 * arm + 1, INK);
}

/* ---- a sprite ---- */

/* The lines of text under a picture. */
struct lines {
    char line[MOST_WORDS + 4][96];
    uint32_t rgb[MOST_WORDS + 4];
    int n;
};

static void add_words(struct lines *w, uint32_t rgb, const char *text)
{
    snprintf(w->line[w->n], sizeof w->line[0], "%s", text);
    w->rgb[w->n++] = rgb;
}

static bool has(const struct lines *w, const char *text)
{
    for (int i = 0; i < w->n; i++)
        if (strcmp(w->line[i], text) == 0)
            return true;
    return false;
}

static void describe(const struct atlas *a, int i, const struct sprite *s, struct lines *out)
{
    const char *name = cart_name(a->cart, CART_SPRITES, i);
    char text[96];
    int left_out = 0;

    out->n = 0;
    add_words(out, INK, name);
    snprintf(text, sizeof text, "%d x %d", s->w, s->h);
    if (s->rotations > 1)
        snprintf(text + strlen(text), sizeof text - strlen(text), ", %d rotations", s->rotations);
    add_words(out, FAINT, text);
    if (s->frames > 1) {
        snprintf(text, sizeof text, "%d frames, every = %d", s->frames, s->frame_ticks);
        add_words(out, FAINT, text);
    }
    for (int k = 0; k < a->shapes->n; k++) {
        const struct inspect_kind_shape *shape = &a->shapes->list[k];
        if (strcmp(shape->sprite, name) != 0)
            continue;
        atlas_shape_words(shape, text, sizeof text);
        if (has(out, text))
            continue;
        if (out->n < MOST_WORDS + 3)
            add_words(out, colour_for(shape), text);
        else
            left_out++;
    }
    if (left_out) {
        snprintf(text, sizeof text, "and %d more", left_out);
        add_words(out, FAINT, text);
    }
}

/* Small frames under the picture, and their columns in w px. */
static int small_frames(const struct sprite *s)
{
    return s->frames < 2 ? 0 : s->frames < MOST_FRAMES ? s->frames : MOST_FRAMES;
}

static int small_columns(const struct sprite *s, int w)
{
    return (w + BETWEEN) / (s->w + BETWEEN);
}

/* Their height with the gap below them, px. */
static int small_height(const struct sprite *s, int w)
{
    const int columns = small_columns(s, w), n = small_frames(s);

    return n ? (n + columns - 1) / columns * (s->h + BETWEEN) - BETWEEN + SMALL : 0;
}

struct cell {
    int sprite, w, h, picture; /* px; how high the picture is */
    struct sprite s;
};

static struct cell measure(const struct atlas *a, int i)
{
    const struct atlas blind = { .cart = a->cart };
    struct cell c = { .sprite = i, .w = LEAST };
    struct lines words;

    cart_sprite(a->cart, i, &c.s);
    describe(a, i, &c.s, &words);
    for (int k = 0; k < words.n; k++) {
        const int w = say(&blind, 0, 0, 0, words.line[k]);
        c.w = w > c.w ? w : c.w;
    }
    c.w = c.s.w * ATLAS_SCALE > c.w ? c.s.w * ATLAS_SCALE : c.w;
    c.picture = c.s.h * ATLAS_SCALE;
    c.h = c.picture + SMALL + small_height(&c.s, c.w) + words.n * LINE;
    return c;
}

/* The place of the origin in a picture, px. */
static double place_of(int origin, int side)
{
    return origin == side / 2 ? side / 2.0 : origin + 0.5;
}

/* The pictures of a row are aligned at `floor` px below y. */
static void paint_cell(const struct atlas *a, const struct cell *c, int x, int y, int floor)
{
    const struct sprite *s = &c->s;
    const char *name = cart_name(a->cart, CART_SPRITES, c->sprite);
    const int w = s->w * ATLAS_SCALE, h = s->h * ATLAS_SCALE, top = y + floor - h;
    const int columns = small_columns(s, c->w);
    const double ox = place_of(s->ox, s->w), oy = place_of(s->oy, s->h);
    struct lines words;
    int at = y + floor + SMALL;

    ground(a, x, top, w, h);
    paint(a, s, 0, x, top, ATLAS_SCALE);
    for (int k = 0; k < a->shapes->n; k++)
        if (strcmp(a->shapes->list[k].sprite, name) == 0)
            outline(a, &a->shapes->list[k], x, top, w, h, ox, oy);
    cross(a, x + (int)(ox * ATLAS_SCALE), top + (int)(oy * ATLAS_SCALE), s->w < s->h ? s->w / 2 : s->h / 2);
    for (int k = 0; k < small_frames(s); k++)
        paint(a, s, k, x + k % columns * (s->w + BETWEEN), at + k / columns * (s->h + BETWEEN), 1);
    at += small_height(s, c->w);
    describe(a, c->sprite, s, &words);
    for (int k = 0; k < words.n; k++)
        say(a, x, at + k * LINE + LETTER_ACCENT_HEIGHT * TEXT - 2, words.rgb[k], words.line[k]);
}

/* ---- the picture ---- */

static int by_size(const void *a, const void *b)
{
    const struct cell *one = a, *other = b;

    if (one->s.bank != other->s.bank)
        return one->s.bank - other->s.bank;
    return one->s.h != other->s.h ? other->s.h - one->s.h : one->sprite - other->sprite;
}

static int paint_head(const struct atlas *a, int bank, int y)
{
    char text[16];

    snprintf(text, sizeof text, "bank %d", bank);
    fill(a, EDGE, y + HEAD - 8, a->w - 2 * EDGE, 1, RULE);
    say(a, EDGE, y + 12, INK, text);
    for (int shade = 1; shade < 16; shade++)
        fill(a, EDGE + 96 + (shade - 1) * (SWATCH + 2), y + 8, SWATCH, SWATCH, entry(a, bank * 16 + shade));
    return y + HEAD + 4;
}

/* Number of cells in the row that starts at i, and the height of its highest picture and cell. */
static int row_of(const struct atlas *a, const struct cell *cells, int n, int i, int *floor, int *h)
{
    int x = EDGE, k = i;

    *floor = *h = 0;
    for (; k < n && cells[k].s.bank == cells[i].s.bank && (k == i || x + cells[k].w <= a->w - EDGE); k++) {
        x += cells[k].w + GAP;
        *floor = cells[k].picture > *floor ? cells[k].picture : *floor;
    }
    for (int c = i; c < k; c++)
        *h = *floor + cells[c].h - cells[c].picture > *h ? *floor + cells[c].h - cells[c].picture : *h;
    return k - i;
}

/* Paints everything; returns the height. */
static int lay_out(const struct atlas *a, const struct cell *cells, int n)
{
    int y = EDGE - 8, floor, h;

    for (int i = 0; i < n;) {
        if (i == 0 || cells[i].s.bank != cells[i - 1].s.bank)
            y = paint_head(a, cells[i].s.bank, y);
        const int row = row_of(a, cells, n, i, &floor, &h);
        for (int k = 0, x = EDGE; k < row; x += cells[i + k].w + GAP, k++)
            paint_cell(a, &cells[i + k], x, y, floor);
        y += h + GAP;
        i += row;
    }
    return y + EDGE - GAP;
}

bool atlas_make(const struct cart *cart, const struct atlas_shapes *shapes, uint8_t **rgb, int *w, int *h)
{
    struct atlas a = { .cart = cart, .shapes = shapes, .palette = cart_palette(cart, "main"), .w = WIDTH };
    struct cell *cells = malloc((size_t)(cart->count[CART_SPRITES] + 1) * sizeof *cells);

    *rgb = NULL;
    for (int i = 0; cells && i < cart->count[CART_SPRITES]; i++) {
        cells[i] = measure(&a, i);
        a.w = cells[i].w + 2 * EDGE > a.w ? cells[i].w + 2 * EDGE : a.w;
    }
    if (cells) {
        qsort(cells, (size_t)cart->count[CART_SPRITES], sizeof *cells, by_size);
        a.h = lay_out(&a, cells, cart->count[CART_SPRITES]);
        while (a.h > PNG_MAX_SIDE && a.w <= PNG_MAX_SIDE / 3 * 2) { /* too high for a PNG: wider */
            a.w += a.w / 2;
            a.h = lay_out(&a, cells, cart->count[CART_SPRITES]);
        }
    }
    if (cells && a.h <= PNG_MAX_SIDE && a.w <= PNG_MAX_SIDE)
        a.rgb = malloc((size_t)a.w * (size_t)a.h * 3);
    if (a.rgb) {
        fill(&a, 0, 0, a.w, a.h, GROUND);
        lay_out(&a, cells, cart->count[CART_SPRITES]);
    }
    free(cells);
    *rgb = a.rgb;
    *w = a.w;
    *h = a.h;
    return a.rgb != NULL;
}

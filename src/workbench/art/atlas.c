/*
 * atlas.c - see atlas.h. The same code runs twice: first without a canvas, to measure the picture, then to draw it.
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
    WIDTH = 1080, /* px; wider for a wide sprite, or if the picture would be higher than a PNG can be */
    MARGIN = 24,
    GAP = 22,                      /* between two sprites */
    MIN_CELL_WIDTH = 132,          /* px, for the caption */
    TEXT_SCALE = 2,                /* px per pixel of a letter */
    LINE_HEIGHT = 12 * TEXT_SCALE, /* px */
    HEADING_HEIGHT = 44,           /* a bank's name and colours */
    SWATCH = 18,                   /* px of a colour in the heading */
    FRAMES_MARGIN = 10,            /* px above and below the frames */
    FRAME_GAP = 4,                 /* px between two frames */
    MAX_SHAPES = 5,                /* hit shapes listed for a sprite */
    MAX_FRAMES = 12,               /* of a sprite, drawn without scaling */
    CROSS_ARM = 7                  /* px, of the cross at the origin */
};

#define BACKGROUND 0x17181d
#define TILE_A     0x26272e
#define TILE_B     0x2d2e36
#define INK        0xf2f2ee
#define MUTED      0x9a9ca6
#define RULE       0x3a3b44
#define DARK       0x000000

struct atlas {
    const struct cart *cart;
    const struct atlas_shapes *shapes;
    const uint8_t *palette;
    uint8_t *rgb; /* NULL: only measure */
    int w, h;
};

struct entity_colour {
    const char *entity;
    uint32_t rgb;
};

static const struct entity_colour colours[] = {
    { "player", 0x5fe3ff }, { "bullet", 0xff6a7a }, { "shot", 0x7dff8a }, { "enemy", 0xffd24a }
};

void atlas_shapes_add(void *shapes, const struct inspect_kind_shape *kind)
{
    struct atlas_shapes *s = shapes;

    if (kind->scale != SCALE_ONE) /* the atlas shows sprites in their own size */
        return;
    if (array_append(&s->list, (size_t)s->n, sizeof *s->list))
        s->list[s->n++] = *kind;
    else
        s->failed = true;
}

void atlas_shapes_free(struct atlas_shapes *shapes)
{
    free(shapes->list);
    *shapes = (struct atlas_shapes){ 0 };
}

static double px(int32_t v)
{
    return v / 65536.0;
}

static double round_hundredth(double v)
{
    return floor(v * 100 + 0.5) / 100;
}

void atlas_shape_describe(const struct inspect_kind_shape *s, char *out, size_t size)
{
    switch (s->shape) {
    case INSPECT_BOX:
        snprintf(out, size, "%s %s: box %g x %g", s->entity, s->name, round_hundredth(px(s->x1) * 2),
                 round_hundredth(px(s->y1) * 2));
        break;
    case INSPECT_CAPSULE:
        snprintf(out, size, "%s %s: capsule %g, %g", s->entity, s->name,
                 round_hundredth(2 * hypot(px(s->bar_x), px(s->bar_y))), round_hundredth(px(s->r)));
        break;
    case INSPECT_CIRCLES:
        snprintf(out, size, "%s %s: %d circle%s", s->entity, s->name, s->n, s->n == 1 ? "" : "s");
        break;
    default:
        snprintf(out, size, "%s %s: circle %g", s->entity, s->name, round_hundredth(px(s->r)));
    }
}

/* ---- paint ---- */

static void set_pixel(const struct atlas *a, int x, int y, uint32_t rgb)
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
            set_pixel(a, x + i, y + j, rgb);
}

/* Draws a line of text with the top of capitals at y; returns its width in px. */
static int draw_text(const struct atlas *a, int x, int y, uint32_t rgb, const char *text)
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
                    fill(a, x + k * TEXT_SCALE, y + (row - LETTER_ACCENT_HEIGHT) * TEXT_SCALE, TEXT_SCALE, TEXT_SCALE,
                         rgb);
        x += ((code == ' ' ? LETTER_SPACE_WIDTH : l.w) + 1) * TEXT_SCALE;
    }
    return x - from;
}

static uint32_t palette_colour(const struct atlas *a, int i)
{
    return (uint32_t)a->palette[3 * i] << 16 | (uint32_t)a->palette[3 * i + 1] << 8 | a->palette[3 * i + 2];
}

/* Draws a frame of a sprite, each pixel as a square. */
static void draw_frame(const struct atlas *a, const struct sprite *s, int frame, int x, int y, int scale)
{
    const uint8_t *pix = s->pix + (size_t)frame * s->rotations * s->pitch * s->h;

    for (int j = 0; j < s->h; j++)
        for (int i = 0; i < s->w; i++)
            if (pix[j * s->pitch + i])
                fill(a, x + i * scale, y + j * scale, scale, scale, palette_colour(a, pix[j * s->pitch + i]));
}

/* Draws a checkerboard, which shows through transparent pixels. */
static void draw_checkerboard(const struct atlas *a, int x, int y, int w, int h)
{
    enum { SIDE = 8 * ATLAS_SCALE };

    for (int j = 0; j < h; j++)
        for (int i = 0; i < w; i++)
            set_pixel(a, x + i, y + j, (i / SIDE + j / SIDE) % 2 ? TILE_A : TILE_B);
}

/* ---- hit shapes ---- */

static double distance_to_bar(double x, double y, double bar_x, double bar_y)
{
    const double length = bar_x * bar_x + bar_y * bar_y;
    double at = length > 0 ? (x * bar_x + y * bar_y) / length : 0;

    at = at < -1 ? -1 : at > 1 ? 1 : at;
    return hypot(x - at * bar_x, y - at * bar_y);
}

/* Signed distance of a point from the shape, px; negative inside. */
static double distance(const struct inspect_kind_shape *s, double x, double y)
{
    double least = 1e9;

    switch (s->shape) {
    case INSPECT_BOX: {
        const double dx = fabs(x) - px(s->x1), dy = fabs(y) - px(s->y1);
        return dx > dy ? dx : dy;
    }
    case INSPECT_CAPSULE:
        return distance_to_bar(x, y, px(s->bar_x), px(s->bar_y)) - px(s->r);
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

static uint32_t shape_colour(const struct inspect_kind_shape *s)
{
    for (size_t i = 0; i < sizeof colours / sizeof *colours; i++)
        if (strcmp(colours[i].entity, s->entity) == 0)
            return colours[i].rgb;
    return INK;
}

/* Draws the shape's outline around (ox, oy), with a dark rim, inside the sprite's cell. */
static void draw_outline(const struct atlas *a, const struct inspect_kind_shape *s, int x, int y, int w, int h,
                         double ox, double oy)
{
    for (int rim = 1; rim >= 0; rim--)
        for (int j = 0; a->rgb && j < h; j++)
            for (int i = 0; i < w; i++) {
                const double d = distance(s, (i + 0.5) / ATLAS_SCALE - ox, (j + 0.5) / ATLAS_SCALE - oy) * ATLAS_SCALE;
                if (d >= (rim ? -2 : -1) && d < (rim ? 2 : 1))
                    set_pixel(a, x + i, y + j, rim ? DARK : shape_colour(s));
            }
}

/* Draws a cross at the origin, smaller in small sprites. */
static void draw_origin(const struct atlas *a, int x, int y, int side)
{
    const int third = side * ATLAS_SCALE / 3, arm = third > CROSS_ARM ? CROSS_ARM : third < 2 ? 2 : third;

    fill(a, x - arm - 1, y - 1, 2 * arm + 3, 3, DARK);
    fill(a, x - 1, y - arm - 1, 3, 2 * arm + 3, DARK);
    fill(a, x - arm, y, 2 * arm + 1, 1, INK);
    fill(a, x, y - arm, 1, 2 * arm + 1, INK);
}

/* ---- a sprite ---- */

/* The lines of text below a sprite. */
struct caption {
    char line[MAX_SHAPES + 4][96];
    uint32_t rgb[MAX_SHAPES + 4];
    int n;
};

static void add_line(struct caption *w, uint32_t rgb, const char *text)
{
    snprintf(w->line[w->n], sizeof w->line[0], "%s", text);
    w->rgb[w->n++] = rgb;
}

static bool has_line(const struct caption *w, const char *text)
{
    for (int i = 0; i < w->n; i++)
        if (strcmp(w->line[i], text) == 0)
            return true;
    return false;
}

static void make_caption(const struct atlas *a, int i, const struct sprite *s, struct caption *out)
{
    const char *name = cart_name(a->cart, CART_SPRITES, i);
    char text[96];
    int left_out = 0;

    out->n = 0;
    add_line(out, INK, name);
    snprintf(text, sizeof text, "%d x %d", s->w, s->h);
    if (s->rotations > 1)
        snprintf(text + strlen(text), sizeof text - strlen(text), ", %d rotations", s->rotations);
    add_line(out, MUTED, text);
    if (s->frames > 1) {
        snprintf(text, sizeof text, "%d frames, every = %d", s->frames, s->frame_ticks);
        add_line(out, MUTED, text);
    }
    for (int k = 0; k < a->shapes->n; k++) {
        const struct inspect_kind_shape *shape = &a->shapes->list[k];
        if (strcmp(shape->sprite, name) != 0)
            continue;
        atlas_shape_describe(shape, text, sizeof text);
        if (has_line(out, text))
            continue;
        if (out->n < MAX_SHAPES + 3)
            add_line(out, shape_colour(shape), text);
        else
            left_out++;
    }
    if (left_out) {
        snprintf(text, sizeof text, "and %d more", left_out);
        add_line(out, MUTED, text);
    }
}

/* Returns the number of thumbnails, which show the frames without scaling, and how many fit in a row of w px. */
static int thumbnail_count(const struct sprite *s)
{
    return s->frames < 2 ? 0 : s->frames < MAX_FRAMES ? s->frames : MAX_FRAMES;
}

static int thumbnail_columns(const struct sprite *s, int w)
{
    return (w + FRAME_GAP) / (s->w + FRAME_GAP);
}

/* Returns the height of the thumbnails with the gap below them, px. */
static int thumbnails_height(const struct sprite *s, int w)
{
    const int columns = thumbnail_columns(s, w), n = thumbnail_count(s);

    return n ? (n + columns - 1) / columns * (s->h + FRAME_GAP) - FRAME_GAP + FRAMES_MARGIN : 0;
}

struct cell {
    int sprite, w, h, picture_h; /* px */
    struct sprite s;
};

static struct cell measure_cell(const struct atlas *a, int i)
{
    const struct atlas no_canvas = { .cart = a->cart };
    struct cell c = { .sprite = i, .w = MIN_CELL_WIDTH };
    struct caption words;

    cart_sprite(a->cart, i, &c.s);
    make_caption(a, i, &c.s, &words);
    for (int k = 0; k < words.n; k++) {
        const int w = draw_text(&no_canvas, 0, 0, 0, words.line[k]);
        c.w = w > c.w ? w : c.w;
    }
    c.w = c.s.w * ATLAS_SCALE > c.w ? c.s.w * ATLAS_SCALE : c.w;
    c.picture_h = c.s.h * ATLAS_SCALE;
    c.h = c.picture_h + FRAMES_MARGIN + thumbnails_height(&c.s, c.w) + words.n * LINE_HEIGHT;
    return c;
}

/* Returns the origin's position in px of the sprite: the exact centre, or the middle of a pixel. */
static double origin_px(int origin, int side)
{
    return origin == side / 2 ? side / 2.0 : origin + 0.5;
}

/* Draws a cell at (x, y). All sprites of a row end `baseline` px below y. */
static void draw_cell(const struct atlas *a, const struct cell *c, int x, int y, int baseline)
{
    const struct sprite *s = &c->s;
    const char *name = cart_name(a->cart, CART_SPRITES, c->sprite);
    const int w = s->w * ATLAS_SCALE, h = s->h * ATLAS_SCALE, top = y + baseline - h;
    const int columns = thumbnail_columns(s, c->w);
    const double ox = origin_px(s->ox, s->w), oy = origin_px(s->oy, s->h);
    struct caption words;
    int at = y + baseline + FRAMES_MARGIN;

    draw_checkerboard(a, x, top, w, h);
    draw_frame(a, s, 0, x, top, ATLAS_SCALE);
    for (int k = 0; k < a->shapes->n; k++)
        if (strcmp(a->shapes->list[k].sprite, name) == 0)
            draw_outline(a, &a->shapes->list[k], x, top, w, h, ox, oy);
    draw_origin(a, x + (int)(ox * ATLAS_SCALE), top + (int)(oy * ATLAS_SCALE), s->w < s->h ? s->w / 2 : s->h / 2);
    for (int k = 0; k < thumbnail_count(s); k++)
        draw_frame(a, s, k, x + k % columns * (s->w + FRAME_GAP), at + k / columns * (s->h + FRAME_GAP), 1);
    at += thumbnails_height(s, c->w);
    make_caption(a, c->sprite, s, &words);
    for (int k = 0; k < words.n; k++)
        draw_text(a, x, at + k * LINE_HEIGHT + LETTER_ACCENT_HEIGHT * TEXT_SCALE - 2, words.rgb[k], words.line[k]);
}

/* ---- the picture ---- */

static int compare_cells(const void *a, const void *b)
{
    const struct cell *one = a, *other = b;

    if (one->s.bank != other->s.bank)
        return one->s.bank - other->s.bank;
    return one->s.h != other->s.h ? other->s.h - one->s.h : one->sprite - other->sprite;
}

static int draw_bank_heading(const struct atlas *a, int bank, int y)
{
    char text[16];

    snprintf(text, sizeof text, "bank %d", bank);
    fill(a, MARGIN, y + HEADING_HEIGHT - 8, a->w - 2 * MARGIN, 1, RULE);
    draw_text(a, MARGIN, y + 12, INK, text);
    for (int shade = 1; shade < 16; shade++)
        fill(a, MARGIN + 96 + (shade - 1) * (SWATCH + 2), y + 8, SWATCH, SWATCH, palette_colour(a, bank * 16 + shade));
    return y + HEADING_HEIGHT + 4;
}

/* Returns the number of cells in the row that starts at i, and the height of its highest sprite and cell. */
static int measure_row(const struct atlas *a, const struct cell *cells, int n, int i, int *baseline, int *h)
{
    int x = MARGIN, k = i;

    *baseline = *h = 0;
    for (; k < n && cells[k].s.bank == cells[i].s.bank && (k == i || x + cells[k].w <= a->w - MARGIN); k++) {
        x += cells[k].w + GAP;
        *baseline = cells[k].picture_h > *baseline ? cells[k].picture_h : *baseline;
    }
    for (int c = i; c < k; c++)
        *h = *baseline + cells[c].h - cells[c].picture_h > *h ? *baseline + cells[c].h - cells[c].picture_h : *h;
    return k - i;
}

/* Draws everything; returns the height. */
static int lay_out(const struct atlas *a, const struct cell *cells, int n)
{
    int y = MARGIN - 8, baseline, h;

    for (int i = 0; i < n;) {
        if (i == 0 || cells[i].s.bank != cells[i - 1].s.bank)
            y = draw_bank_heading(a, cells[i].s.bank, y);
        const int row = measure_row(a, cells, n, i, &baseline, &h);
        for (int k = 0, x = MARGIN; k < row; x += cells[i + k].w + GAP, k++)
            draw_cell(a, &cells[i + k], x, y, baseline);
        y += h + GAP;
        i += row;
    }
    return y + MARGIN - GAP;
}

bool atlas_make(const struct cart *cart, const struct atlas_shapes *shapes, uint8_t **rgb, int *w, int *h)
{
    struct atlas a = { .cart = cart, .shapes = shapes, .palette = cart_palette(cart, "main"), .w = WIDTH };
    struct cell *cells = malloc((size_t)(cart->count[CART_SPRITES] + 1) * sizeof *cells);

    *rgb = NULL;
    for (int i = 0; cells && i < cart->count[CART_SPRITES]; i++) {
        cells[i] = measure_cell(&a, i);
        a.w = cells[i].w + 2 * MARGIN > a.w ? cells[i].w + 2 * MARGIN : a.w;
    }
    if (cells) {
        qsort(cells, (size_t)cart->count[CART_SPRITES], sizeof *cells, compare_cells);
        a.h = lay_out(&a, cells, cart->count[CART_SPRITES]);
        while (a.h > PNG_MAX_SIDE && a.w <= PNG_MAX_SIDE / 3 * 2) { /* too high for a PNG: wider */
            a.w += a.w / 2;
            a.h = lay_out(&a, cells, cart->count[CART_SPRITES]);
        }
    }
    if (cells && a.h <= PNG_MAX_SIDE && a.w <= PNG_MAX_SIDE)
        a.rgb = malloc((size_t)a.w * (size_t)a.h * 3);
    if (a.rgb) {
        fill(&a, 0, 0, a.w, a.h, BACKGROUND);
        lay_out(&a, cells, cart->count[CART_SPRITES]);
    }
    free(cells);
    *rgb = a.rgb;
    *w = a.w;
    *h = a.h;
    return a.rgb != NULL;
}

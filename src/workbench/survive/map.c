/*
 * map.c - see map.h.
 */
#include "map.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../board/inspect.h"
#include "../../player/overlay/canvas.h"
#include "../../player/picture/png.h"
#include "reach.h"

enum {
    PICTURES = 24,    /* of a sheet */
    LEGEND_LINES = 3, /* lines of the legend */
    GAP = 6,
    LABEL = 14,       /* px of height above a picture */
    LINE_HEIGHT = 16, /* px, of a line of the legend */
    SWATCH = 10,      /* px, of a colour in the legend */
    GREY = 0x28,
    LAST_SCALE = 2,
    BEFORE = 15 /* frames */
};

struct reach_map {
    struct section_run *s;
    const struct cart *cart;
    struct reach reachable, useful; /* reachable cells, and those that lead to the end */
    struct fb fb;
    void *screen, *scratch;
    uint32_t rgb[256];
    uint8_t *sheet;
    int w, h, scale, columns, count;
};

/* ---- the sheet ---- */

static uint8_t *pixel_at(const struct reach_map *m, int x, int y)
{
    return m->sheet + ((size_t)y * (size_t)m->w + (size_t)x) * 3;
}

static void set_pixel(const struct reach_map *m, int x, int y, int red, int green, int blue)
{
    if (x < 0 || y < 0 || x >= m->w || y >= m->h)
        return;
    uint8_t *p = pixel_at(m, x, y);
    p[0] = (uint8_t)red;
    p[1] = (uint8_t)green;
    p[2] = (uint8_t)blue;
}

static bool sheet_open(struct reach_map *m, int n)
{
    const int w = m->cart->manifest.field_w * m->scale + GAP, h = m->cart->manifest.field_h * m->scale + GAP + LABEL;

    m->columns = 1;
    while (m->columns * m->columns * w < n * h)
        m->columns++;
    m->columns = m->columns > n ? n : m->columns;
    m->w = m->columns * w + GAP;
    m->h = (n + m->columns - 1) / m->columns * h + LEGEND_LINES * LINE_HEIGHT + 2 * GAP;
    m->sheet = malloc((size_t)m->w * (size_t)m->h * 3);
    if (m->sheet)
        memset(m->sheet, GREY, (size_t)m->w * (size_t)m->h * 3);
    return m->sheet != NULL;
}

/* Draws text in the canvas's font, via a separate picture. */
static void draw_label(const struct reach_map *m, int x, int y, const char *text)
{
    enum { W = 320, H = LABEL };
    struct fb fb;
    struct canvas canvas;
    uint32_t rgb[256] = { 0 };
    void *mem = malloc(fb_size(W, H));

    if (!mem)
        return;
    fb_init(&fb, mem, W, H);
    canvas_open(&canvas, &fb, rgb);
    canvas_rect(&canvas, 0, 0, W, H, CANVAS_DARK);
    canvas_large_text(&canvas, 0, CANVAS_LARGE_ACCENT_HEIGHT, CANVAS_WHITE, text);
    for (int py = 0; py < H; py++)
        for (int px = 0; px < W; px++)
            if (fb.pix[py * fb.pitch + px] == canvas.colour[CANVAS_WHITE])
                set_pixel(m, x + px, y + py, 0xe8, 0xe8, 0xe8);
    free(mem);
}

/* ---- the legend ---- */

static const int useful_colour[3] = { 0x20, 0xd0, 0x50 }, dead_colour[3] = { 0x30, 0x70, 0xff };

/* Explains one colour per line, because a sheet may be as narrow as one picture. */
static void draw_legend(const struct reach_map *m)
{
    static const char *const words[LEGEND_LINES] = { "reachable, and leads to the end", "reachable, but a dead end",
                                                     "the ship in the run that was found" };
    const int *const colours[LEGEND_LINES] = { useful_colour, dead_colour, NULL };

    for (int k = 0; k < LEGEND_LINES; k++) {
        const int y = m->h - GAP - (LEGEND_LINES - k) * LINE_HEIGHT;
        for (int i = 0; i < SWATCH * SWATCH; i++) {
            const int dx = i % SWATCH, dy = i / SWATCH, from = SWATCH / 2;
            const int *c = colours[k];
            if (c)
                set_pixel(m, GAP + dx, y + dy, c[0], c[1], c[2]);
            else if ((dx == from) != (dy == from))
                set_pixel(m, GAP + dx, y + dy, 255, 255, 255);
        }
        draw_label(m, GAP + SWATCH + GAP, y, words[k]);
    }
}

/* ---- a picture ---- */

static bool contains(const struct reach *r, uint32_t t, int px, int py)
{
    const fx x = px * FX_ONE + FX_ONE / 2, y = py * FX_ONE + FX_ONE / 2;

    return r->sets && t <= r->frames && reach_has(r, t, x, y);
}

/* Returns the colour that the screen shows for pixel (px, py) of the field; black outside the view. */
static uint32_t field_colour(const struct reach_map *m, int px, int py)
{
    const struct inspect_area w = inspect_field(m->s->simulation.b);
    const int x = (px - w.left) * w.zoom, y = (py - w.top) * w.zoom;

    if (x < 0 || y < 0 || x >= w.w || y >= w.h)
        return 0;
    return m->rgb[m->fb.pix[(w.y + y) * m->fb.pitch + w.x + x]];
}

/* Returns the tinted colour of pixel (px, py) of the field. */
static void tint(const struct reach_map *m, uint32_t t, int px, int py, int out[3])
{
    const uint32_t rgb = field_colour(m, px, py);
    const bool reachable = contains(&m->reachable, t, px, py), useful = reachable && contains(&m->useful, t, px, py);
    const int *colour = useful ? useful_colour : dead_colour;

    for (int i = 0; i < 3; i++) {
        const int v = (int)(rgb >> (16 - 8 * i) & 255);
        out[i] = reachable ? v / 2 + colour[i] * 2 / 5 : v * 3 / 5;
    }
}

static void draw_ship(const struct reach_map *m, int x0, int y0)
{
    struct danger_ship ship;

    danger_get_ship(m->s->simulation.b, 0, &ship);
    if (!ship.in_game)
        return;
    const int x = x0 + (int)((int64_t)ship.path.x * m->scale / FX_ONE);
    const int y = y0 + (int)((int64_t)ship.path.y * m->scale / FX_ONE);
    for (int i = -5 * m->scale; i <= 5 * m->scale; i++) {
        if (abs(i) < 2 * m->scale)
            continue;
        set_pixel(m, x + i, y, 255, 255, 255);
        set_pixel(m, x, y + i, 255, 255, 255);
    }
}

static void add_picture(struct reach_map *m, uint32_t frame)
{
    const struct manifest *f = &m->cart->manifest;
    const int x0 = GAP + m->count % m->columns * (f->field_w * m->scale + GAP);
    const int y0 = GAP + LABEL + m->count / m->columns * (f->field_h * m->scale + GAP + LABEL);
    char text[32];
    int out[3] = { 0 };

    m->count++;
    board_draw(m->s->simulation.b, NULL, &m->fb, m->rgb, m->scratch);
    for (int y = 0; y < f->field_h * m->scale; y++)
        for (int x = 0; x < f->field_w * m->scale; x++) {
            if (x % m->scale == 0)
                tint(m, frame - m->s->search.begin, x / m->scale, y / m->scale, out);
            set_pixel(m, x0 + x, y0 + y, out[0], out[1], out[2]);
        }
    draw_ship(m, x0, y0);
    snprintf(text, sizeof text, "frame %u", (unsigned)frame);
    draw_label(m, x0, y0 - LABEL, text);
}

/* ---- a run ---- */

static void map_free(struct reach_map *m)
{
    reach_free(&m->reachable);
    reach_free(&m->useful);
    free(m->screen);
    free(m->scratch);
    free(m->sheet);
}

static bool map_open(struct reach_map *m, int n)
{
    struct section_run *s = m->s;
    int w, h;

    if (!simulation_restart(&s->simulation, s->err, sizeof s->err))
        return false;
    board_screen_size(s->simulation.b, &w, &h);
    m->screen = malloc(fb_size(w, h));
    m->scratch = malloc(board_scratch_size(s->simulation.b) + 1);
    if (!m->screen || !m->scratch || !sheet_open(m, n))
        return false;
    fb_init(&m->fb, m->screen, w, h);
    if (s->forecast.frames == 0)
        return true;
    if (!reach_compute(&m->reachable, &s->forecast, FX_ONE, 0, s->x, s->y) ||
        !reach_compute(&m->useful, &s->forecast, FX_ONE, 0, s->x, s->y))
        return false;
    reach_prune(&m->useful);
    return true;
}

/* Repeats the run, and draws the frames in `frame`, which are in ascending order. */
static void map_run(struct reach_map *m, const uint32_t *frame, int n)
{
    struct simulation *t = &m->s->simulation;
    const struct search *k = &m->s->search;
    int next = 0;

    for (uint32_t f = 0; next < n; f++) {
        for (; next < n && frame[next] == f; next++)
            add_picture(m, f);
        if (next == n || board_last_output(t->b)->fault)
            return;
        uint16_t pads[MAX_PLAYERS] = { 0 };
        pads[0] = f < k->frames ? k->pads[f] : simulation_can_steer(t) ? PAD_FIRE : simulation_menu_pads(t);
        if (f >= k->frames)
            danger_set_invincible(t->b, true);
        simulation_tick(t, pads);
    }
}

static uint8_t *make_png(struct section_run *s, const struct cart *cart, int scale, const uint32_t *frame, int n,
                         size_t *size)
{
    struct reach_map m = { .s = s, .cart = cart, .scale = scale };
    uint8_t *png = NULL;

    if (map_open(&m, n)) {
        map_run(&m, frame, n);
        draw_legend(&m);
        png_write_rgb(m.sheet, m.w, m.h, &png, size);
    }
    map_free(&m);
    return png;
}

uint8_t *map_sheet(struct section_run *s, const struct cart *cart, size_t *size)
{
    uint32_t frame[PICTURES];
    const uint32_t begin = s->search.begin, frames = s->forecast.frames;

    for (uint32_t i = 0; i < PICTURES; i++)
        frame[i] = begin + (uint32_t)((uint64_t)frames * (i + 1) / PICTURES);
    return make_png(s, cart, 1, frame, PICTURES, size);
}

uint8_t *map_last(struct section_run *s, const struct cart *cart, size_t *size)
{
    const uint32_t begin = s->search.begin;
    const uint32_t last =
        s->search.verdict == SEARCH_CANNOT && s->search.last > begin ? s->search.last - 1 : s->search.frames;
    const uint32_t first = last > begin + BEFORE ? last - BEFORE : begin;
    const uint32_t frame[3] = { first, last, last + 1 };

    return make_png(s, cart, LAST_SCALE, frame, 3, size);
}

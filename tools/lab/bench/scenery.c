/*
 * scenery.c - of section "pictures": what backgrounds cost, over the whole field of the sandbox, and what text, flashes
 * and shakes do.
 */
#include <stdlib.h>
#include "bench.h"

enum { ROUNDS = 200, VIEW_LAYERS = 3 };

/* Layers from the back: the names of their maps. */
static const struct landscape {
    const char *what, *map[VIEW_LAYERS], *plane;
    bool lines, blend;
} VIEWS[] = {
    { "no background; the field is cleared", { NULL, NULL, NULL }, NULL, false, false },
    { "a layer without holes", { "sea", NULL, NULL }, NULL, false, false },
    { "the same, each line shifted by a wave", { "sea", NULL, NULL }, NULL, true, false },
    { "a layer with holes", { "clouds", NULL, NULL }, NULL, false, false },
    { "the same, blended", { "clouds", NULL, NULL }, NULL, false, true },
    { "a plane that covers half of the field", { NULL, NULL, NULL }, "slabs", false, false },
    { "three layers with shifted lines, and a plane with fog", { "sea", "clouds", "clouds" }, "slabs", true, false },
};
enum { COUNT = sizeof VIEWS / sizeof *VIEWS };

/* A board of the sandbox. */
struct stand {
    struct rom_image image;
    struct board *b;
    struct fb fb;
    void *ram, *mem, *scratch;
};

static void stand_open(struct stand *s)
{
    struct board_start start = { .difficulty = -1, .practice.section = "try" };
    struct cart cart;
    char err[256];
    size_t size;
    int w, h;

    if (!pack_load_game("examples/sandbox", false, &s->image, err, sizeof err) ||
        !cart_open(&cart, &s->image.rom, err, sizeof err) || !board_size(&s->image.rom, &size, err, sizeof err))
        report_fail(err);
    for (int i = 0; i < cart.manifest.n_dips; i++)
        start.dip[i] = cart.manifest.dips[i].default_value;
    s->ram = aligned_alloc(64, (size + 63) / 64 * 64);
    if (!s->ram || !(s->b = board_power_on(s->ram, size, &s->image.rom, &start, err, sizeof err)))
        report_fail(s->ram ? err : "out of memory");
    board_screen_size(s->b, &w, &h);
    s->mem = malloc(fb_size(w, h));
    s->scratch = malloc(board_scratch_size(s->b));
    if (!s->mem || !s->scratch)
        report_fail("out of memory");
    fb_init(&s->fb, s->mem, w, h);
}

static uint16_t map_named(const struct board *b, const char *name)
{
    return (uint16_t)(name ? cart_find(&b->cart, CART_MAPS, name) + 1 : 0);
}

static void show(struct board *b, const struct landscape *v)
{
    struct bg *g = &b->bg;

    bg_clear(g, &b->bg_lines);
    for (int i = 0; i < VIEW_LAYERS; i++) {
        g->map[i] = map_named(b, v->map[i]);
        g->vx[i] = 9999 * (i + 1);
        g->vy[i] = 65536;
        g->wave_amplitude[i] = v->lines ? 5 << 16 : 0;
        g->wave_period[i] = 64 << 16;
        g->flags[i] |= v->blend ? BG_BLEND_ONE : 0;
    }
    g->map[BG_PLANE] = map_named(b, v->plane);
    g->horizon[BG_PLANE] = 160;
    g->height[BG_PLANE] = 24 << 16;
    if (v->lines && v->plane) {
        b->bg_shades.s.live = b->bg_shades.s.cap;
        bg_fill_shades(b->bg_shades.table + BG_FOG_OFFSET, cart_palette(&b->cart, "main"), 0x3c4c88);
        g->fog[BG_PLANE] = 0x3c4c88;
        g->fog_end[BG_PLANE] = 900 << 16;
    }
}

static void nothing(struct board *b)
{
    fix_clear(&b->fix, 0, 0, (int)b->fix.cols, (int)b->fix.rows);
    screen_reset(&b->screen);
    show(b, &VIEWS[0]);
}

enum { LETTERS = 100 };

static void write_rows(struct board *b, uint8_t bank)
{
    nothing(b);
    for (int row = 0; row < 4; row++)
        fix_write(&b->fix, 16, 8 * (1 + row), "QWERTYUIOPASDFGHJKLZXCVBN", LETTERS / 4, 1, FIX_CELL_SIZE, bank, 0);
}

static void letters(struct board *b)
{
    write_rows(b, 2);
}

static void rims(struct board *b)
{
    write_rows(b, 2 | FIX_RIM);
}

static void flash(struct board *b)
{
    nothing(b);
    b->screen.flash_colour = 0xffffff;
    b->screen.flash_frames = 60;
    b->screen.flash_share = FX_ONE;
    b->screen.flash_start = b->core.clock;
}

static void shaken(struct board *b)
{
    b->screen.shake = 8;
    b->screen.shake_frames = 60;
    b->screen.shake_start = b->core.clock - 1;
    b->screen.shake_aimed = 1;
    b->screen.shake_dir = 1 << 29;
}

static void bare_shaken(struct board *b)
{
    nothing(b);
    shaken(b);
}

static void layer_shaken(struct board *b)
{
    nothing(b);
    show(b, &VIEWS[1]);
    shaken(b);
}

static const struct look {
    const char *what;
    void (*set)(struct board *b);
} LOOKS[] = {
    { "nothing", nothing },
    { "100 letters in cells", letters },
    { "the same with outlines", rims },
    { "a flash", flash },
    { "a shake without a background, with mirrored edges", bare_shaken },
    { "a shake of a layer without holes", layer_shaken },
};
enum { LOOK_COUNT = sizeof LOOKS / sizeof *LOOKS };

static void look_prices(struct stand *s)
{
    struct samples draw[LOOK_COUNT] = { { 0 } };
    uint32_t rgb[256];

    for (int round = -2; round < ROUNDS; round++)
        for (int i = 0; i < LOOK_COUNT; i++) {
            LOOKS[i].set(s->b);
            double from = bench_now();
            board_draw(s->b, NULL, &s->fb, rgb, s->scratch);
            if (round >= 0)
                samples_add(&draw[i], bench_since(from));
        }
    report_text("The next table shows the same for a picture with text, a flash or a shake instead of a background.");
    report_table(NULL, "part | total> | difference>");
    for (int i = 0; i < LOOK_COUNT; i++)
        report_row(i == 0, LOOKS[i].what, samples_figure(&draw[i], 1e3),
                   i ? report_figure((samples_median(&draw[i]) - samples_median(&draw[0])) / 1e3) : "", NULL);
    report_table_end();
    for (int i = 0; i < LOOK_COUNT; i++)
        samples_free(&draw[i]);
}

void scenery_prices(void)
{
    struct samples draw[COUNT] = { { 0 } };
    uint32_t rgb[256];
    struct stand s;

    stand_open(&s);
    for (int round = -2; round < ROUNDS; round++)
        for (int i = 0; i < COUNT; i++) {
            show(s.b, &VIEWS[i]);
            for (int k = 0; k <= round % 8; k++)
                bg_step(&s.b->bg);
            double from = bench_now();
            board_draw(s.b, NULL, &s.fb, rgb, s.scratch);
            if (round >= 0)
                samples_add(&draw[i], bench_since(from));
        }
    report_text("The next table shows how many microseconds it takes to draw a picture with a background and little "
                "else, on a field of 240 x 320 px.");
    report_table(NULL, "background | total> | difference>");
    for (int i = 0; i < COUNT; i++)
        report_row(i == 0, VIEWS[i].what, samples_figure(&draw[i], 1e3),
                   i ? report_figure((samples_median(&draw[i]) - samples_median(&draw[0])) / 1e3) : "", NULL);
    report_table_end();
    for (int i = 0; i < COUNT; i++)
        samples_free(&draw[i]);
    look_prices(&s);
    free(s.scratch);
    free(s.mem);
    free(s.ram);
    rom_image_free(&s.image);
}

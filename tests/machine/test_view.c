/*
 * test_view.c - how a player sees the picture. By every view: a run is what it is, each way of drawing makes the same
 * picture, a dim darkens what lies behind and nothing else, a soft flash is a quarter, colours are
 * view_adjust_colour's.
 */
#include "../../src/machine/video/video.h"
#include "../../src/player/picture/shade.h"
#include "rig.h"

static struct shade_cache kept;

struct picture {
    int w, h;
    uint8_t pix[640 * 480];
    uint32_t rgb[256];
};

/* Draws over rubbish. */
static void draw(struct rig *r, const struct view *view, struct picture *out)
{
    memset(r->fb.pix, 0xa5, (size_t)r->fb.pitch * (size_t)(r->fb.h - 1) + (size_t)r->fb.w);
    memset(r->scratch, 0x5a, board_scratch_size(r->b));
    board_draw(r->b, view, &r->fb, out->rgb, r->scratch);
    out->w = r->fb.w;
    out->h = r->fb.h;
    assert_true(out->w * out->h <= (int)sizeof out->pix);
    for (int y = 0; y < out->h; y++)
        memcpy(out->pix + y * out->w, r->fb.pix + y * r->fb.pitch, (size_t)out->w);
}

static void same(const char *of, const struct rig *r, const struct picture *a, const struct picture *b)
{
    const size_t n = (size_t)(a->w * a->h);

    if (memcmp(a->rgb, b->rgb, sizeof a->rgb) != 0)
        fail_msg("frame %u: %s: other colours", board_frame(r->b), of);
    for (size_t i = 0; i < n; i++)
        if (a->pix[i] != b->pix[i])
            fail_msg("frame %u: %s: pixel %d, %d is %d, expected %d", board_frame(r->b), of, (int)i % a->w,
                     (int)i / a->w, b->pix[i], a->pix[i]);
}

/* ---- what a view leaves as it is, and what it does to colours ---- */

/* The colours of a view, from those of the same picture with as soft a flash: the text's dim moves entries, so by
 * pixel. */
static void coloured(const struct rig *r, const struct picture *plain, const struct picture *p,
                     enum colour_blind_mode kind)
{
    for (int i = 0; i < p->w * p->h; i++)
        if (p->rgb[p->pix[i]] != view_adjust_colour(kind, plain->rgb[plain->pix[i]]))
            fail_msg("frame %u: colours %d: pixel %d, %d", board_frame(r->b), kind, i % p->w, i / p->w);
}

/* By each view, and with none, which is the plain one. */
static void all_views(struct rig *r)
{
    static struct picture plain, ever;
    const uint8_t *shades = shade_get_tables(&kept, &r->game->cart);
    const uint64_t before = hash_bytes(HASH_START, r->ram, r->ram_size);

    draw(r, NULL, &plain);
    for (int i = 0; i < RIG_VIEWS; i++) {
        const struct view view = rig_view(i, shades), was = view;
        draw(r, &view, &ever);
        if (i == 0)
            same("a view of zeroes", r, &plain, &ever);
        if (!view.dim && !view.softens_flashes)
            coloured(r, &plain, &ever, view.colour_blind_mode);
        assert_memory_equal(&view, &was, sizeof view);
    }
    assert_true(hash_bytes(HASH_START, r->ram, r->ram_size) == before); /* not a byte of RAM */
}

/* ---- what a dim darkens ---- */

static long covered, behind, mixed;

/* Where the table of shades of the palette that is loaded stands. */
static const uint8_t **shades_at(struct board *b)
{
    return b->cart.has_palette_tables ? &b->cart.palette_tables[board_loaded_palette(b)].shades
                                      : &b->cart.main_tables.shades;
}

/* What covers the background is what is the same whatever that is shown as. There the dim changes nothing, else it
 * shows the table's entry; but for what is mixed with what is behind, of which a game with blends has a little. */
static void dims(struct rig *r)
{
    static struct picture plain, a, b, dimmed;
    static uint8_t one[CART_SHADES_SIZE], other[CART_SHADES_SIZE];
    const struct manifest *m = &r->b->cart.manifest;
    const uint8_t **at = shades_at(r->b), *made = *at, *shades = made ? made : shade_get_tables(&kept, &r->game->cart);
    struct view view = { .dim = VIEW_DIM_QUARTER, .shades = one };

    if (screen_get_dim(&r->b->screen, r->b->core.frame)) /* it moves entries */
        return;
    memset(one, 0x30, sizeof one); /* the ends of two ramps: few blends show both as one */
    memset(other, 0xcf, sizeof other);
    draw(r, NULL, &plain);
    *at = one;
    draw(r, &view, &a);
    *at = other;
    draw(r, &view, &b);
    *at = made;
    for (int dim = VIEW_DIM_QUARTER; dim < VIEW_DIMS; dim++) {
        view = (struct view){ .dim = (enum view_dim)dim, .shades = shades };
        draw(r, &view, &dimmed);
        assert_memory_equal(dimmed.rgb, plain.rgb, sizeof plain.rgb);
        for (int i = 0; i < plain.w * plain.h; i++) {
            const int x = i % plain.w - m->field_x, y = i / plain.w - m->field_y;
            const bool in = x >= 0 && y >= 0 && x < m->field_w && y < m->field_h, over = a.pix[i] == b.pix[i];
            const uint8_t want = over ? plain.pix[i] : shades[(dim - 1) * 256 + plain.pix[i]];
            if (dimmed.pix[i] != want && (!in || !r->b->cart.count[CART_BLENDS]))
                fail_msg("frame %u: dim %d: pixel %d, %d, which %s, is %d, expected %d", board_frame(r->b), dim, x, y,
                         over ? "covers" : "lies behind", dimmed.pix[i], want);
            mixed += dimmed.pix[i] != want;
            covered += over && in;
            behind += !over;
        }
    }
}

/* ---- on games ---- */

static void play(const char *name, const char *section, const char *demo, uint32_t frames, uint32_t every)
{
    struct board_start start = { .seed = 1, .difficulty = -1 };
    struct rig_game g;
    struct rig r, alone;
    struct demo d = { 0 };
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };
    uint8_t made[CART_SHADES_SIZE];

    rig_folder(&g, name);
    shade_make(cart_palette(&g.cart, "main"), made);
    assert_non_null(g.cart.main_tables.shades); /* what is packed has them */
    assert_memory_equal(g.cart.main_tables.shades, made, CART_SHADES_SIZE);
    if (section)
        snprintf(start.practice.section, sizeof start.practice.section, "%s", section);
    for (int i = 0; i < g.cart.manifest.n_dips; i++)
        start.dip[i] = g.cart.manifest.dips[i].default_value;
    if (demo)
        assert_true(rig_demo(&g, demo, &d));
    rig_power(&r, &g, demo ? &d.start : &start);
    rig_power(&alone, &g, demo ? &d.start : &start);
    rng_seed(&rng, 4);
    for (uint32_t f = 0; f < frames; f++) {
        if (demo)
            demo_pads(&d, f, pads);
        else if (strcmp(name, "cookbook") != 0) /* there a press goes to another recipe */
            rig_pads(&rng, pads);
        rig_tick(&r, pads);
        rig_tick(&alone, pads);
        if (f % every == every - 1) {
            all_views(&r);
            dims(&r);
        }
    }
    assert_true(board_hash(r.b) == board_hash(alone.b)); /* which nobody looked at */
    rig_free(&r);
    rig_free(&alone);
    demo_free(&d);
    rig_game_free(&g);
}

TEST(games)
{
    const uint32_t often = rig_long() ? 5 : 1;

    play("testcard", NULL, NULL, 600, 75 / often);
    play("torture", NULL, "torture", 1000, 125 / often);
    play("glasstide", NULL, "attract", 2400, 200 / often);
    play("glasstide", "queen/flower", NULL, 400, 50 / often);
    play("glasstide", "one:deep", NULL, 300, 50 / often);
    play("cookbook", "blast", NULL, 340, 7);
    play("cookbook", "bomb", NULL, 300, 20 / often);
    play("examples/sandbox", "scenes", NULL, 420, 35 / often);
    play("examples/sandbox", "glow", NULL, 300, 50 / often);
    assert_true(covered > 1000000 && behind > 1000000 && mixed < behind / 10);
}

/* ---- on one of everything ---- */

static const char things[] = "bullet.def('orb', { sprite = 'arrow', hit = { circle = 4 } })\n"
                             "shot.def('shot', { sprite = 'arrow', hit = { circle = 4 } })\n"
                             "enemy.def('fly', { sprite = 'arrow', hit = { circle = 4 }, hp = 5 })\n"
                             "item.def('rock', { sprite = 'arrow', radius = 5, magnet = false, gravity = 0 })\n"
                             "spark.def('fire', { sprite = 'arrow', life = 99 })\n"
                             "option.def('bead', { sprite = 'arrow', layer = 'back' })\n"
                             "player.def('ship', { sprite = 'arrow', hit = { circle = 2 }, safe = 0,\n"
                             "  options = { kind = 'bead', over = 0, levels = { { wide = { { 40, 0 } } } } } })\n"
                             "bg.layer(1).map = 'reef'\n"
                             "task.go(function()\n"
                             "  string.sys.join(1, 'ship')\n"
                             "  player.get(1).x, player.get(1).y = 60, 280\n"
                             "  bullet.fire { kind = 'orb', x = 40, y = 40, dir = 90, speed = 0 }\n"
                             "  shot.fire { kind = 'shot', x = 80, y = 40, dir = 90, speed = 0 }\n"
                             "  enemy.spawn { kind = 'fly', x = 120, y = 40 }\n"
                             "  item.drop { kind = 'rock', x = 160, y = 40 }\n"
                             "  spark.burst { kind = 'fire', x = 200, y = 40, speed = 0 }\n"
                             "  sprite.put { sprite = 'arrow', x = 40, y = 100, layer = 'middle' }\n"
                             "  sprite.put { sprite = 'arrow', x = 80, y = 100, layer = 'front' }\n"
                             "  sprite.put { sprite = 'arrow', x = 120, y = 100, layer = 'over' }\n"
                             "  sprite.put { sprite = 'arrow', x = 160, y = 100, layer = 'back' }\n"
                             "  text.put { col = 25, row = 12, text = 'AB' }\n"
                             "  wait(2)\n"
                             "  screen.flash { to = 0xffffff, over = 10, share = 0.8 }\n"
                             "  wait(12)\n"
                             "  screen.shake { size = 9, over = 40, dir = 0 }\n"
                             "end)\n";

static void things_power(struct rig_game *g, struct rig *r)
{
    struct manifest m = rig_manifest();

    m.has_backgrounds = 1;
    m.items = 8;
    m.options = 8;
    rig_with_sys(g, &m, things);
    rig_maps(g);
    rig_power(r, g, NULL);
}

/* Pixels of the 16 x 16 round (x, y) that a table shows another way. */
static int shaded(struct rig *r, const struct picture *plain, int x, int y)
{
    static uint8_t flipped[CART_SHADES_SIZE];
    const struct view view = { .dim = VIEW_DIM_MOST, .shades = flipped };
    static struct picture p;
    int n = 0;

    for (int i = 0; i < CART_SHADES_SIZE; i++)
        flipped[i] = (uint8_t)(255 - i);
    draw(r, &view, &p);
    for (int i = 0; i < 256; i++) {
        const int at = (y - 8 + i / 16) * p.w + x - 8 + i % 16;
        assert_true(p.pix[at] == plain->pix[at] || p.pix[at] + plain->pix[at] == 255);
        n += p.pix[at] != plain->pix[at];
    }
    return n;
}

/* Of what matters the picture covers all that its opaque pixels cover; a sprite at the back lies behind. A ROM without
 * tables is dimmed by those of the view, and not at all by a view without. */
TEST(matters)
{
    static const struct {
        int x, y;
    } over[] = { { 40, 40 },  { 80, 40 },   { 120, 40 }, { 200, 40 }, { 40, 100 },
                 { 80, 100 }, { 120, 100 }, { 60, 280 }, { 100, 280 } };
    static struct picture plain, dimmed;
    struct rig_game g;
    struct rig r;
    int holes = 0;

    things_power(&g, &r);
    rig_run(&r, 2);
    assert_int_equal(r.b->options.s.live, 1);
    draw(&r, NULL, &plain);
    assert_null(g.cart.main_tables.shades);
    draw(&r, &(struct view){ .dim = VIEW_DIM_MOST }, &dimmed);
    same("no tables", &r, &plain, &dimmed);
    const struct sprite *arrow = &r.b->sprite_images[cart_find(&g.cart, CART_SPRITES, "arrow")];
    for (int i = 0; i < 256; i++)
        holes += !arrow->pix[i];
    assert_true(holes > 20 && holes < 80);
    for (size_t i = 0; i < sizeof over / sizeof *over; i++)
        if (shaded(&r, &plain, over[i].x, over[i].y) != holes)
            fail_msg("at %d, %d: %d pixels are shaded, expected %d", over[i].x, over[i].y,
                     shaded(&r, &plain, over[i].x, over[i].y), holes);
    const struct items *s = &r.b->items; /* what was dropped rises */
    assert_int_equal(shaded(&r, &plain, fx_floor(s->x[0]), fx_floor(s->y[0])), holes);
    assert_int_equal(shaded(&r, &plain, 160, 100), 256);   /* at the back */
    assert_int_equal(shaded(&r, &plain, 200, 200), 256);   /* nothing but background */
    assert_in_range(shaded(&r, &plain, 208, 100), 1, 255); /* letters */
    all_views(&r);
    dims(&r);
    rig_run(&r, 14);
    assert_true(r.b->screen.shake_frames);
    all_views(&r);
    dims(&r);
    rig_close(&r);
}

/* Without the HUD, the picture is as if the game had put neither text nor sprites on the screen. */
TEST(hidden_hud)
{
    static const char *const scripts[] = {
        "sprite.put { sprite = 'dot', x = 9, y = 9 }",
        "sprite.put { sprite = 'dot', x = 9, y = 9 } text.put { col = 1, row = 1, text = 'WORDS' }\n"
        "sprite.put { sprite = 'dot', x = 40, y = 40, screen = true }",
    };
    static struct picture p[2][2]; /* [of a script][without the HUD] */

    for (int i = 0; i < 2; i++) {
        struct rig_game g;
        struct rig r;
        rig_script(&g, NULL, scripts[i]);
        rig_power(&r, &g, NULL);
        rig_run(&r, 2);
        draw(&r, NULL, &p[i][0]);
        draw(&r, &(struct view){ .hides_hud = true }, &p[i][1]);
        if (i == 1)
            same("a hidden HUD", &r, &p[0][0], &p[1][1]);
        rig_close(&r);
    }
    assert_memory_not_equal(p[0][0].pix, p[1][0].pix, (size_t)(p[0][0].w * p[0][0].h));
}

/* A soft flash is a quarter of its share in each frame, of all colours. */
TEST(flash)
{
    const struct view soft = { .softens_flashes = true };
    static struct picture full, p;
    struct rig_game g;
    struct rig r;
    int flashed = 0;

    things_power(&g, &r);
    for (int f = 0; f < 16; f++) {
        rig_run(&r, 1);
        const fx share = screen_get_flash(&r.b->screen, r.b->core.clock);
        draw(&r, NULL, &full);
        draw(&r, &soft, &p);
        assert_memory_equal(p.pix, full.pix, (size_t)(p.w * p.h));
        for (int i = 0; i < 256; i++) {
            assert_int_equal(full.rgb[i], pal_mix(r.b->pal.rgb[i], 0xffffff, share, FX_ONE));
            assert_int_equal(p.rgb[i], pal_mix(r.b->pal.rgb[i], 0xffffff, share / 4, FX_ONE));
        }
        flashed += share > 0;
    }
    assert_int_equal(flashed, 10);
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)

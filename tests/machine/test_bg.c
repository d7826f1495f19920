/*
 * test_bg.c - backgrounds against a plain program that asks for each pixel of the field which pixel of which map is
 * there, plain and as a view dims them; their motion; fades. tests/scripts/bg.lua tests what scripts are told.
 */
#include "../../fb/row.h"
#include "../../src/machine/video/video.h"
#include "rig.h"

static struct rng rng;
static struct rig_game game;
static struct rig r;

static int64_t within(int64_t lo, int64_t hi)
{
    return lo + (int64_t)rng_below(&rng, (uint64_t)(hi - lo + 1));
}

static int64_t any_of(const int64_t *list, int n)
{
    return list[rng_below(&rng, (uint64_t)n)];
}

/* ---- the plain program ---- */

static int64_t floor_div(int64_t a, int64_t n)
{
    int64_t q = a / n;

    return q - (a % n != 0 && (a < 0) != (n < 0));
}

static int64_t rest_of(int64_t a, int64_t n)
{
    return a - floor_div(a, n) * n;
}

static uint8_t map_pixel(const struct map *m, int64_t x, int64_t y)
{
    const int64_t cell = y / m->tile_side * m->cols + x / m->tile_side;
    const int64_t tile = m->cells[2 * cell] | m->cells[2 * cell + 1] << 8;

    return m->pix[tile * m->tile_side * m->tile_side + y % m->tile_side * m->tile_side + x % m->tile_side];
}

static const uint8_t *shade; /* of the view: what it shows for each entry; NULL: it dims nothing */

static uint8_t put_over(const struct board *b, uint32_t i, uint8_t under, uint8_t pixel, const uint8_t *to)
{
    const int blend = (b->bg.flags[i] & BG_BLEND) / BG_BLEND_ONE;
    uint8_t over = (uint8_t)(pixel + 16 * b->bg.bank[i]);

    if (!pixel)
        return under;
    over = to ? to[over] : over;
    over = shade && b->bg.flags[i] & BG_FRONT ? shade[over] : over;
    return blend ? b->cart.main_tables.blend[blend - 1][under * 256 + over] : over;
}

static const uint8_t *black(const struct board *b)
{
    return bg_darkness(&b->bg) ? b->bg_shades.table + BG_BLACK_OFFSET + 256 * (bg_darkness(&b->bg) - 1) : NULL;
}

static uint8_t layer_pixel(const struct board *b, uint32_t i, int x, int y, uint8_t under)
{
    const struct bg *g = &b->bg;
    struct map m;

    cart_map(&b->cart, g->map[i] - 1, &m);
    const int line = y < 0                          ? 0
                     : y < b->cart.manifest.field_h ? y
                                                    : b->cart.manifest.field_h - 1; /* a shake shows more */
    int64_t mx = x - floor_div(g->x[i] + bg_line_offset(g, &b->bg_lines, i, line), 65536);
    int64_t my = y - floor_div(g->y[i], 65536);
    if (g->flags[i] & BG_WRAP) {
        mx = rest_of(mx, m.cols * m.tile_side);
        my = rest_of(my, m.rows * m.tile_side);
    } else if (mx < 0 || my < 0 || mx >= m.cols * m.tile_side || my >= m.rows * m.tile_side)
        return under;
    return put_over(b, i, under, map_pixel(&m, mx, my), black(b));
}

/* In Q32, each column from the row's first by a product, not by steps. */
static uint8_t plane_pixel(const struct board *b, int x, int y, uint8_t under)
{
    const struct bg *g = &b->bg;
    const int64_t w = b->screen.shows_whole ? b->cart.manifest.screen_w : b->cart.manifest.field_w;
    const int64_t away =
        g->flags[BG_PLANE] & BG_CEILING ? 2 * (g->horizon[BG_PLANE] - y) - 1 : 2 * (y - g->horizon[BG_PLANE]) + 1;
    uint8_t both[256];
    const uint8_t *to = black(b);
    struct map m;

    if (away <= 0)
        return under;
    cart_map(&b->cart, g->map[BG_PLANE] - 1, &m);
    int64_t s = (4 * (int64_t)g->height[BG_PLANE] + away) / (2 * away);
    int64_t ax = floor_div(s * trig_cos30(g->dir[BG_PLANE]), 1 << 14);
    int64_t ay = floor_div(s * trig_sin30(g->dir[BG_PLANE]), 1 << 14);
    int64_t mw = (int64_t)m.cols * m.tile_side, mh = (int64_t)m.rows * m.tile_side;
    int64_t u = rest_of(g->x[BG_PLANE], mw << 16) * 65536 + w * ax - (1 - w) * ay / 2 - x * ay;
    int64_t v = rest_of(g->y[BG_PLANE], mh << 16) * 65536 + w * ay + (1 - w) * ax / 2 + x * ax;
    if (g->fog[BG_PLANE] != BG_NO_FOG) {
        int64_t k = s * w * BG_SHADES / g->fog_end[BG_PLANE];
        k = k > BG_SHADES ? BG_SHADES : k;
        for (int i = 0; i < 256; i++) {
            uint8_t fogged = k ? b->bg_shades.table[BG_FOG_OFFSET + (k - 1) * 256 + i] : (uint8_t)i;
            both[i] = to ? to[fogged] : fogged;
        }
        to = both;
    }
    uint8_t pixel = map_pixel(&m, floor_div(rest_of(u, mw << 32), (int64_t)1 << 32),
                              floor_div(rest_of(v, mh << 32), (int64_t)1 << 32));
    return put_over(b, BG_PLANE, under, pixel, to);
}

static bool seen(const struct bg *g, uint32_t i, bool front)
{
    return g->map[i] && !(g->flags[i] & BG_HIDDEN) && front == !!(g->flags[i] & BG_FRONT);
}

static uint8_t plain_pixel(const struct board *b, int x, int y)
{
    static const uint32_t order[BG_SLOTS] = { 0, BG_PLANE, 1, 2, 3 };
    uint8_t c = 0;

    for (int front = 0; front < 2; front++) {
        c = front && shade ? shade[c] : c; /* all that lies behind */
        for (int k = 0; k < BG_SLOTS; k++) {
            if (!seen(&b->bg, order[k], front))
                continue;
            c = order[k] == BG_PLANE ? plane_pixel(b, x, y, c) : layer_pixel(b, order[k], x, y, c);
        }
    }
    return c;
}

/* Draws over rubbish and compares every pixel of the screen; in the field or, if the field's picture fills the screen,
 * everywhere, with those that a shake moved there. */
static void compare(int round)
{
    const struct manifest *m = &r.b->cart.manifest;
    uint8_t shades[CART_SHADES_SIZE];
    const struct view view = { .dim = (enum view_dim)within(0, VIEW_DIM_MOST), .shades = shades };
    uint32_t rgb[256];
    int dx, dy;

    for (int i = 0; i < CART_SHADES_SIZE; i++)
        shades[i] = (uint8_t)rng_next(&rng);
    shade = view.dim ? shades + (view.dim - 1) * 256 : NULL;

    screen_get_shake(&r.b->screen, r.b->core.clock, &dx, &dy);
    memset(r.fb.pix, 0xa5, (size_t)r.fb.pitch * (size_t)(r.fb.h - 1) + (size_t)r.fb.w);
    board_draw(r.b, &view, &r.fb, rgb, r.scratch);
    for (int y = 0; y < m->screen_h; y++)
        for (int x = 0; x < m->screen_w; x++) {
            const bool whole = r.b->screen.shows_whole;
            const int fx_ = whole ? x : x - m->field_x, fy = whole ? y : y - m->field_y;
            const bool in = whole || (fx_ >= 0 && fy >= 0 && fx_ < m->field_w && fy < m->field_h);
            const uint8_t want = in ? plain_pixel(r.b, fx_ - dx, fy - dy) : 0, got = r.fb.pix[y * r.fb.pitch + x];
            if (got != want)
                fail_msg("round %d: pixel %d, %d is %d, expected %d", round, x, y, got, want);
        }
}

static int end(void **state __attribute__((unused)))
{
    rig_close(&r);
    return 0;
}

/* A small field. */
static void power(const char *text)
{
    struct manifest m = rig_manifest();

    m.has_backgrounds = 1;
    m.screen_w = 96;
    m.screen_h = 70;
    m.field_x = 9;
    m.field_y = 5;
    m.field_w = 75;
    m.field_h = 61;
    rig_script(&game, &m, text);
    rig_blends(&game);
    rig_maps(&game);
    rig_power(&r, &game, NULL);
}

/* A game that is practised from there. */
static void practise(const char *text, const char *section)
{
    struct board_start start = { .difficulty = -1 };
    struct manifest m = rig_manifest();

    m.has_backgrounds = 1;
    snprintf(start.practice.section, sizeof start.practice.section, "%s", section);
    rig_script(&game, &m, text);
    rig_maps(&game);
    rig_power(&r, &game, &start);
}

/* ---- drawing ---- */

static void random_layer(struct board *b, uint32_t i)
{
    static const int64_t places[] = { 0, -1, 1, INT64_MAX / 2, INT64_MIN / 2, 65535, -65536, 75 * 65536, -80 * 65536 };
    static const int64_t waves[] = { 0, 0, 65536, 7 * 65536 + 9, -1024 * 65536, 1024 * 65536 };
    struct bg *g = &b->bg;
    fx list[61];

    g->map[i] = (uint16_t)within(0, 2);
    g->flags[i] = (uint8_t)((within(0, 3) ? BG_WRAP : 0) | (within(0, 4) ? 0 : BG_HIDDEN) |
                            (within(0, 3) ? 0 : BG_FRONT) | (within(0, 2) ? 0 : within(1, 2) * BG_BLEND_ONE));
    g->bank[i] = (uint8_t)(within(0, 1) ? 0 : within(0, 15));
    g->x[i] = within(0, 1) ? within(-99 * 65536, 99 * 65536) : any_of(places, 9);
    g->y[i] = within(0, 1) ? within(-99 * 65536, 99 * 65536) : any_of(places, 9);
    g->wave_amplitude[i] = (fx)any_of(waves, 6);
    g->wave_period[i] = (fx)(within(0, 1) ? within(65536, 99 * 65536) : 65536);
    g->phase[i] = within(0, 1) ? within(-999999, 999999) : any_of(places, 9);
    int n = within(0, 2) ? 0 : (int)within(1, 61);
    for (int k = 0; k < n; k++)
        list[k] = (fx)(within(0, 3) ? within(-50 * 65536, 50 * 65536) : within(0, 1) ? FX_MAX / 2 : -FX_MAX / 2);
    bg_set_lines(g, &b->bg_lines, i, list, (uint32_t)n);
}

static void random_plane(struct board *b)
{
    struct bg *g = &b->bg;

    random_layer(b, BG_PLANE - 1); /* for its list: a layer's */
    g->map[BG_PLANE] = (uint16_t)within(0, 2);
    g->flags[BG_PLANE] = (uint8_t)((within(0, 1) ? BG_CEILING : 0) | (within(0, 3) ? 0 : BG_FRONT));
    g->bank[BG_PLANE] = (uint8_t)within(0, 3);
    g->x[BG_PLANE] = within(0, 2) ? within(-9999 * 65536, 9999 * 65536) : INT64_MIN / 2;
    g->y[BG_PLANE] = within(0, 2) ? within(-9999 * 65536, 9999 * 65536) : INT64_MAX / 2;
    g->horizon[BG_PLANE] = (int16_t)(within(0, 3) ? within(-9, 70) : within(0, 1) ? -1024 : 1024);
    g->height[BG_PLANE] = (fx)(within(0, 1) ? within(65536, 99 * 65536) : within(0, 1) ? 65536 : 1024 * 65536);
    g->dir[BG_PLANE] = (ang)(within(0, 2) ? (uint32_t)rng_next(&rng) : (uint32_t)within(0, 3) << 30);
    g->fog[BG_PLANE] = within(0, 1) ? BG_NO_FOG : 0x123456;
    g->fog_end[BG_PLANE] = (fx)within(65536, 900 * 65536);
}

/* Where a background is open, its edge is mirrored: test_screen.c. */
static void random_shake(struct board *b)
{
    screen_reset(&b->screen);
    if (!video_bg_covers(b))
        return;
    b->screen.shake = (int32_t)within(0, MAX_SHAKE);
    b->screen.shake_frames = 1;
    b->screen.shake_start = b->core.clock - 1;
    b->screen.shake_aimed = 1;
    b->screen.shake_dir = (ang)rng_next(&rng);
}

/* Layers, plane, fog and fades at random, and with extremes: the picture is the plain program's. */
TEST(plain)
{
    int covered = 0;

    power("bg.plane().fog = { to = 0x123456, far = 9 }");
    bg_fill_shades(r.b->bg_shades.table + BG_BLACK_OFFSET, cart_palette(&r.b->cart, "main"), 0);
    rng_seed(&rng, 77);
    for (int round = 0; round < 400; round++) {
        for (uint32_t i = 0; i < BG_LAYERS; i++)
            random_layer(r.b, i);
        random_plane(r.b);
        r.b->bg.fade_length[0] = (uint16_t)(within(0, 2) ? 0 : within(1, 65535));
        r.b->bg.fade_elapsed[0] = (uint16_t)(r.b->bg.fade_length[0] ? within(0, r.b->bg.fade_length[0] - 1) : 0);
        covered += video_bg_covers(r.b);
        random_shake(r.b);
        r.b->screen.shows_whole = within(0, 3) == 0;
        compare(round);
    }
    assert_true(covered > 20 && covered < 380);
}

/* Pixels of every value, which maps of a game have not. */
TEST(rows)
{
    uint8_t s[80], d[80], want[80], to[256], *table = malloc(65536);

    rng_seed(&rng, 5);
    for (int i = 0; i < 65536; i++)
        table[i] = (uint8_t)rng_next(&rng);
    memcpy(to, table, 256);
    for (int round = 0; round < 3000; round++) {
        const int n = (int)within(0, 70), how = (int)within(0, 4);
        const uint8_t add = (uint8_t)(within(0, 1) ? 0 : rng_next(&rng));
        for (int i = 0; i < 80; i++) {
            s[i] = (uint8_t)(how && within(0, 2) == 0 ? 0 : within(1, 255));
            d[i] = want[i] = (uint8_t)rng_next(&rng);
        }
        for (int i = 0; i < n; i++) {
            uint8_t over = (uint8_t)(s[i] + add);
            over = how == 2 || how == 4 ? to[over] : over;
            if (s[i] || how == 0)
                want[i] = how >= 3 ? table[d[i] * 256 + over] : over;
        }
        if (how == 0)
            row_copy(d, s, n, add);
        else if (how == 1)
            row_cover(d, s, n, add);
        else
            row_mix(d, s, n, add, how == 2 || how == 4 ? to : NULL, how >= 3 ? table : NULL);
        assert_memory_equal(d, want, sizeof d);
    }
    free(table);
}

/* The nearest colour, of equals the lowest; the last table shows one colour alone. */
TEST(shades)
{
    static uint8_t tables[BG_SHADES * 256], rgb[768];

    rng_seed(&rng, 9);
    for (int i = 0; i < 768; i++)
        rgb[i] = (uint8_t)rng_next(&rng);
    memset(rgb + 3 * 40, 0, 3);
    memset(rgb + 3 * 90, 0, 3);
    bg_fill_shades(tables, rgb, 0);
    for (int i = 0; i < 256; i++)
        assert_int_equal(tables[(BG_SHADES - 1) * 256 + i], 40);
    for (int k = 0; k < BG_SHADES; k++)
        for (int i = 0; i < 256; i += 5) {
            double best = 1e9, got = 0;
            for (int j = 0; j < 256; j++) {
                double off = 0;
                for (int c = 0; c < 3; c++) {
                    double d = rgb[3 * j + c] - rgb[3 * i + c] * (15 - k) / 16.0;
                    off += d * d;
                }
                best = off < best ? off : best;
                got = j == tables[k * 256 + i] ? off : got;
            }
            assert_true(got == best);
        }
}

/* ---- motion ---- */

/* Positions add up exactly, also beyond the world; a frozen board does not move them. */
TEST(motion)
{
    power("local a, p = bg.layer(1), bg.plane()\n"
          "a.map, a.x, a.vx, a.vy = 'sea', 100, 0.3, -8191\n"
          "p.y, p.vy = -5, 0.5\n"
          "bg.lines(1, { wave = 8, every = 32, speed = 1.25 })");
    const struct bg *b = &r.b->bg;
    rig_run(&r, 1000);
    assert_true(b->x[0] == 100 * 65536 + 1000 * 19661); /* 0.3 in 1/65536 */
    assert_true(b->y[0] == -(int64_t)8191000 * 65536);
    assert_true(b->phase[0] == 1250 * 65536);
    assert_true(b->y[BG_PLANE] == 495 * 65536);
    compare(0);
    r.b->core.frozen = 77;
    rig_run(&r, 1);
    assert_true(b->x[0] == 100 * 65536 + 1000 * 19661);
}

TEST(wave)
{
    const fx list[] = { 65536, -65536, 3 };

    power("bg.lines(2, { wave = 8, every = 32 })");
    struct bg *b = &r.b->bg;
    struct bg_lines *lines = &r.b->bg_lines;
    assert_int_equal(bg_line_offset(b, lines, 1, 0), 0);
    assert_int_equal(bg_line_offset(b, lines, 1, 8), 8 * 65536);
    assert_int_equal(bg_line_offset(b, lines, 1, 40), 8 * 65536);
    assert_int_equal(bg_line_offset(b, lines, 1, 24), -8 * 65536);
    b->phase[1] = -8 * 65536;
    assert_int_equal(bg_line_offset(b, lines, 1, 0), 8 * 65536);
    bg_set_lines(b, lines, 1, list, 3); /* which repeats, and is added */
    assert_int_equal(bg_line_offset(b, lines, 1, 1) - bg_line_offset(b, lines, 1, 33), list[1] - list[0]);
}

/* ---- bg.def, bg.show ---- */

TEST(show)
{

    power("bg.def('day', function()\n"
          "  bg.layer(1).map = 'sea'\n"
          "  for i = 1, forever do bg.layer(1).x = i wait(1) end\n"
          "end)\n"
          "bg.def('night', function() bg.layer(2).map = 'reef' end)\n"
          "task.go(function()\n"
          "  bg.show('day', { over = 0 }) wait(10)\n"
          "  bg.show('night', { over = 20 }) wait(100)\n"
          "  bg.show(nil, { over = 4 })\n"
          "end)");
    rig_run(&r, 1);
    assert_int_equal(r.b->bg.shown_id[0], 1);
    assert_int_equal(r.b->bg.map[0], cart_find(&r.b->cart, CART_MAPS, "sea") + 1);
    rig_run(&r, 10);
    assert_int_equal(bg_darkness(&r.b->bg), 1);
    rig_run(&r, 9);
    assert_int_equal(r.b->bg.shown_id[0], 1);
    assert_int_equal(bg_darkness(&r.b->bg), BG_SHADES);
    assert_true(r.b->bg.x[0] > 17 * 65536); /* its task went on up to here */
    rig_run(&r, 1);
    assert_int_equal(r.b->bg.shown_id[0], 2);
    assert_int_equal(r.b->bg.map[0], 0);
    assert_true(r.b->bg.x[0] == 0 && r.b->bg.map[1] != 0);
    rig_run(&r, 9);
    assert_int_equal(bg_darkness(&r.b->bg), 0);
    assert_true(r.b->bg.x[0] == 0); /* the task of the other has ended */
    rig_run(&r, 90);
    assert_int_equal(r.b->bg.shown_id[0], 0);
    assert_int_equal(r.b->bg.map[1], 0);
}

/* A phase has its background, and the one before is shown again after it. A mark keeps what the stage has set up. */
TEST(phase)
{
    practise("bg.def('day', function() bg.layer(1).map = 'sea' end)\n"
             "bg.def('dusk', function() bg.layer(1).map = 'reef' end)\n"
             "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9 })\n"
             "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
             "boss.def('b', { title = 'B', kind = 'foe', x = 30, y = 30, phases = {\n"
             "  { id = 'one', survive = true, time = 50, bg = 'dusk', run = function() wait(forever) end } } })\n"
             "stage.def('s', function()\n"
             "  bg.show('day') wait(20)\n"
             "  stage.mark('m')\n"
             "  boss.fight('b') wait(60)\n"
             "end)\n"
             "boot.run { stages = { 's' }, players = { 'ship' } }",
             "s:m");
    rig_run(&r, 2);
    assert_int_equal(r.b->bg.shown_id[0], 1); /* at once: the stage was skipped to its mark */
    assert_int_equal(bg_darkness(&r.b->bg), 0);
    rig_run(&r, 60 + 20); /* the boss flies in */
    assert_int_equal(r.b->bg.shown_id[0], 2);
    rig_run(&r, 50);
    assert_int_equal(r.b->bg.shown_id[0], 1);
}

/* What a run shows from a mark on, practice of that mark shows: the background is there before the next line, what
 * faded before has faded, and what the next lines begin is not lost. */
static const char marked[] =
    "bg.def('day', function() palette.set(5, 0x102030) bg.layer(1).map = 'sea' for i = 1, forever do wait(1) end end)\n"
    "bg.def('dusk', function() palette.set(6, 0x405060) bg.layer(1).map = 'reef' wait(forever) end)\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
    "stage.def('s', function()\n"
    "  bg.show('day')\n"
    "  wait(50)\n"
    "  bg.show('dusk')\n"
    "  wait(50)\n"
    "  palette.fade { to = 0x00ff00, over = 20, first = 7, last = 8 }\n"
    "  palette.set(5, 0x112233)\n"
    "  wait(50)\n"
    "  stage.mark('m')\n"
    "  palette.fade { to = 0xffffff, over = 9, first = 5, last = 7 }\n"
    "  bg.layer(2).map = bg.layer(1).map\n"
    "  wait(80)\n"
    "end)\n"
    "boot.run { stages = { 's' }, players = { 'ship' } }";

enum { SHOWN = 20 }; /* frames after the mark */

static void until_marked(void)
{
    for (int f = 0; f < 400 && !r.b->bg.map[1]; f++)
        rig_run(&r, 1);
    assert_true(r.b->bg.map[1] != 0);
}

TEST(practice)
{
    uint32_t rgb[SHOWN][COLOURS];
    uint16_t maps[SHOWN][BG_SLOTS];

    practise(marked, "s");
    until_marked();
    const uint32_t marked_at = board_frame(r.b);
    for (int f = 0; f < SHOWN; f++) {
        memcpy(rgb[f], r.b->pal.rgb, sizeof rgb[f]);
        memcpy(maps[f], r.b->bg.map, sizeof maps[f]);
        rig_run(&r, 1);
    }
    end(NULL);
    practise(marked, "s:m");
    until_marked();
    assert_true(marked_at > board_frame(r.b) + 100);
    for (int f = 0; f < SHOWN; f++) {
        assert_memory_equal(r.b->pal.rgb, rgb[f], sizeof rgb[f]);
        assert_memory_equal(r.b->bg.map, maps[f], sizeof maps[f]);
        assert_int_equal(r.b->bg.shown_id[0], 2);
        rig_run(&r, 1);
    }
    assert_int_equal(r.b->pal.rgb[5], 0xffffff);
    assert_int_equal(r.b->pal.rgb[8], 0x00ff00);
}

/* A boss that is practised has its background, and its phase's, from the first frame on; in a stage they fade in. */
TEST(boss)
{
    static const char text[] =
        "for _, name in ipairs { 'day', 'dusk', 'dark' } do bg.def(name, function() bg.layer(1).map = 'sea' end) end\n"
        "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9 })\n"
        "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
        "boss.def('b', { title = 'B', kind = 'foe', x = 30, y = 30, bg = 'dusk', phases = {\n"
        "  { id = 'one', survive = true, time = 50, run = function() wait(forever) end },\n"
        "  { id = 'two', survive = true, time = 50, bg = 'dark', run = function() wait(forever) end } } })\n"
        "stage.def('s', function() bg.show('day', { over = 0 }) wait(20) boss.fight('b') end)\n"
        "task.go(function() wait(1) while true do if not bg.layer(1).map then bg.show('day', { over = 0 }) end wait(1) "
        "end end)\n"
        "boot.run { stages = { 's' }, players = { 'ship' } }";
    static const struct {
        const char *section;
        int first, then; /* shown in frame 1, and in the phase */
    } practised[] = { { "b/one", 2, 2 }, { "b/two", 3, 3 }, { "s", 1, 2 } };

    for (size_t i = 0; i < sizeof practised / sizeof *practised; i++) {
        const bool is_stage = practised[i].first != practised[i].then;
        practise(text, practised[i].section);
        for (int f = 0; f < 90; f++) {
            rig_run(&r, 1);
            if (is_stage ? f < 20 : f > 0) /* frame 0 looks for the boss in the stages */
                assert_int_equal(r.b->bg.shown_id[0], practised[i].first);
            assert_true(is_stage || bg_darkness(&r.b->bg) == 0);
        }
        assert_int_equal(r.b->bg.shown_id[0], practised[i].then);
        rig_run(&r, 140); /* the next try, or in the stage the next phase */
        assert_int_equal(r.b->bg.shown_id[0], is_stage ? 3 : practised[i].first);
        end(NULL);
    }
}

/* ---- maps that are wrong ---- */

/* Byte `at` of map/reef is changed, counted from its end if negative. */
TEST(bad_maps)
{
    static const struct {
        int at, value;
        const char *message;
    } bad[] = {
        { 0, 0, "its header is out of range" },
        { 4, 9, "its header is out of range" },
        { 8, 16, "its header is out of range" },
        { 12, 1, "its header is out of range" },
        { 10, 1, "wrong flag for empty cells" },
        { 10, 2, "its header is out of range" },
        { 2, 5, "bytes long, its header says" },
        { 16, 4, "cell 0 has tile 4, but the map has 4 tiles" },
        { 17, 1, "cell 0 has tile 256, but the map has 4 tiles" },
        { 57, 1, "tile 1 does not match the map's flags" },
        { 58, 0, "tile 2 does not match the map's flags" },
        { 60, 49, "tile 0 does not match the map's flags" },
        { -1, 17, "tile 3 does not match the map's flags" },
    };
    struct lump reef;

    rig_script(&game, NULL, "");
    rig_maps(&game);
    rom_lump(&game.image.rom, rom_find(&game.image.rom, "map/reef"), &reef);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const int at = bad[i].at < 0 ? (int)reef.size + bad[i].at : bad[i].at;
        uint8_t *byte = game.image.bytes + (reef.data - game.image.bytes) + at, was = *byte;
        struct cart cart;
        char err[256] = "";
        *byte = (uint8_t)bad[i].value;
        assert_false(cart_open(&cart, &game.image.rom, err, sizeof err));
        if (!strstr(err, "lump \"map/reef\": ") || !strstr(err, bad[i].message))
            fail_msg("%zu: %s", i, err);
        *byte = was;
    }
}

RUN_TESTS_EACH(NULL, end)

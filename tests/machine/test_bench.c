/*
 * test_bench.c - the bench's crowds against references that share nothing with the engine: hits in 128-bit arithmetic
 * over every bullet, the picture by a painter that copies byte by byte; and the two programs it is measured beside.
 */
#include "../test.h"
#include "../../src/board/board.h"
#include "../../src/machine/machine.h"
#include "../../src/workbench/pack/pack.h"
#include "../../tools/lab/bench/crowd.h"

__extension__ typedef __int128 wide;

struct bench {
    struct rom_image image;
    void *ram;
    struct board *b;
};

static void power(struct bench *x, int n)
{
    char err[256];
    size_t size;
    struct board_start start = { .difficulty = -1 };

    assert_true(pack_load_game("roms/bench", false, &x->image, err, sizeof err));
    struct cart cart;
    assert_true(cart_open(&cart, &x->image.rom, err, sizeof err));
    for (int i = 0; i < cart.manifest.n_dips; i++)
        start.dip[i] = strcmp(cart.manifest.dips[i].name, "n") ? cart.manifest.dips[i].default_value : n;
    assert_true(board_size(&x->image.rom, &size, err, sizeof err));
    x->ram = aligned_alloc(64, (size + 63) / 64 * 64);
    assert_non_null(x->ram);
    x->b = board_power_on(x->ram, size, &x->image.rom, &start, err, sizeof err);
    assert_non_null(x->b);
    assert_null(board_last_output(x->b)->fault);
}

static void drop(struct bench *x)
{
    free(x->ram);
    rom_image_free(&x->image);
}

/* Does the point that goes from d to d + w come within r of the origin? Times are fractions t / a with a = w.w. */
static bool way_in_circle(wide dx, wide dy, wide wx, wide wy, wide r)
{
    wide a = wx * wx + wy * wy, t = -(dx * wx + dy * wy);

    if (t <= 0 || a == 0)
        return dx * dx + dy * dy <= r * r;
    if (t >= a)
        return (dx + wx) * (dx + wx) + (dy + wy) * (dy + wy) <= r * r;
    wide cross = dx * wy - dy * wx;
    return cross * cross <= r * r * a;
}

/* Narrows the times [lo, hi] / den at which p + v t is within [-h, h]; all in fractions of one denominator a time. */
static bool narrow(wide p, wide v, wide h, wide *lo_n, wide *lo_d, wide *hi_n, wide *hi_d)
{
    if (v == 0)
        return p >= -h && p <= h;
    wide a = (v > 0 ? -h - p : h - p), b = (v > 0 ? h - p : -h - p), d = v;
    if (d < 0)
        a = -a, b = -b, d = -d;
    if (a * *lo_d > *lo_n * d)
        *lo_n = a, *lo_d = d;
    if (b * *hi_d < *hi_n * d)
        *hi_n = b, *hi_d = d;
    return true;
}

static bool way_in_rectangle(wide dx, wide dy, wide wx, wide wy, wide hw, wide hh)
{
    wide lo_n = 0, lo_d = 1, hi_n = 1, hi_d = 1;

    return narrow(dx, wx, hw, &lo_n, &lo_d, &hi_n, &hi_d) && narrow(dy, wy, hh, &lo_n, &lo_d, &hi_n, &hi_d) &&
           lo_n * hi_d <= hi_n * lo_d;
}

/* A box grown by r with round corners is two rectangles and four circles. */
static bool way_in_box(wide dx, wide dy, wide wx, wide wy, wide r, wide hw, wide hh)
{
    if (way_in_rectangle(dx, dy, wx, wy, hw + r, hh) || way_in_rectangle(dx, dy, wx, wy, hw, hh + r))
        return true;
    for (int c = 0; c < 4; c++)
        if (way_in_circle(dx + (c & 1 ? hw : -hw), dy + (c & 2 ? hh : -hh), wx, wy, r))
            return true;
    return false;
}

static bool touched(const struct board *b, uint32_t i, fx r, fx mx, fx my)
{
    const struct bullets *s = &b->bullets;
    uint16_t k = s->kind[i];
    wide wx = (wide)s->vx[i] - mx, wy = (wide)s->vy[i] - my;
    wide dx = (wide)s->x[i] - b->player.x[0] - wx, dy = (wide)s->y[i] - b->player.y[0] - wy;

    if (b->bullet_kinds.shape[k] == SHAPE_CIRCLE)
        return way_in_circle(dx, dy, wx, wy, (wide)b->bullet_kinds.a[k] + r);
    return way_in_box(dx, dy, wx, wy, r, b->bullet_kinds.a[k], b->bullet_kinds.b[k]);
}

/* The target wanders over the whole field. */
static uint16_t wander(uint32_t frame)
{
    const uint16_t way[] = { PAD_LEFT, PAD_UP, PAD_RIGHT, PAD_RIGHT | PAD_DOWN, PAD_UP | PAD_LEFT, PAD_DOWN };

    return way[frame / 37 % 6] | (frame / 500 & 1 ? PAD_FOCUS : 0);
}

TEST(hits)
{
    struct bench x;
    uint64_t hits = 0, misses = 0, grazes = 0;
    static uint8_t before[4096];

    power(&x, 4096);
    for (uint32_t f = 0; f < 4000; f++) {
        uint16_t pads[MAX_PLAYERS] = { wander(f), 0 };
        uint64_t hit = 0, graze = 0;
        if (f)
            memcpy(before, x.b->bullets.flags, sizeof before);
        board_tick(x.b, pads);
        const struct board *b = x.b;
        fx mx = b->player.x[0] - b->player.prev_x[0], my = b->player.y[0] - b->player.prev_y[0];
        for (uint32_t i = 0; i < 4096; i++) {
            bool h = touched(b, i, b->player_kinds.radius[0], mx, my);
            bool g = !h && !(before[i] & BULLET_GRAZED) && touched(b, i, b->player_kinds.graze_radius[0], mx, my);
            hit += h;
            graze += g;
            misses += !h;
            assert_int_equal(b->bullets.flags[i] & BULLET_GRAZED, (before[i] & BULLET_GRAZED) | g);
        }
        assert_int_equal(board_counts(b).moved, 4096);
        assert_int_equal(board_counts(b).hit, hit);
        assert_int_equal(board_counts(b).grazed, graze);
        hits += hit;
        grazes += graze;
    }
    print_message("# %llu hits, %llu grazes, %llu misses\n", (unsigned long long)hits, (unsigned long long)grazes,
                  (unsigned long long)misses);
    assert_true(hits >= 10000 && misses >= 10000 && grazes >= 500);
    drop(&x);
}

/* One byte at a time, clipped by asking for every pixel. */
static void paint(uint8_t *out, int w, int h, const struct sprite *s, int x, int y, uint8_t bank)
{
    for (int j = 0; j < s->h; j++)
        for (int i = 0; i < s->w; i++) {
            uint8_t c = s->pix[j * s->pitch + i];
            if (c && x + i >= 0 && y + j >= 0 && x + i < w && y + j < h)
                out[(y + j) * w + x + i] = (uint8_t)(c + bank * 16);
        }
}

static void paint_bullets(const struct board *b, uint8_t *out, int w, int h)
{
    for (int size = 64; size > 0; size--) /* larger ones first; here every size is one kind, so no ties */
        for (uint32_t k = 0; k < b->bullet_kinds.s.live; k++) {
            const struct sprite *s = &b->sprite_images[b->bullet_kinds.sprite[k]];
            if (s->w != size)
                continue;
            for (uint32_t i = 0; i < b->bullets.s.top; i++)
                if (b->bullets.s.live_bits[i / 64] >> (i & 63) & 1 && b->bullets.kind[i] == k)
                    paint(out, w, h, s, (b->bullets.x[i] >> 16) - s->ox, (b->bullets.y[i] >> 16) - s->oy,
                          b->bullets.bank[i]);
        }
}

TEST(picture)
{
    struct bench x;
    const uint16_t pads[MAX_PLAYERS] = { 0 };
    uint32_t rgb[256];
    struct fb fb;
    int w, h;

    power(&x, 4096);
    board_screen_size(x.b, &w, &h);
    uint8_t *plain = malloc((size_t)(w * h)), *mem = malloc(fb_size(w, h)), *scratch = malloc(board_scratch_size(x.b));
    fb_init(&fb, mem, w, h);
    for (int f = 0; f < 60; f++) {
        board_tick(x.b, pads);
        memset(plain, 0, (size_t)(w * h));
        const struct sprite *ship = &x.b->sprite_images[x.b->player_kinds.sprite[0]];
        if (!(x.b->player.safe_left[0] >> 2 & 1))
            paint(plain, w, h, ship, (x.b->player.x[0] >> 16) - ship->ox, (x.b->player.y[0] >> 16) - ship->oy, 0);
        paint_bullets(x.b, plain, w, h);
        assert_true(board_draw(x.b, NULL, &fb, rgb, scratch) >= 4096);
        for (int y = 0; y < h; y++)
            assert_memory_equal(fb.pix + y * fb.pitch, plain + y * w, (size_t)w);
    }
    free(plain);
    free(mem);
    free(scratch);
    drop(&x);
}

/* ---- the crowd that `make bench` measures ---- */

static const struct reference *const references[] = { &reference_array, &reference_columns, &reference_least };
enum { REFERENCES = sizeof references / sizeof *references };

struct match {
    struct rom_image image;
    struct scene scene;
    struct crowd crowd;
    void *data[REFERENCES];
    struct crowd_counts board, counts[REFERENCES];
};

static void open_match(struct match *m, int n, uint64_t seed)
{
    char err[256];
    const struct scene_want want = { .does = "crowd", .n = n, .bullets = n, .seed = seed };

    memset(m, 0, sizeof *m);
    assert_true(pack_load_game("roms/bench", false, &m->image, err, sizeof err));
    assert_true(scene_open(&m->scene, &m->image.rom, &want, err, sizeof err));
    assert_true(crowd_take(&m->crowd, &m->scene));
    assert_int_equal(m->crowd.n, n);
    for (int i = 0; i < REFERENCES; i++)
        assert_non_null(m->data[i] = references[i]->open(&m->crowd));
}

static void close_match(struct match *m)
{
    for (int i = 0; i < REFERENCES; i++)
        references[i]->close(m->data[i]);
    free((void *)(uintptr_t)m->crowd.bullets);
    scene_close(&m->scene);
    rom_image_free(&m->image);
}

static void play_match(struct match *m)
{
    assert_true(scene_tick(&m->scene));
    scene_draw(&m->scene);
    crowd_count(&m->board, &m->scene, true);
    const struct crowd_player p = crowd_player(&m->scene);
    for (int i = 0; i < REFERENCES; i++) {
        references[i]->tick(m->data[i], &p, &m->counts[i]);
        references[i]->draw(m->data[i], &m->counts[i]);
    }
}

/* Hits of the frame just run, every bullet asked. */
static uint64_t hits_of(const struct board *b)
{
    fx mx = b->player.x[0] - b->player.prev_x[0], my = b->player.y[0] - b->player.prev_y[0];
    uint64_t n = 0;

    for (uint32_t i = 0; i < b->bullets.s.live; i++)
        n += touched(b, i, b->player_kinds.radius[0], mx, my);
    return n;
}

/* Each frame the four agree, in counts, places and pixels: more than a way and back, and past a change of the pace. */
TEST(crowd)
{
    static const int sizes[] = { 1, 63, 64, 1000, 3001 };
    static struct match m;

    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        open_match(&m, sizes[k], 77 + k);
        for (int f = 0; f < 600; f++) {
            uint64_t before = m.board.hit;
            play_match(&m);
            assert_int_equal(m.board.hit - before, hits_of(m.scene.b));
            for (int i = 0; i < REFERENCES; i++) {
                if (references[i] == &reference_least) /* it asks for no more */
                    m.counts[i].tested = m.board.tested, m.counts[i].grazed = m.board.grazed;
                assert_memory_equal(&m.board, &m.counts[i], sizeof m.board);
                assert_null(crowd_differs(&m.crowd, &m.scene, references[i], m.data[i]));
            }
            if (f % 30 == 0)
                assert_null(crowd_misdrawn(&m.crowd, &m.scene));
        }
        assert_int_equal(m.board.moved, 600 * sizes[k]);
        assert_int_equal(m.board.drawn, 600 * (sizes[k] + 1));
        assert_true(sizes[k] < 3001 || (m.board.tested > 10000 && m.board.hit > 1000 && m.board.grazed > 300));
        close_match(&m);
    }
}

/* Those who compare can tell: one bullet an ulp away, one pixel a shade off. */
TEST(crowd_spoilt)
{
    static struct match m;

    open_match(&m, 1000, 5);
    for (int f = 0; f < 70; f++)
        play_match(&m);
    struct board *b = m.scene.b;
    uint8_t *pixel = m.scene.fb.pix + 120 * m.scene.fb.pitch + 160;
    for (int i = 0; i < REFERENCES; i++) {
        b->bullets.x[999]++;
        assert_non_null(crowd_differs(&m.crowd, &m.scene, references[i], m.data[i]));
        b->bullets.x[999]--;
        *pixel ^= 1;
        assert_non_null(crowd_differs(&m.crowd, &m.scene, references[i], m.data[i]));
        *pixel ^= 1;
        assert_null(crowd_differs(&m.crowd, &m.scene, references[i], m.data[i]));
    }
    *pixel ^= 1;
    assert_non_null(crowd_misdrawn(&m.crowd, &m.scene));
    *pixel ^= 1;
    assert_null(crowd_misdrawn(&m.crowd, &m.scene));
    close_match(&m);
}

static int opaque(const uint8_t *pix)
{
    int n = 0;

    for (int i = 0; i < CROWD_SIDE * CROWD_SIDE; i++)
        n += pix[i] != 0;
    return n;
}

/* No two pictures of a run are alike, nor the same kind's in two runs; as many pixels are opaque as of the disc. */
TEST(crowd_shuffled)
{
    static struct match m[2];

    open_match(&m[0], 64, 1);
    open_match(&m[1], 64, 2);
    for (int k = 0; k < CROWD_KINDS; k++) {
        const uint8_t *pix = m[0].crowd.pix[k];
        assert_int_equal(opaque(pix), opaque(m[0].crowd.ship));
        assert_int_equal(opaque(m[1].crowd.pix[k]), opaque(m[0].crowd.ship));
        assert_memory_not_equal(pix, m[1].crowd.pix[k], sizeof m[0].crowd.pix[k]);
        for (int i = 0; i < CROWD_SIDE * CROWD_SIDE; i++)
            assert_true(!pix[i] || pix[i] / 16 == (k + 1) % 8);
        for (int j = 0; j < k; j++) {
            int same = 0; /* banks aside */
            for (int i = 0; i < CROWD_SIDE * CROWD_SIDE; i++)
                same += pix[i] % 16 == m[0].crowd.pix[j][i] % 16;
            assert_true(same < CROWD_SIDE * CROWD_SIDE);
        }
    }
    assert_memory_equal(m[0].crowd.ship, m[1].crowd.ship, sizeof m[0].crowd.ship);
    close_match(&m[0]);
    close_match(&m[1]);
}

RUN_TESTS(NULL, NULL)

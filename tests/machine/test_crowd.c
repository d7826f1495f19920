/*
 * test_crowd.c - crowds of bullets, drawn back to front, front to back, and by a painter that sets one byte after the
 * other; and moved in the one pass over blocks, against a plain loop.
 */
#include "../../src/board/hit.h"
#include "../../src/board/video.h"
#include "rig.h"

static struct rng rng;

static int below(int n)
{
    return (int)rng_below(&rng, (uint64_t)n);
}

static bool is_used(const struct slots *s, uint32_t i)
{
    return s->used[i / SLOTS_BLOCK] >> (i % SLOTS_BLOCK) & 1;
}

/* ---- pictures ---- */

/* One byte at a time, clipped to the field by asking for every pixel. */
static void paint(const struct board *b, uint8_t *out, const struct image *image, int x, int y, uint8_t bank)
{
    const struct manifest *m = &b->cart.m;

    for (int v = 0; v < image->h; v++)
        for (int u = 0; u < image->w; u++) {
            uint8_t c = image->pix[v * image->pitch + u];
            if (c && x + u >= 0 && x + u < m->field_w && y + v >= 0 && y + v < m->field_h)
                out[(y + v + m->field_y) * m->screen_w + x + u + m->field_x] = (uint8_t)(c + bank * 16);
        }
}

/* The larger pictures first, equal ones in order of declaration, then by slot. */
static void paint_all(const struct board *b, const struct bullets *s, const struct bullet_kinds *k, uint8_t *out)
{
    int last = INT32_MAX;

    for (;;) {
        int area = -1;
        for (uint32_t kind = 0; kind < k->s.live; kind++) {
            const struct sprite *pic = &b->pictures[k->sprite[kind]];
            if (pic->w * pic->h < last && pic->w * pic->h > area)
                area = pic->w * pic->h;
        }
        if (area < 0)
            return;
        for (uint32_t kind = 0; kind < k->s.live; kind++) {
            const struct sprite *pic = &b->pictures[k->sprite[kind]];
            for (uint32_t i = 0; i < s->s.top && pic->w * pic->h == area; i++)
                if (is_used(&s->s, i) && s->kind[i] == kind) {
                    struct image image =
                        video_image(pic, b->core.clock - s->born[i], k->flags[kind] & KIND_TURNS, s->dir[i]);
                    paint(b, out, &image, (s->x[i] >> 16) - pic->ox, (s->y[i] >> 16) - pic->oy, s->bank[i]);
                }
        }
        last = area;
    }
}

static void throw_bullets(struct board *b, uint32_t n, uint32_t kinds, bool everywhere)
{
    const struct manifest *m = &b->cart.m;
    struct bullets *s = &b->bullets;
    uint32_t only = (uint32_t)below((int)b->bullet_kinds.s.live);

    while (s->s.live < n && s->s.live < s->s.cap) {
        struct bullet_shape shape = { .kind = (uint16_t)((only + (uint32_t)below((int)kinds)) % b->bullet_kinds.s.live),
                                      .bank = (uint8_t)below(16),
                                      .dir = (ang)rng_next(&rng),
                                      .x = (fx)(below((m->field_w + 100) << 16) - (50 << 16)),
                                      .y = (fx)(below((m->field_h + 100) << 16) - (50 << 16)) };
        if (everywhere && below(9) == 0)
            shape.x = (below(2 * WORLD) - WORLD) << 16;
        if (everywhere && below(9) == 0)
            shape.y = (below(2 * WORLD) - WORLD) << 16;
        bullets_fire(s, &shape, b->core.clock - (uint32_t)below(100));
    }
}

static long hidden, drawn;

static void compare(struct rig *r, uint8_t *want, uint8_t *backdrop, int coats)
{
    struct board *b = r->b;
    const struct manifest *m = &b->cart.m;
    struct canvas c = { b, &r->fb, m->field_x, m->field_y, r->scratch, coats, 0, 0 };

    for (int y = 0; y < m->screen_h; y++)
        memcpy(r->fb.pix + y * r->fb.pitch, backdrop + y * m->screen_w, (size_t)m->screen_w);
    fb_clip(&r->fb, m->field_x, m->field_y, m->field_w, m->field_h);
    video_bullets(&c, &b->bullets, &b->bullet_kinds);
    for (int y = 0; y < m->screen_h; y++)
        if (memcmp(r->fb.pix + y * r->fb.pitch, want + y * m->screen_w, (size_t)m->screen_w))
            fail_msg("%u bullets, %d coats: row %d differs", b->bullets.s.live, coats, y);
    assert_int_equal(c.drawn, b->bullets.s.live);
    assert_true(c.hidden <= c.drawn && (coats != VIDEO_NO_COATS || !c.hidden));
    hidden += (long)c.hidden;
    drawn += (long)c.drawn;
}

static void picture(struct rig *r, int scene)
{
    static const int coats[] = { VIDEO_NO_COATS, 0, 1, VIDEO_COATS };
    struct board *b = r->b;
    const struct manifest *m = &b->cart.m;
    size_t size = (size_t)(m->screen_w * m->screen_h);
    uint8_t *want = malloc(size), *backdrop = malloc(size);

    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    slots_trim(&b->bullets.s);
    throw_bullets(b, (uint32_t)below(scene % 4 ? 400 : (int)b->bullets.s.cap), scene % 3 ? 64 : 1, scene % 5 == 0);
    EACH_LIVE (i, &b->bullets.s)
        if (below(8) == 0 && scene % 2)
            bullets_drop(&b->bullets, i);
    for (size_t i = 0; i < size; i++)
        backdrop[i] = (uint8_t)rng_next(&rng);
    memcpy(want, backdrop, size);
    paint_all(b, &b->bullets, &b->bullet_kinds, want);
    for (size_t i = 0; i < sizeof coats / sizeof *coats; i++)
        compare(r, want, backdrop, coats[i]);
    free(want);
    free(backdrop);
}

static void pictures_of(const char *folder, int scenes)
{
    const struct board_start start = { .difficulty = -1 };
    struct rig_game game;
    struct rig r;

    rig_folder(&game, folder);
    rig_power(&r, &game, &start);
    hidden = drawn = 0;
    for (int i = 0; i < scenes; i++)
        picture(&r, i);
    print_message("# %s: %ld drawn, %ld hidden\n", folder, drawn, hidden);
    assert_true(hidden > drawn / 20 && hidden < drawn);
    rig_free(&r);
    rig_game_free(&game);
}

static void test_pictures(void **state)
{
    (void)state;
    rng_seed(&rng, 5);
    pictures_of("glasstide", 60);
    pictures_of("torture", 60);
}

/* ---- the pass that moves ---- */

static fx length(fx most)
{
    switch (below(5)) {
    case 0:
        return below(2) ? most : -most;
    case 1:
        return below(3) - 1;
    case 2:
        return (fx)((int64_t)rng_below(&rng, 2 * (uint64_t)most + 1) - most);
    default:
        return below(600 << 16) - (300 << 16);
    }
}

static int64_t gap(fx a, fx b)
{
    return a > b ? (int64_t)a - b : (int64_t)b - a;
}

/* One frame of straight bullets: who goes, where the others are, and who is near whom. */
static void move(struct board *b, const struct box *keep, const struct watch watch[PADS], uint32_t clock)
{
    struct bullets *s = &b->bullets;
    struct motion_world w = { .motions = &b->motions, .steps = &b->steps, .kinds = &b->bullet_kinds, .clock = clock };
    uint32_t top = s->s.top, live = s->s.live, left = 0;
    static fx x[1024], y[1024], vx[1024], vy[1024];
    static bool was[1024];

    assert_true(top <= 1024);
    for (uint32_t i = 0; i < top; i++) {
        was[i] = is_used(&s->s, i);
        x[i] = (fx)((uint32_t)s->x[i] + (uint32_t)s->vx[i]);
        y[i] = (fx)((uint32_t)s->y[i] + (uint32_t)s->vy[i]);
        vx[i] = s->vx[i] < 0 ? -s->vx[i] : s->vx[i];
        vy[i] = s->vy[i] < 0 ? -s->vy[i] : s->vy[i];
        left += was[i];
    }
    assert_int_equal(left, live);
    bullets_move(s, &w, keep, watch);
    assert_int_equal(s->moved, live);
    for (uint32_t i = 0; i < top; i++) {
        bool in = was[i] && x[i] >= keep->x0 && x[i] <= keep->x1 && y[i] >= keep->y0 && y[i] <= keep->y1;
        assert_int_equal(i < s->s.top && is_used(&s->s, i), in);
        if (!in)
            continue;
        assert_true(s->x[i] == x[i] && s->y[i] == y[i] && vx[i] <= s->fastest && vy[i] <= s->fastest);
        for (uint32_t p = 0; p < PADS; p++) {
            bool near = s->near[i / SLOTS_BLOCK * PADS + p] >> (i % SLOTS_BLOCK) & 1;
            bool must = watch[p].reach >= 0 && gap(x[i], watch[p].x) <= watch[p].reach + vx[i] &&
                        gap(y[i], watch[p].y) <= watch[p].reach + vy[i];
            bool may = watch[p].reach >= 0 && gap(x[i], watch[p].x) <= watch[p].reach + s->fastest &&
                       gap(y[i], watch[p].y) <= watch[p].reach + s->fastest;
            assert_true(near >= must);
            if (watch[p].reach + s->fastest <= FX_MAX)
                assert_int_equal(near, may);
        }
    }
    uint64_t near[2 * 1024 / SLOTS_BLOCK];
    memcpy(near, s->near, s->s.top / SLOTS_BLOCK * PADS * sizeof *near);
    bullets_watch(s, watch);
    for (uint32_t k = 0; k < s->s.top / SLOTS_BLOCK * PADS; k++)
        assert_true(!((near[k] ^ s->near[k]) & s->s.used[k / PADS]));
}

static void test_moves(void **state)
{
    const struct board_start start = { .difficulty = -1 };
    const fx world = WORLD << 16, fastest = MAX_SPEED << 16;
    struct rig_game game;
    struct rig r;

    (void)state;
    rng_seed(&rng, 6);
    rig_folder(&game, "glasstide");
    rig_power(&r, &game, &start);
    struct bullets *s = &r.b->bullets;
    for (int scene = 0; scene < 3000; scene++) {
        struct box keep = { -length(64 << 16), -length(64 << 16), world, world };
        struct watch watch[PADS];
        if (below(2))
            keep = (struct box){ -world, -world, world, world };
        else if (below(2))
            keep = (struct box){ -(64 << 16), -(64 << 16), 300 << 16, 300 << 16 };
        for (uint32_t p = 0; p < PADS; p++)
            watch[p] = (struct watch){ length(world), length(world),
                                       below(4) ? (int64_t)below(64 << 16) - 1 : (int64_t)rng_below(&rng, 1ull << 33) };
        EACH_LIVE (i, &s->s)
            bullets_drop(s, i);
        slots_trim(&s->s);
        for (int n = below(600); n > 0; n--) {
            struct bullet_shape shape = { .x = length(world), .y = length(world) };
            int32_t i = bullets_fire(s, &shape, 0);
            fx speed = scene % 3 ? below(4 << 16) : length(fastest);
            bullets_set_velocity(s, (uint32_t)i, (int64_t)(below(2) ? speed : -speed) * 65536,
                                 (int64_t)length(speed) * 65536);
        }
        for (uint32_t n = 0; n < 3; n++) {
            EACH_LIVE (i, &s->s)
                if (below(10) == 0)
                    bullets_drop(s, i);
            move(r.b, &keep, watch, (uint32_t)scene * 3 + n);
        }
    }
    rig_free(&r);
    rig_game_free(&game);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(test_pictures), cmocka_unit_test(test_moves) };

    return cmocka_run_group_tests_name("crowd", tests, NULL, NULL);
}

/*
 * test_crowd.c - crowds of bullets, drawn by the engine and by a painter that sets one byte after the other; and moved
 * in the one pass over blocks, against a plain loop.
 */
#include "../../src/machine/collision/hit.h"
#include "../../src/machine/video/video.h"
#include "rig.h"

static struct rng rng;

static int below(int n)
{
    return (int)rng_below(&rng, (uint64_t)n);
}

static bool is_used(const struct slots *s, uint32_t i)
{
    return s->live_bits[i / SLOTS_BLOCK] >> (i % SLOTS_BLOCK) & 1;
}

/* ---- pictures ---- */

enum { OWN = 12 }; /* sprites of a game made here, beside the rig's */

/* One byte at a time, clipped to the field by asking for every pixel. */
static void paint(const struct board *b, uint8_t *out, const struct image *image, int x, int y, uint8_t bank,
                  const uint8_t *table)
{
    const struct manifest *m = &b->cart.manifest;

    for (int v = 0; v < image->h; v++)
        for (int u = 0; u < image->w; u++) {
            uint8_t c = image->pix[v * image->pitch + u];
            uint8_t *d = &out[(y + v + m->field_y) * m->screen_w + x + u + m->field_x];
            if (!c || x + u < 0 || x + u >= m->field_w || y + v < 0 || y + v >= m->field_h)
                continue;
            c = (uint8_t)(c + bank * 16);
            *d = table ? table[*d * 256 + c] : c;
        }
}

/* The picture of bullet i. A cloud's frames share the delay, the first of which is drawn a frame after it was fired. */
static struct image image_of(const struct board *b, const struct bullets *s, const struct bullet_kinds *k, uint32_t i)
{
    const uint16_t flags = k->flags[s->kind[i]];
    const struct sprite *pic = &b->sprite_images[k->sprite[s->kind[i]]];
    int64_t age = (int64_t)b->core.clock - s->born[i], delay = (int64_t)s->step_end[i] - s->born[i];

    if (s->flags[i] & BULLET_DELAYED) {
        int64_t at = age < 1 ? 0 : age > delay ? delay - 1 : age - 1;
        age = flags & KIND_IS_CLOUD_ROW ? at * pic->frames * pic->frame_ticks / delay : 0;
    }
    ang way = flags & KIND_TURNS ? s->dir[i] : 0, spin = k->spin[s->kind[i]];
    return video_image(pic, (uint32_t)age, flags & KIND_TURNS || spin, (ang)((int64_t)way + age * spin));
}

static void paint_kind(const struct board *b, const struct bullets *s, const struct bullet_kinds *k, uint32_t kind,
                       uint8_t *out)
{
    const struct sprite *pic = &b->sprite_images[k->sprite[kind]];
    unsigned blend = (k->flags[kind] & (unsigned)KIND_BLEND) / KIND_BLEND_ONE;

    for (uint32_t i = 0; i < s->s.top; i++)
        if (is_used(&s->s, i) && s->kind[i] == kind) {
            struct image image = image_of(b, s, k, i);
            paint(b, out, &image, (s->x[i] >> 16) - pic->ox, (s->y[i] >> 16) - pic->oy, s->bank[i],
                  blend ? b->cart.main_tables.blend[blend - 1] : NULL);
        }
}

/* Lower orders first, then larger pictures, equal ones in order of declaration, then by slot. */
static void paint_all(const struct board *b, const struct bullets *s, const struct bullet_kinds *k, uint8_t *out)
{
    bool done[MAX_KINDS] = { false };

    for (uint32_t n = 0; n < k->s.live; n++) {
        uint32_t next = MAX_KINDS;
        int64_t least = INT64_MAX;
        for (uint32_t kind = 0; kind < k->s.live; kind++) {
            const struct sprite *pic = &b->sprite_images[k->sprite[kind]];
            int64_t rank = (int64_t)k->draw_order[kind] * 1000000 - pic->w * pic->h;
            if (!done[kind] && rank < least) {
                least = rank;
                next = kind;
            }
        }
        done[next] = true;
        paint_kind(b, s, k, next, out);
    }
}

/* A sprite lump of noise: any size up to `most`, any pitch and origin, often outside of the picture. */
static uint8_t *noise_sprite(uint32_t *size, int most)
{
    int w = 1 + below(most), h = 1 + below(most), pitch = (w + 7) / 8 * 8 + 8 * below(3), bank = below(16);
    int frames = below(3) ? 1 : 1 + below(5), turns = below(3) ? 1 : 1 + below(9), solid = below(2) ? 100 : below(101);
    int ox = below(3) ? w / 2 : below(8) ? below(4 * w) - w : below(3073) - 1024;
    int oy = below(3) ? h / 2 : below(8) ? below(4 * h) - h : below(3073) - 1024;
    const int every = 1 + (below(4) ? below(3) : below(1 << below(17)));
    const int header[] = { w, h, pitch, ox, oy, frames, every < 65536 ? every : 65535, turns, bank };
    *size = (uint32_t)(CART_GFX_HEADER_SIZE + frames * turns * h * pitch);
    uint8_t *lump = calloc(1, *size);

    assert_non_null(lump);
    for (int i = 0; i < 9; i++)
        bytes_put16(lump + 2 * i, (uint16_t)header[i]);
    for (int y = 0; y < frames * turns * h; y++)
        for (int x = 0; x < w; x++)
            lump[CART_GFX_HEADER_SIZE + y * pitch + x] = (uint8_t)(below(100) < solid ? bank * 16 + 1 + below(15) : 0);
    return lump;
}

/* A game with a screen, field and pools of any size, and sprites of noise; half of the games have small ones alone. */
static void random_game(struct rig_game *g)
{
    struct manifest m = rig_manifest();
    struct lump lumps[RIG_LUMPS];
    char names[OWN][24];
    uint8_t *own[OWN];
    struct rig_game plain;
    bool small = below(2);

    m.screen_w = 64 + 8 * below(24);
    m.screen_h = 64 + 8 * below(24);
    m.field_w = below(3) ? 16 + below(m.screen_w - 15) : 16 + below(20);
    m.field_h = below(3) ? 16 + below(m.screen_h - 15) : 16 + below(20);
    m.field_x = below(3) ? below(m.screen_w - m.field_w + 1) : 0;
    m.field_y = below(3) ? below(m.screen_h - m.field_h + 1) : 0;
    m.bullets = below(8) ? 64 * (1 + below(30)) + below(2) * below(64) : 1 + below(3);
    m.shots = 1 + below(500);
    rig_script(&plain, &m, "");
    rig_blends(&plain);
    int n = (int)plain.image.rom.count;
    assert_true(n + OWN <= RIG_LUMPS);
    for (int i = 0; i < n; i++)
        rom_lump(&plain.image.rom, i, &lumps[i]);
    for (int i = 0; i < OWN; i++) {
        uint32_t size;
        snprintf(names[i], sizeof names[i], "gfx/noise%02d", i);
        own[i] = noise_sprite(&size, small ? 16 : below(6) ? 33 : 100);
        lumps[n++] = (struct lump){ names[i], own[i], size };
    }
    rig_write(g, lumps, n);
    rig_game_free(&plain);
    for (int i = 0; i < OWN; i++)
        free(own[i]);
}

/* Kinds of any sprites, a quarter of the time with blends; dead slots hold rubbish. */
static void random_bullets(struct board *b, struct bullets *s, struct bullet_kinds *k)
{
    const struct manifest *m = &b->cart.manifest;
    uint32_t n = below(2) ? s->s.cap : (uint32_t)below((int)s->s.cap + 1), first, kinds;
    bool blended = below(4) == 0, holes = below(3) == 0, far = below(3) == 0;

    k->s.live = (uint32_t)(1 + below(below(4) ? 20 : MAX_KINDS));
    for (uint32_t i = 0; i < k->s.live; i++) {
        k->sprite[i] = (uint16_t)below(b->cart.count[CART_SPRITES]);
        k->draw_order[i] = (int8_t)(below(4) ? 0 : below(201) - 100);
        k->spin[i] = below(3) ? 0 : (ang)rng_next(&rng);
        k->flags[i] = (uint16_t)((below(2) ? KIND_TURNS : 0) | (blended ? below(3) * KIND_BLEND_ONE : 0) |
                                 (below(4) ? 0 : KIND_IS_CLOUD_ROW));
    }
    EACH_LIVE (i, &s->s)
        bullets_drop(s, i);
    slots_trim(&s->s);
    memset(s->kind, 0xff, s->s.cap * sizeof *s->kind);
    memset(s->bank, 0xff, s->s.cap);
    first = (uint32_t)below((int)k->s.live);
    kinds = below(3) ? k->s.live : 1;
    while (s->s.live < n) {
        struct bullet_spec shape = { .kind = (uint16_t)((first + (uint32_t)below((int)kinds)) % k->s.live),
                                     .bank = (uint8_t)below(16),
                                     .dir = (ang)rng_next(&rng) };
        const struct sprite *pic = &b->sprite_images[k->sprite[shape.kind]];
        shape.x = (below(m->field_w + 2 * pic->w + 20) - pic->w - 10 + pic->ox) * 65536 + below(65536);
        shape.y = (below(m->field_h + 2 * pic->h + 20) - pic->h - 10 + pic->oy) * 65536 + below(65536);
        if (far && below(9) == 0)
            shape.x = (below(2 * WORLD_EDGE + 1) - WORLD_EDGE) * 65536;
        if (far && below(9) == 0)
            shape.y = (below(2 * WORLD_EDGE + 1) - WORLD_EDGE) * 65536;
        if (k->flags[shape.kind] & KIND_IS_CLOUD_ROW || below(5) == 0)
            shape.delay = (uint32_t)(1 + below(150));
        const bool old = !shape.delay && below(9) == 0;
        bullets_fire(s, &shape, b->core.clock - (old ? (uint32_t)rng_next(&rng) >> below(32) : (uint32_t)below(100)));
    }
    EACH_LIVE (i, &s->s)
        if (holes && below(9) == 0) {
            bullets_drop(s, i);
            s->kind[i] = (uint16_t)rng_next(&rng);
        }
}

static struct {
    long drawn, blended;
} seen;

static void picture(struct rig *r, const struct bullets *s, const struct bullet_kinds *k)
{
    const struct board *b = r->b;
    const struct manifest *m = &b->cart.manifest;
    size_t w = (size_t)m->screen_w, size = w * (size_t)m->screen_h;
    uint8_t *want = malloc(size), *backdrop = malloc(size);

    assert_true(want && backdrop);
    for (size_t i = 0; i < size; i++)
        want[i] = backdrop[i] = (uint8_t)rng_next(&rng);
    paint_all(b, s, k, want);
    struct draw_target c = { .b = b,
                             .fb = &r->fb,
                             .x = m->field_x,
                             .y = m->field_y,
                             .scratch = r->scratch,
                             .palette_tables = b->cart.main_tables };
    for (int y = 0; y < m->screen_h; y++)
        memcpy(r->fb.pix + y * r->fb.pitch, backdrop + (size_t)y * w, w);
    fb_set_clip(&r->fb, m->field_x, m->field_y, m->field_w, m->field_h);
    memset(r->scratch, 0xa5, board_scratch_size(b));
    video_draw_bullets(&c, s, k);
    for (int y = 0; y < m->screen_h; y++)
        if (memcmp(r->fb.pix + y * r->fb.pitch, want + (size_t)y * w, w))
            fail_msg("%u bullets: row %d differs", s->s.live, y);
    assert_int_equal(c.drawn_count, s->s.live);
    seen.drawn += (long)c.drawn_count;
    for (uint32_t i = 0; i < k->s.live; i++)
        seen.blended += (k->flags[i] & KIND_BLEND) != 0;
    free(want);
    free(backdrop);
}

TEST(pictures)
{
    const struct board_start start = { .difficulty = -1 };
    int games = rig_long() ? 600 : 60;

    rng_seed(&rng, 5);
    for (int i = 0; i < games; i++) {
        struct rig_game game;
        struct rig r;
        random_game(&game);
        rig_power(&r, &game, &start);
        rig_reserve_kinds(r.b);
        for (int scene = 0; scene < 8; scene++) {
            struct bullets *s = scene % 2 ? &r.b->shots : &r.b->bullets;
            struct bullet_kinds *k = scene % 2 ? &r.b->shot_kinds : &r.b->bullet_kinds;
            r.b->core.clock = (uint32_t)rng_next(&rng);
            random_bullets(r.b, s, k);
            picture(&r, s, k);
        }
        rig_close(&r);
    }
    print_message("# %ld drawn; %ld kinds with blends\n", seen.drawn, seen.blended);
    assert_true(seen.drawn > 10000 && seen.blended > 1000);
}

/* A whole block in the middle of the field, which needs no clipping, but for one bullet about an edge. */
TEST(edges)
{
    const struct board_start start = { .difficulty = -1 };

    rng_seed(&rng, 7);
    for (int n = 0; n < 40; n++) {
        struct rig_game game;
        struct rig r;
        random_game(&game);
        rig_power(&r, &game, &start);
        rig_reserve_kinds(r.b);
        struct bullets *s = &r.b->bullets;
        struct bullet_kinds *k = &r.b->bullet_kinds;
        const struct manifest *m = &r.b->cart.manifest;
        k->s.live = (uint32_t)(1 + below(3));
        for (uint32_t i = 0; i < k->s.live; i++) {
            k->sprite[i] = (uint16_t)below(r.b->cart.count[CART_SPRITES]);
            k->flags[i] = (uint16_t)(below(3) ? 0 : KIND_TURNS);
            k->draw_order[i] = 0;
            k->spin[i] = 0;
        }
        for (int i = 0; i < SLOTS_BLOCK; i++) {
            const struct bullet_spec shape = { .x = (m->field_w / 2) << 16,
                                               .y = (m->field_h / 2) << 16,
                                               .kind = (uint16_t)below((int)k->s.live),
                                               .bank = (uint8_t)below(16),
                                               .dir = (ang)rng_next(&rng) };
            bullets_fire(s, &shape, r.b->core.clock);
        }
        for (int place = 0; place < 200 && s->s.live == SLOTS_BLOCK; place++) {
            const uint32_t i = (uint32_t)below(SLOTS_BLOCK);
            fx *at = place % 2 ? &s->x[i] : &s->y[i], was = *at;
            const int edge = below(2) ? 0 : place % 2 ? m->field_w : m->field_h;
            *at = (edge + below(90) - 45) * 65536 + (below(2) ? 0 : below(65536));
            picture(&r, s, k);
            *at = was;
        }
        rig_close(&r);
    }
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
static void move(struct board *b, const struct box *keep, const struct bullets_query query[MAX_PLAYERS], uint32_t clock)
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
    bullets_move(s, &w, keep, query, false);
    assert_int_equal(s->n_moved, live);
    for (uint32_t i = 0; i < top; i++) {
        bool in = was[i] && x[i] >= keep->x0 && x[i] <= keep->x1 && y[i] >= keep->y0 && y[i] <= keep->y1;
        assert_int_equal(i < s->s.top && is_used(&s->s, i), in);
        if (!in) { /* it is held if it is near a player */
            const uint64_t *near = &s->near_player[i / SLOTS_BLOCK * MAX_PLAYERS];
            assert_int_equal(slots_has_held(&s->s, i, s->s.gen[i]),
                             was[i] && (near[0] | near[1]) >> (i % SLOTS_BLOCK) & 1);
            continue;
        }
        assert_true(s->x[i] == x[i] && s->y[i] == y[i] && vx[i] <= s->speed_bound && vy[i] <= s->speed_bound);
        for (uint32_t p = 0; p < MAX_PLAYERS; p++) {
            bool near = s->near_player[i / SLOTS_BLOCK * MAX_PLAYERS + p] >> (i % SLOTS_BLOCK) & 1;
            bool must = query[p].reach >= 0 && gap(x[i], query[p].x) <= query[p].reach + vx[i] &&
                        gap(y[i], query[p].y) <= query[p].reach + vy[i];
            bool may = query[p].reach >= 0 && gap(x[i], query[p].x) <= query[p].reach + s->speed_bound &&
                       gap(y[i], query[p].y) <= query[p].reach + s->speed_bound;
            assert_true(near >= must);
            if (query[p].reach + s->speed_bound <= FX_MAX)
                assert_int_equal(near, may);
        }
    }
    bullets_release_all(s);
}

TEST(moves)
{
    const struct board_start start = { .difficulty = -1 };
    const fx world = WORLD_EDGE << 16, fastest = MAX_SPEED << 16;
    struct rig_game game;
    struct rig r;

    rng_seed(&rng, 6);
    rig_folder(&game, "glasstide");
    rig_power(&r, &game, &start);
    struct bullets *s = &r.b->bullets;
    for (int scene = 0; scene < 3000; scene++) {
        struct box keep = { -length(64 << 16), -length(64 << 16), world, world };
        struct bullets_query query[MAX_PLAYERS];
        if (below(2))
            keep = (struct box){ -world, -world, world, world };
        else if (below(2))
            keep = (struct box){ -(64 << 16), -(64 << 16), 300 << 16, 300 << 16 };
        for (uint32_t p = 0; p < MAX_PLAYERS; p++)
            query[p] = (struct bullets_query){ .x = length(world),
                                               .y = length(world),
                                               .reach = below(4) ? (int64_t)below(64 << 16) - 1
                                                                 : (int64_t)rng_below(&rng, 1ull << 33) };
        EACH_LIVE (i, &s->s)
            bullets_drop(s, i);
        slots_trim(&s->s);
        for (int n = below(600); n > 0; n--) {
            struct bullet_spec shape = { .x = length(world), .y = length(world) };
            int32_t i = bullets_fire(s, &shape, 0);
            fx speed = scene % 3 ? below(4 << 16) : length(fastest);
            bullets_set_velocity(s, (uint32_t)i, (int64_t)(below(2) ? speed : -speed) * 65536,
                                 (int64_t)length(speed) * 65536);
        }
        for (uint32_t n = 0; n < 3; n++) {
            EACH_LIVE (i, &s->s)
                if (below(10) == 0)
                    bullets_drop(s, i);
            move(r.b, &keep, query, (uint32_t)scene * 3 + n);
        }
    }
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)

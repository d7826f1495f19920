/*
 * broad.c - section 6: which pairs are worth an exact test? One player against many bullets, many shots against many
 * enemies.
 *
 * The engine's rows are hit_run on a board. The rivals are a uniform grid and a tree of boxes (bullets sorted along a
 * Morton curve, blocks of 8 as leaves, boxes of boxes above). Bullets move every frame, so both are built every frame.
 * All find the same pairs, which is checked; they differ in how many they look at.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/base/geom.h"
#include "../../../src/base/int.h"
#include "engine.h"
#include "lab.h"

enum {
    FIELD_W = 384,
    FIELD_H = 448,
    BULLET_R = 4,
    PLAYER_R = 2,
    FASTEST = 3,
    REACH = (BULLET_R + PLAYER_R + FASTEST) * 65536 + 65536,
    CELL_BITS = 16 + 4, /* cells of 16 px */
    COLS = FIELD_W >> 4,
    ROWS = FIELD_H >> 4,
    LEAF = 8,
    FRAME_US = 16667
};

static const fx PLAYER_X = 150 * 65536 + 777, PLAYER_Y = 300 * 65536 + 12345;

static void *room_for(size_t n)
{
    void *p = calloc(1, n);

    if (!p) {
        fprintf(stderr, "lab: out of memory\n");
        exit(2);
    }
    return p;
}

/* ---- bullets against a player ---- */

/* What a search did: bullets or boxes looked at, bullets tested exactly, and the hits. */
struct search {
    uint64_t looked, tested;
    uint32_t *hit;
    uint32_t hits;
};

struct field {
    struct board *b;
    uint32_t n;
    struct search found;
    /* grid */
    uint32_t *start; /* COLS * ROWS + 1 */
    uint32_t *order;
    /* tree */
    uint32_t *key, *order2, *key2;
    struct box *nodes; /* 1 is the root, 2i and 2i + 1 are the children of i */
    uint32_t leaves;   /* a power of two */
};

static void test(struct field *f, uint32_t i)
{
    const struct bullets *s = &f->b->bullets;

    f->found.tested++;
    if (geom_swept_circles((int64_t)s->x[i] - s->vx[i] - PLAYER_X, (int64_t)s->y[i] - s->vy[i] - PLAYER_Y, s->vx[i],
                           s->vy[i], (BULLET_R + PLAYER_R) * 65536))
        f->found.hit[f->found.hits++] = i;
}

static bool is_near(const struct bullets *s, uint32_t i)
{
    return geom_gap(s->x[i], PLAYER_X) <= REACH && geom_gap(s->y[i], PLAYER_Y) <= REACH;
}

static void begin(struct field *f)
{
    f->found.looked = f->found.tested = 0;
    f->found.hits = 0;
}

static void engine_search(void *data)
{
    struct field *f = data;

    f->b->counts.tested = 0;
    lab_sink = engine_hits(f->b);
}

static void plain_search(void *data)
{
    struct field *f = data;

    begin(f);
    for (uint32_t i = 0; i < f->n; i++)
        test(f, i);
    f->found.looked = f->n;
}

/* Indices by cell: a counting sort. */
static void grid_build(void *data)
{
    struct field *f = data;
    const struct bullets *s = &f->b->bullets;
    uint32_t at[COLS * ROWS + 1];

    memset(at, 0, sizeof at);
    for (uint32_t i = 0; i < f->n; i++)
        at[(s->y[i] >> CELL_BITS) * COLS + (s->x[i] >> CELL_BITS) + 1]++;
    for (int c = 0; c < COLS * ROWS; c++)
        at[c + 1] += at[c];
    memcpy(f->start, at, sizeof at);
    for (uint32_t i = 0; i < f->n; i++)
        f->order[at[(s->y[i] >> CELL_BITS) * COLS + (s->x[i] >> CELL_BITS)]++] = i;
    lab_sink = f->order[0];
}

static void grid_query(void *data)
{
    struct field *f = data;

    begin(f);
    for (int row = (PLAYER_Y - REACH) >> CELL_BITS; row <= (PLAYER_Y + REACH) >> CELL_BITS; row++) {
        uint32_t k = f->start[row * COLS + ((PLAYER_X - REACH) >> CELL_BITS)];
        uint32_t end = f->start[row * COLS + ((PLAYER_X + REACH) >> CELL_BITS) + 1];
        for (; k < end; k++) {
            f->found.looked++;
            if (is_near(&f->b->bullets, f->order[k]))
                test(f, f->order[k]);
        }
    }
}

static void grid_search(void *data)
{
    grid_build(data);
    grid_query(data);
}

/* The low 10 bits of v, a zero before each. */
static uint32_t spread(uint32_t v)
{
    v = (v | v << 8) & 0x00ff00ff;
    v = (v | v << 4) & 0x0f0f0f0f;
    v = (v | v << 2) & 0x33333333;
    return (v | v << 1) & 0x55555555;
}

static void radix_pass(const uint32_t *key, const uint32_t *order, uint32_t *key2, uint32_t *order2, uint32_t n,
                       int shift)
{
    uint32_t at[1025] = { 0 };

    for (uint32_t i = 0; i < n; i++)
        at[(key[i] >> shift & 1023) + 1]++;
    for (int i = 0; i < 1024; i++)
        at[i + 1] += at[i];
    for (uint32_t i = 0; i < n; i++) {
        uint32_t to = at[key[i] >> shift & 1023]++;
        key2[to] = key[i];
        order2[to] = order[i];
    }
}

static void tree_build(void *data)
{
    struct field *f = data;
    const struct bullets *s = &f->b->bullets;
    const struct box nothing = { FX_MAX, FX_MAX, FX_MIN, FX_MIN };

    for (uint32_t i = 0; i < f->n; i++) {
        f->key[i] = spread((uint32_t)s->x[i] >> 16) | spread((uint32_t)s->y[i] >> 16) << 1;
        f->order[i] = i;
    }
    radix_pass(f->key, f->order, f->key2, f->order2, f->n, 0);
    radix_pass(f->key2, f->order2, f->key, f->order, f->n, 10);
    for (uint32_t leaf = 0; leaf < f->leaves; leaf++) {
        struct box box = nothing;
        for (uint32_t k = leaf * LEAF; k < leaf * LEAF + LEAF && k < f->n; k++) {
            uint32_t i = f->order[k];
            box = (struct box){ fx_min(box.x0, s->x[i]), fx_min(box.y0, s->y[i]), fx_max(box.x1, s->x[i]),
                                fx_max(box.y1, s->y[i]) };
        }
        f->nodes[f->leaves + leaf] = box;
    }
    for (uint32_t i = f->leaves - 1; i > 0; i--) {
        const struct box *a = &f->nodes[2 * i], *b = a + 1;
        f->nodes[i] =
            (struct box){ fx_min(a->x0, b->x0), fx_min(a->y0, b->y0), fx_max(a->x1, b->x1), fx_max(a->y1, b->y1) };
    }
    lab_sink = f->nodes[1].x0;
}

static void tree_query(void *data)
{
    struct field *f = data;
    uint32_t stack[64], depth = 0;

    begin(f);
    stack[depth++] = 1;
    while (depth) {
        uint32_t i = stack[--depth];
        const struct box *box = &f->nodes[i];
        f->found.looked++;
        if (box->x0 > PLAYER_X + REACH || box->x1 < PLAYER_X - REACH || box->y0 > PLAYER_Y + REACH ||
            box->y1 < PLAYER_Y - REACH)
            continue;
        if (i < f->leaves) {
            stack[depth++] = 2 * i;
            stack[depth++] = 2 * i + 1;
            continue;
        }
        for (uint32_t k = (i - f->leaves) * LEAF; k < (i - f->leaves) * LEAF + LEAF && k < f->n; k++) {
            f->found.looked++;
            if (is_near(&f->b->bullets, f->order[k]))
                test(f, f->order[k]);
        }
    }
}

static void tree_search(void *data)
{
    tree_build(data);
    tree_query(data);
}

/* Bullets all over the field. */
static void field_open(struct field *f, uint32_t n)
{
    struct rng r;

    memset(f, 0, sizeof *f);
    f->n = n;
    f->b = engine_power(n, 0, 0);
    f->found.hit = room_for(n * sizeof(uint32_t));
    f->start = room_for((COLS * ROWS + 1) * sizeof(uint32_t));
    f->order = room_for(n * sizeof(uint32_t));
    f->order2 = room_for(n * sizeof(uint32_t));
    f->key = room_for(n * sizeof(uint32_t));
    f->key2 = room_for(n * sizeof(uint32_t));
    for (f->leaves = 1; f->leaves * LEAF < n;)
        f->leaves *= 2;
    f->nodes = room_for(2 * f->leaves * sizeof *f->nodes);
    rng_seed(&r, n);
    engine_player(f->b, PX(PLAYER_R), PLAYER_X, PLAYER_Y, 0, 0);
    uint16_t kind = engine_circle(&f->b->bullet_kinds, PX(BULLET_R), true);
    for (uint32_t i = 0; i < n; i++) {
        fx x = (fx)rng_below(&r, FIELD_W << 16), y = (fx)rng_below(&r, FIELD_H << 16);
        fx vx = (fx)rng_below(&r, 2 * FASTEST << 16) - PX(FASTEST),
           vy = (fx)rng_below(&r, 2 * FASTEST << 16) - PX(FASTEST);
        engine_bullet(&f->b->bullets, kind, x, y, vx, vy);
    }
}

static void field_close(struct field *f)
{
    engine_free(f->b);
    free(f->found.hit);
    free(f->start);
    free(f->order);
    free(f->order2);
    free(f->key);
    free(f->key2);
    free(f->nodes);
}

static int by_index(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;

    return (x > y) - (x < y);
}

/* Did the search find the bullets that the engine's events name? */
static bool same_hits(struct field *f)
{
    const struct events *e = &f->b->events;
    bool same = e->n == f->found.hits;

    qsort(f->found.hit, f->found.hits, sizeof *f->found.hit, by_index);
    for (uint32_t i = 0; same && i < e->n; i++)
        same = handle_slot(e->b[i]) == f->found.hit[i];
    return same;
}

enum { SIZES = 6, WAYS = 4, ENGINE = 0, PLAIN, GRID, TREE, GRID_QUERY = 4, TREE_QUERY, TIMED };
static const uint32_t SIZE[SIZES] = { 1024, 4096, 16384, 65536, 262144, 1048576 };
static void (*const WAY[TIMED])(void *) = { engine_search, plain_search, grid_search,
                                            tree_search,   grid_query,   tree_query };

struct result {
    uint32_t hits;
    uint64_t looked[WAYS], tested[WAYS];
    struct lab_rival times[TIMED];
};
static struct result results[SIZES];

static void measure_field(struct result *r, uint32_t n)
{
    struct field f;

    field_open(&f, n);
    engine_search(&f);
    r->hits = f.b->events.n;
    r->looked[ENGINE] = n;
    r->tested[ENGINE] = f.b->counts.tested;
    for (int w = 1; w < WAYS; w++) {
        WAY[w](&f);
        r->looked[w] = f.found.looked;
        r->tested[w] = f.found.tested;
        lab_claim(same_hits(&f), "every search finds the same bullets");
    }
    /* The queries that are timed alone need what was built last: the tree and the grid share `order`. */
    for (int w = 0; w < TIMED; w++)
        r->times[w] = (struct lab_rival){ .run = WAY[w], .data = &f, .ops = 1000 }; /* in us */
    lab_time(r->times, WAYS, ENGINE);
    grid_build(&f);
    lab_time(&r->times[GRID_QUERY], 1, 0);
    tree_build(&f);
    lab_time(&r->times[TREE_QUERY], 1, 0);
    field_close(&f);
}

/* ---- shots against enemies ---- */

enum {
    CROWDS = 9,
    SHOT_CELL = 32,
    SHOT_COLS = FIELD_W / SHOT_CELL,
    SHOT_ROWS = FIELD_H / SHOT_CELL,
    SHOT_HALF = 4,
    SHOT_SPEED = 12
};
static const uint32_t CROWD[CROWDS][3] = { { 16, 8, 12 },     { 64, 16, 12 },     { 256, 16, 12 },
                                           { 256, 64, 12 },   { 256, 256, 12 },   { 1024, 256, 12 },
                                           { 4096, 256, 12 }, { 1024, 1024, 12 }, { 512, 256, 65 } };

struct crowd {
    struct board *b;
    uint32_t m, k, half; /* half an enemy's side */
    uint32_t start[SHOT_COLS * SHOT_ROWS + 1];
    uint32_t *list; /* enemies by cell, in slot order */
    int32_t *first; /* the enemy each shot hits, or NO_SLOT: of several the one it was nearest to */
    uint64_t best;  /* the square of that distance */
    uint64_t tested;
};

static bool shot_touches(struct crowd *c, uint32_t i, uint32_t k)
{
    const struct bullets *s = &c->b->shots;
    const struct enemies *e = &c->b->enemies;

    c->tested++;
    return geom_swept_boxes((int64_t)s->x[i] - s->vx[i] - e->x[k], (int64_t)s->y[i] - s->vy[i] - e->y[k], s->vx[i],
                            s->vy[i], (SHOT_HALF + c->half) << 16, (SHOT_HALF + c->half) << 16);
}

static void crowd_engine(void *data)
{
    struct crowd *c = data;

    lab_sink = engine_hits(c->b);
}

/* Shot i and enemy k: enemies stand. */
static void meet(struct crowd *c, uint32_t i, uint32_t k)
{
    const struct bullets *s = &c->b->shots;
    uint64_t apart =
        fx_length_squared(s->x[i] - s->vx[i] - c->b->enemies.x[k], s->y[i] - s->vy[i] - c->b->enemies.y[k]);

    if (apart < c->best && shot_touches(c, i, k)) {
        c->best = apart;
        c->first[i] = (int32_t)k;
    }
}

static void crowd_plain(void *data)
{
    struct crowd *c = data;

    c->tested = 0;
    for (uint32_t i = 0; i < c->m; i++) {
        c->first[i] = NO_SLOT;
        c->best = UINT64_MAX;
        for (uint32_t k = 0; k < c->k; k++)
            meet(c, i, k);
    }
    lab_sink = c->first[0];
}

/* near[i] is 1 where enemy i may be within reach of (px, py): 32-bit arithmetic that need not mind wrapping. */
static uint8_t close_block(const fx *restrict x, const fx *restrict y, uint8_t *restrict near, fx px, fx py,
                           uint32_t reach)
{
    const uint32_t left = (uint32_t)px - reach, top = (uint32_t)py - reach;
    uint8_t any = 0;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        near[i] = (uint8_t)(((uint32_t)x[i] - left <= 2 * reach) & ((uint32_t)y[i] - top <= 2 * reach));
        any |= near[i];
    }
    return any;
}

/* A reject of what is too far away, in blocks of 64, then the exact test. Enemies have no holes here. */
static void crowd_reject(void *data)
{
    struct crowd *c = data;
    const struct bullets *s = &c->b->shots;
    const struct enemies *e = &c->b->enemies;
    const uint32_t reach = (SHOT_HALF + c->half + SHOT_SPEED) << 16;
    uint8_t near[SLOTS_BLOCK];

    c->tested = 0;
    for (uint32_t i = 0; i < c->m; i++) {
        c->first[i] = NO_SLOT;
        c->best = UINT64_MAX;
        for (uint32_t k = 0; k < c->k; k += SLOTS_BLOCK) {
            if (!close_block(e->x + k, e->y + k, near, s->x[i], s->y[i], reach))
                continue;
            for (uint32_t n = 0; n < SLOTS_BLOCK; n++)
                if (near[n] && k + n < c->k)
                    meet(c, i, k + n);
        }
    }
    lab_sink = c->first[0];
}

/* The cells an enemy can be hit in: by shots whose middle is there at the end of the frame. */
static void cells_of(const struct crowd *c, uint32_t k, int *x0, int *x1, int *y0, int *y1)
{
    const int grown = SHOT_HALF + (int)c->half + SHOT_SPEED + 1;
    int x = c->b->enemies.x[k] >> 16, y = c->b->enemies.y[k] >> 16;

    *x0 = int_clamp((x - grown) / SHOT_CELL, 0, SHOT_COLS - 1);
    *x1 = int_clamp((x + grown) / SHOT_CELL, 0, SHOT_COLS - 1);
    *y0 = int_clamp((y - grown) / SHOT_CELL, 0, SHOT_ROWS - 1);
    *y1 = int_clamp((y + grown) / SHOT_CELL, 0, SHOT_ROWS - 1);
}

static void crowd_grid(void *data)
{
    struct crowd *c = data;
    uint32_t at[SHOT_COLS * SHOT_ROWS + 1];
    int x0, x1, y0, y1;

    memset(at, 0, sizeof at);
    for (uint32_t k = 0; k < c->k; k++) {
        cells_of(c, k, &x0, &x1, &y0, &y1);
        for (int y = y0; y <= y1; y++)
            for (int x = x0; x <= x1; x++)
                at[y * SHOT_COLS + x + 1]++;
    }
    for (int i = 0; i < SHOT_COLS * SHOT_ROWS; i++)
        at[i + 1] += at[i];
    memcpy(c->start, at, sizeof at);
    for (uint32_t k = 0; k < c->k; k++) {
        cells_of(c, k, &x0, &x1, &y0, &y1);
        for (int y = y0; y <= y1; y++)
            for (int x = x0; x <= x1; x++)
                c->list[at[y * SHOT_COLS + x]++] = k;
    }
    c->tested = 0;
    for (uint32_t i = 0; i < c->m; i++) {
        int cell = (c->b->shots.y[i] >> 16) / SHOT_CELL * SHOT_COLS + (c->b->shots.x[i] >> 16) / SHOT_CELL;
        c->first[i] = NO_SLOT;
        c->best = UINT64_MAX;
        for (uint32_t k = c->start[cell]; k < c->start[cell + 1]; k++)
            meet(c, i, c->list[k]);
    }
    lab_sink = c->first[0];
}

static bool same_firsts(const struct crowd *c)
{
    const struct events *e = &c->b->events;
    uint32_t n = 0;
    bool same = true;

    for (uint32_t i = 0; i < c->m; i++) {
        if (c->first[i] == NO_SLOT)
            continue;
        same = same && n < e->n && handle_slot(e->a[n]) == i && handle_slot(e->b[n]) == (uint32_t)c->first[i];
        n++;
    }
    return same && n == e->n;
}

static void crowd_open(struct crowd *c, uint32_t m, uint32_t k, uint32_t half)
{
    struct rng r;

    memset(c, 0, sizeof *c);
    c->m = m;
    c->k = k;
    c->half = half;
    c->b = engine_power(64, m, k);
    c->list = room_for(64 * k * sizeof *c->list);
    c->first = room_for(m * sizeof *c->first);
    rng_seed(&r, m * k);
    uint16_t shot = engine_box(&c->b->shot_kinds, PX(SHOT_HALF), PX(SHOT_HALF), true);
    uint16_t enemy = engine_enemy(c->b, (fx)(half << 16), (fx)(half << 16));
    for (uint32_t i = 0; i < m; i++) {
        fx x = (fx)rng_below(&r, FIELD_W << 16), y = (fx)rng_below(&r, FIELD_H << 16);
        engine_bullet(&c->b->shots, shot, x, y, 0, -PX(SHOT_SPEED));
    }
    for (uint32_t i = 0; i < k; i++) {
        fx x = (fx)rng_below(&r, FIELD_W << 16), y = (fx)rng_below(&r, FIELD_H / 2 << 16);
        enemies_spawn(&c->b->enemies, &c->b->enemy_kinds, enemy, x, y, 0);
    }
}

enum { CROWD_WAYS = 4 };
struct crowd_result {
    uint32_t hits;
    uint64_t tested[CROWD_WAYS]; /* not the engine's: it keeps no count */
    struct lab_rival times[CROWD_WAYS];
};
static struct crowd_result crowds[CROWDS];

static void measure_crowd(struct crowd_result *r, const uint32_t size[3])
{
    static void (*const RUN[CROWD_WAYS])(void *) = { crowd_engine, crowd_reject, crowd_grid, crowd_plain };
    struct crowd c;

    crowd_open(&c, size[0], size[1], size[2]);
    crowd_engine(&c);
    r->hits = c.b->events.n;
    for (int w = 0; w < CROWD_WAYS; w++) {
        if (w != ENGINE) {
            RUN[w](&c);
            r->tested[w] = c.tested;
            lab_claim(same_firsts(&c), "every way finds the engine's pairs");
        }
        r->times[w] = (struct lab_rival){ .run = RUN[w], .data = &c, .ops = 1000 };
    }
    lab_time(r->times, CROWD_WAYS, ENGINE);
    engine_free(c.b);
    free(c.list);
    free(c.first);
}

/* ---- the page ---- */

/* Players from which on building pays: build + p * query < p * scan. */
static double worth_from(const struct result *r, int whole, int query)
{
    double build = r->times[whole].ns - r->times[query].ns, gain = r->times[ENGINE].ns - r->times[query].ns;

    return gain > 0 ? build / gain : 1.0 / 0.0;
}

/* What building costs at 16,384 bullets, in scans. */
static double scans(int whole, int query)
{
    const struct result *r = &results[2];

    return (r->times[whole].ns - r->times[query].ns) / r->times[ENGINE].ns;
}

static void print_ways(void)
{
    static const struct {
        const char *name, *trade, *who;
    } NAMES[WAYS] = {
        { "scan with rejection in blocks of 64", "nothing", "everything" },
        { "scan that tests each bullet exactly", "the quick rejection", "avoid" },
        { "grid of 16 px", "the time for a sort in every frame", "four or more players against the same bullets" },
        { "tree of boxes", "the time for a longer sort in every frame",
          "stationary bullets, or a world many times larger than the field" },
    };
    const struct result *r = &results[2];

    report_table(report_string("One frame with one player and %s bullets", report_count(SIZE[2])),
                 "method | gives up | pairs found> | bullets looked at> | tested exactly> | time> | ratio> | use");
    for (int w = 0; w < WAYS; w++)
        report_row(w == ENGINE, NAMES[w].name, NAMES[w].trade, report_count(r->hits),
                   report_count((int64_t)r->looked[w]), report_count((int64_t)r->tested[w]), lab_us(&r->times[w]),
                   lab_ratio(&r->times[w]), NAMES[w].who, NULL);
    report_table_end();
}

static void print_sizes(void)
{
    report_table(
        "Time for n bullets; in parentheses, the time without building the grid or tree",
        "n> | pairs> | scan, engine> | exact scan> | grid> | tree> | grid pays off from> | tree pays off from>");
    for (int i = 0; i < SIZES; i++) {
        const struct result *r = &results[i];
        report_row(false, report_count(SIZE[i]), report_count(r->hits),
                   report_string("**%s**", lab_us(&r->times[ENGINE])), lab_us(&r->times[PLAIN]),
                   report_string("%s (%s)", lab_us(&r->times[GRID]), lab_us(&r->times[GRID_QUERY])),
                   report_string("%s (%s)", lab_us(&r->times[TREE]), lab_us(&r->times[TREE_QUERY])),
                   report_string("%s players", lab_about(worth_from(r, GRID, GRID_QUERY))),
                   report_string("%s players", lab_about(worth_from(r, TREE, TREE_QUERY))), NULL);
    }
    report_table_end();
}

static void print_crowds(void)
{
    report_table("Number of exact tests for m shots and k enemies that are h px across; each shot hits the nearest "
                 "enemy it touches",
                 "m> | k> | h> | shots that hit> | rejection in blocks of 64> | grid of 32 px> | every pair>");
    for (int i = 0; i < CROWDS; i++) {
        const struct crowd_result *r = &crowds[i];
        report_row(false, report_count(CROWD[i][0]), report_count(CROWD[i][1]), report_count(2 * CROWD[i][2]),
                   report_count(r->hits), report_count((int64_t)r->tested[1]), report_count((int64_t)r->tested[2]),
                   report_count((int64_t)r->tested[3]), NULL);
    }
    report_table_end();
    report_table("Time per frame for the same shots and enemies",
                 "m> | k> | h> | engine: grid, nearest first> | rejection in blocks of 64> | ratio> "
                 "| grid of 32 px> | ratio> | every pair> | ratio>");
    for (int i = 0; i < CROWDS; i++) {
        const struct lab_rival *t = crowds[i].times;
        report_row(false, report_count(CROWD[i][0]), report_count(CROWD[i][1]), report_count(2 * CROWD[i][2]),
                   report_string("**%s**", lab_us(&t[0])), lab_us(&t[1]), lab_ratio(&t[1]), lab_us(&t[2]),
                   lab_ratio(&t[2]), lab_us(&t[3]), lab_ratio(&t[3]), NULL);
    }
    report_table_end();
}

static void print_shots(void)
{
    print_crowds();
    report_text("The engine sorts the enemies into a grid with about one enemy per cell, by their positions before "
                "they moved. Each shot\n"
                "searches four cells first, then rings of cells around them, and stops at the nearest enemy it hits. "
                "In the last row, a\n"
                "tenth of all pairs touch, but the engine still tests only a few of them.\n"
                "\n"
                "The grid of 32 px puts each enemy into every cell in which a shot can hit it, so it suits only small "
                "enemies. The\n"
                "engine's times include looking up kinds and shapes and raising events; the other times do not.");
}

static void plot_sizes(void)
{
    static const char *const NAMES[WAYS] = { "scan, the engine", "exact scan", "grid, built each frame",
                                             "tree, built each frame" };
    double x[SIZES], y[SIZES];

    report_plot(&(struct report_plot){
        .file = "broad",
        .title = "One player against n bullets: one frame",
        .x_name = "bullets",
        .y_name = "time, µs",
        .timed = true,
        .described = "Time by number of bullets: the engine's scan is fastest at every size, then the grid, the exact "
                     "scan and the tree",
    });
    for (int w = 0; w < WAYS; w++) {
        for (int i = 0; i < SIZES; i++) {
            x[i] = SIZE[i];
            y[i] = results[i].times[w].ns;
        }
        report_plot_line(NAMES[w], w == ENGINE, x, y, SIZES);
    }
    report_plot_end();
}

/* The engine's way is the fastest for one player, at every size. */
static bool scan_wins(void)
{
    bool wins = true;

    for (int i = 0; i < SIZES; i++)
        for (int w = 1; w < WAYS; w++)
            wins &= results[i].times[w].ratio > 1.1;
    return wins;
}

/* The fewest and the most players from which on a grid pays. */
static const char *grid_pays(void)
{
    double least = 1e9, most = 0;

    for (int i = 0; i < SIZES; i++) {
        double players = worth_from(&results[i], GRID, GRID_QUERY);
        least = players < least ? players : least;
        most = players > most ? players : most;
    }
    return report_string("%s to %s", lab_about(least), lab_about(most));
}

void section_broad(void)
{
    for (int i = 0; i < SIZES; i++)
        measure_field(&results[i], SIZE[i]);
    for (int i = 0; i < CROWDS; i++)
        measure_crowd(&crowds[i], CROWD[i]);

    report_section("6. Finding the pairs");
    report_text("Bullets with a radius of 4 px move at up to 3 px/frame all over a field of %d x %d px; the player has "
                "a radius of 2\n"
                "px. *Rejection in blocks of 64* is a quick test that discards distant bullets, 64 at a time. "
                "Everything moves, so a grid\n"
                "or tree is rebuilt in every frame. All methods find the same pairs.",
                FIELD_W, FIELD_H);
    print_ways();
    plot_sizes();
    print_sizes();
    report_text(
        "Building the grid for %s bullets takes as long as %s scans, and building the tree takes as long as %s scans.\n"
        "The grid and the tree copy every bullet to a different place in memory, while the scan reads memory "
        "sequentially. For\n"
        "one player, the scan is fastest at every size. Depending on the number of bullets, a grid breaks even at %s\n"
        "players, but the engine supports at most %d.",
        report_count(SIZE[2]), lab_about(scans(GRID, GRID_QUERY)), lab_about(scans(TREE, TREE_QUERY)), grid_pays(),
        MAX_PLAYERS);
    print_shots();
    lab_conclude(
        "bullets against players", "a scan of all bullets",
        report_string("fastest for one player with %s to %s bullets; a grid would pay off only with %s or more players",
                      report_count(SIZE[0]), report_count(SIZE[SIZES - 1]),
                      lab_about(worth_from(&results[2], GRID, GRID_QUERY))),
        "none", lab_exact() || scan_wins());
    lab_conclude("shots against enemies", "a grid of the enemies' positions, searched from the shot outwards",
                 report_string("256 shots and 64 enemies take %s µs of the %s µs in a frame; %s shots and %s enemies "
                               "take %s µs if a tenth of all pairs overlap",
                               lab_about(crowds[3].times[0].ns), report_count(FRAME_US), report_count(CROWD[8][0]),
                               report_count(CROWD[8][1]), lab_about(crowds[8].times[0].ns)),
                 "scan all enemies: less code, and no grid to build in every frame",
                 lab_exact() || (crowds[3].times[1].ratio > 1 && crowds[8].times[1].ratio > 4));
}

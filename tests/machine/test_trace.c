/*
 * test_trace.c - board_trace, trace.h and bisect.h: the trace is all of the hash; and one bit planted anywhere in it is
 * named by frame, part, slot and column, with both values.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp, dup2 */
#include <unistd.h>
#include "../../src/workbench/verify/bisect.h"
#include "../../src/demo/trace.h"
#include "rig.h"
#include "../temp.h"

static char dir[256], out[8192];

static const char *file(const char *name)
{
    static char path[4][300];
    static int i;

    i = (i + 1) % 4;
    snprintf(path[i], sizeof path[i], "%s/%s", dir, name);
    return path[i];
}

static int setup(void **state)
{
    (void)state;
    return temp_folder(dir, sizeof dir, "Trace") ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    remove(file("a"));
    remove(file("b"));
    remove(file("out"));
    return rmdir(dir);
}

/* A board in the middle of a game, by the game's own demo. */
static void play(struct rig *r, const struct rig_game *g, const char *demo_name, uint32_t frames)
{
    static struct demo d;
    uint16_t pads[MAX_PLAYERS];

    assert_true(rig_demo(g, demo_name, &d));
    rig_power(r, g, &d.start);
    for (uint32_t f = 0; f < frames; f++) {
        demo_pads(&d, f, pads);
        rig_tick(r, pads);
    }
    demo_free(&d);
}

/* ---- the trace is what is hashed ---- */

struct folded {
    uint64_t h;
    int64_t slot;
    uint64_t values;
};

static void fold(void *context, const struct slots_value *v)
{
    struct folded *f = context;

    if (v->slot != f->slot && v->gen)
        f->h = hash_fold(f->h, (uint64_t)v->gen << 32 | (uint64_t)v->slot);
    f->slot = v->slot;
    f->h = hash_fold(f->h, v->value);
    f->values++;
    assert_true(v->i < v->n && (v->width == 8 || v->value >> 8 * v->width == 0));
}

TEST(all_of_the_hash)
{
    static const struct {
        const char *game, *demo;
        uint32_t frames;
    } rows[] = { { "glasstide", "run", 900 }, { "torture", "torture", 300 }, { "testcard", "card", 100 } };

    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        struct rig_game g;
        struct rig r;
        rig_folder(&g, rows[k].game);
        play(&r, &g, rows[k].demo, rows[k].frames);
        for (int i = 0; i < PART_COUNT; i++) {
            struct folded f = { .h = HASH_START, .slot = NO_SLOT };
            board_trace(r.b, i, fold, &f);
            if (!board_part_hash(r.b, i)) { /* a part that this game has no room for */
                assert_true(i >= FIRST_OPTIONAL_PART && f.values == 0);
                continue;
            }
            if (f.h != board_part_hash(r.b, i))
                fail_msg("%s: the trace of %s is not what is hashed", rows[k].game, board_part_name(r.b, i));
            assert_true(f.values >= 2);
        }
        rig_free(&r);
        rig_game_free(&g);
    }
}

/* ---- bisect ---- */

static void print_trace(const char *name, const char *mode, const struct board *b, uint64_t parts_wanted)
{
    FILE *f = fopen(file(name), mode);

    assert_non_null(f);
    trace_frame(f, b, parts_wanted);
    assert_int_equal(fclose(f), 0);
}

/* bisect_paths of two files; what it prints is in out. */
static enum result bisect(const char *a, const char *b)
{
    char err[2200];

    fflush(stdout);
    int was = dup(STDOUT_FILENO);
    assert_non_null(freopen(file("out"), "w", stdout));
    enum result result = bisect_paths(file(a), file(b), err, sizeof err);
    fflush(stdout);
    dup2(was, STDOUT_FILENO);
    close(was);
    FILE *f = fopen(file("out"), "r");
    out[fread(out, 1, sizeof out - 1, f)] = 0;
    fclose(f);
    return result;
}

/* A value as traces have it. */
static void spell(char *to, size_t size, uint64_t v, int width)
{
    int n = snprintf(to, size, "%0*llx", width * 2, (unsigned long long)v);
    long long decimal = width == 1 ? (int8_t)v : width == 2 ? (int16_t)v : (int32_t)v;

    if (width < 8 && v > 9)
        snprintf(to + n, size - (size_t)n, "(%lld)", decimal);
}

/* The name that a trace has for a column of bullets: of a value, the game's. */
static const char *column_name(const char *part, const char *column)
{
    static const char *const values[] = { "rest", "home_x", "home_y", "sway" }; /* as Glass Tide declares them */

    bool value = !strcmp(part, "bullets") && !strncmp(column, "value", 5);
    return value ? values[column[5] - '1'] : column;
}

/* The one difference there may be. */
static void named(uint32_t frame, const char *part, int64_t slot, const struct column *c, int i, uint64_t was,
                  uint64_t is)
{
    char want[1024], at[64] = "", index[32] = "", a[64], b[64];

    if (slot >= 0)
        snprintf(at, sizeof at, " %lld", (long long)slot);
    if (c->n > 1)
        snprintf(index, sizeof index, "[%d]", i);
    spell(a, sizeof a, was, c->width);
    spell(b, sizeof b, is, c->width);
    snprintf(want, sizeof want, "first difference: frame %u\n  %s%s %s%s: %s in %s, %s in %s\n", (unsigned)frame, part,
             at, column_name(part, c->name), index, a, file("a"), b, file("b"));
    assert_string_equal(out, want);
}

static uint64_t load(const uint8_t *p, int width)
{
    uint64_t v8;
    uint32_t v4;
    uint16_t v2;

    if (width == 1)
        return *p;
    if (width == 2)
        return memcpy(&v2, p, 2), v2;
    if (width == 4)
        return memcpy(&v4, p, 4), v4;
    return memcpy(&v8, p, 8), v8;
}

static void store(uint8_t *p, int width, uint64_t v)
{
    uint8_t v1 = (uint8_t)v;
    uint16_t v2 = (uint16_t)v;
    uint32_t v4 = (uint32_t)v;

    memcpy(p,
           width == 1   ? (void *)&v1
           : width == 2 ? (void *)&v2
           : width == 4 ? (void *)&v4
                        : (void *)&v,
           (size_t)width);
}

/* Flips a bit of the value at p for as long as the second of two traces is printed. */
static void plant(struct rig *r, int part, int64_t slot, const struct column *c, int i, uint8_t *p, struct rng *rng)
{
    uint64_t was = load(p, c->width), is = was ^ 1ull << rng_below(rng, c->width * 8);
    uint64_t only = (uint64_t)1 << part;

    store(p, c->width, is);
    print_trace("b", "w", r->b, only);
    store(p, c->width, was);
    assert_int_equal(bisect("a", "b"), RESULT_DIFFERS);
    if (slot >= 0 && machine_parts[part].chip->is_list &&
        (was == 0 || is == 0)) { /* an entry may have become all zero */
        char start[64];
        const char *name = board_part_name(r->b, part);
        snprintf(start, sizeof start, "\n  %s %lld %s", name, (long long)slot, column_name(name, c->name));
        assert_non_null(strstr(out, start));
        return;
    }
    named(board_frame(r->b), board_part_name(r->b, part), slot, c, i, was, is);
}

/* A live slot, any of them. */
static int64_t some_slot(const struct slots *s, struct rng *rng)
{
    uint32_t end = s->live_bits ? s->top : s->live, i;

    if (s->live == 0)
        return NO_SLOT;
    do
        i = slots_next(s, (uint32_t)rng_below(rng, end));
    while (i >= end);
    return i;
}

/* Plants a bit in every register and column of a part, in slots by chance; returns how many. A part
 * without room has none. */
static int plant_part(struct rig *r, int part, struct rng *rng)
{
    uint8_t *self = (uint8_t *)r->b + machine_parts[part].offset;
    const struct chip *chip = machine_parts[part].chip;
    int planted = 0;

    if (!board_part_hash(r->b, part))
        return 0;
    print_trace("a", "w", r->b, (uint64_t)1 << part);
    assert_int_equal(bisect("a", "a"), RESULT_DONE);
    for (int k = 0; k < chip->count; k++) {
        const struct column *c = &chip->columns[k];
        int64_t slot = c->is_register ? NO_SLOT : some_slot((struct slots *)self, rng);
        int i = (int)rng_below(rng, c->n);
        uint8_t *column = self + c->offset;
        if (!slots_has_column(c, ((struct slots *)self)->groups) || c->kind != COL_GAME ||
            (!c->is_register && slot < 0) || column == (uint8_t *)&r->b->core.frame)
            continue; /* the frame is what lines are compared by */
        if (!c->is_register)
            memcpy(&column, self + c->offset, sizeof column);
        plant(r, part, slot, c, i, column + ((size_t)(slot < 0 ? 0 : slot) * c->n + (size_t)i) * c->width, rng);
        planted++;
    }
    return planted;
}

TEST(planted)
{
    struct rig_game g;
    struct rig r;
    struct rng rng;
    int planted = 0;

    rig_folder(&g, "glasstide");
    rng_seed(&rng, 5);
    for (uint32_t frame = 700; frame <= 2000; frame += 650) {
        play(&r, &g, "run", frame);
        for (int part = 0; part < PART_COUNT; part++)
            if (board_part_hash(r.b, part)) /* else it is not there */
                planted += plant_part(&r, part, &rng);
        rig_free(&r);
    }
    assert_true(planted > 300);
    rig_game_free(&g);
}

/* A bit that is planted while the game runs on: the frame is the first of many that differ. */
TEST(first_frame)
{
    static const char text[] =
        "bullet.def(\"orb\", { sprite = \"dot\", hit = \"none\" })\n"
        "for i = 1, 20 do bullet.fire { kind = \"orb\", x = 20, y = 10 * i, speed = 0.5, dir = 0 } end";
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, text);
    for (uint32_t at = 1; at <= 60; at += 59) {
        uint32_t x = 0;
        remove(file("a"));
        remove(file("b"));
        for (int with = 0; with < 2; with++) {
            rig_power(&r, &g, NULL);
            for (uint32_t f = 0; f <= 90; f++) {
                if (with && f == at) {
                    x = (uint32_t)r.b->bullets.x[13];
                    r.b->bullets.x[13] ^= 1 << 4;
                }
                print_trace(with ? "b" : "a", "a", r.b, UINT64_MAX);
                rig_tick(&r, none);
            }
            rig_free(&r);
        }
        assert_int_equal(bisect("a", "b"), RESULT_DIFFERS);
        named(at, "bullets", 13, &(struct column){ .name = "x", .width = 4, .n = 1 }, 0, x, x ^ 1 << 4);
    }
    rig_game_free(&g);
}

/* One that is alive in one trace only, and a slot with another tenant. */
TEST(who_lives)
{
    static const char text[] = "bullet.def(\"orb\", { sprite = \"dot\", hit = \"none\" })\n"
                               "for i = 1, 20 do bullet.fire { kind = \"orb\", x = 20, y = 10 * i, speed = 0 } end";
    struct rig_game g;
    struct rig r;
    char want[1024];

    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 5);
    print_trace("a", "w", r.b, UINT64_MAX);
    r.b->bullets.s.gen[4] = 9;
    print_trace("b", "w", r.b, UINT64_MAX);
    assert_int_equal(bisect("a", "b"), RESULT_DIFFERS);
    snprintf(want, sizeof want, "first difference: frame 5\n  bullets 4 generation: 1 in %s, 9 in %s\n", file("a"),
             file("b"));
    assert_string_equal(out, want);
    r.b->bullets.s.gen[4] = 1;
    for (uint32_t slot = 0; slot < 20; slot += 19) {
        r.b->bullets.s.live_bits[0] ^= 1ull << slot;
        print_trace("b", "w", r.b, UINT64_MAX);
        r.b->bullets.s.live_bits[0] ^= 1ull << slot;
        assert_int_equal(bisect("a", "b"), RESULT_DIFFERS);
        snprintf(want, sizeof want, "first difference: frame 5\n  bullets %u is alive only in %s (generation 1)\n",
                 (unsigned)slot, file("a"));
        assert_string_equal(out, want);
        assert_int_equal(bisect("b", "a"), RESULT_DIFFERS);
        assert_string_equal(out, want);
    }
    rig_free(&r);
    rig_game_free(&g);
}

RUN_TESTS(setup, teardown)

/*
 * test_trace.c - board_trace, trace.h and bisect.h: the trace is all of the hash, and a value that differs is named by
 * frame, part, slot and column, with both values.
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
        rig_close(&r);
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

static const char orbs[] =
    "bullet.def('orb', { sprite = 'dot', hit = 'none' })\n"
    "for i = 1, 20 do bullet.fire { kind = 'orb', x = 20, y = 10 * i, speed = 0.5, dir = 0 } end";

/* What bisect prints of a and b; the format has both paths. */
static void differs(const char *a, const char *b, const char *format)
{
    char want[1024];

    snprintf(want, sizeof want, format, file("a"), file("b"));
    assert_int_equal(bisect(a, b), RESULT_DIFFERS);
    assert_string_equal(out, want);
}

/* A bit that is planted while the game runs on: the frame is the first of many that differ. */
TEST(first_frame)
{
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, orbs);
    remove(file("a"));
    remove(file("b"));
    for (int with = 0; with < 2; with++) {
        rig_power(&r, &g, NULL);
        for (uint32_t f = 0; f <= 90; f++) {
            if (with && f == 60)
                r.b->bullets.x[13] ^= 1 << 4;
            print_trace(with ? "b" : "a", "a", r.b, UINT64_MAX);
            rig_run(&r, 1);
        }
        rig_free(&r);
    }
    differs("a", "b",
            "first difference: frame 60\n"
            "  bullets 13 x: 00320000(3276800) in %s, 00320010(3276816) in %s\n");
    rig_game_free(&g);
}

/* One that is alive in one trace only, and a slot with another tenant. */
TEST(who_lives)
{
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, orbs);
    rig_power(&r, &g, NULL);
    rig_run(&r, 5);
    print_trace("a", "w", r.b, UINT64_MAX);
    r.b->bullets.s.gen[4] = 9;
    print_trace("b", "w", r.b, UINT64_MAX);
    differs("a", "b", "first difference: frame 5\n  bullets 4 generation: 1 in %s, 9 in %s\n");
    r.b->bullets.s.gen[4] = 1;
    r.b->bullets.s.live_bits[0] ^= 1;
    print_trace("b", "w", r.b, UINT64_MAX);
    differs("a", "b", "first difference: frame 5\n  bullets 0 is alive only in %s (generation 1)\n");
    differs("b", "a", "first difference: frame 5\n  bullets 0 is alive only in %s (generation 1)\n");
    rig_close(&r);
}

/* Entries of lists, which are printed unless all is zero, and registers. */
TEST(lists_and_registers)
{
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, orbs);
    rig_power(&r, &g, NULL);
    print_trace("a", "w", r.b, UINT64_MAX);
    r.b->bullet_kinds.a[0] = 3;
    print_trace("b", "w", r.b, UINT64_MAX);
    differs("a", "b", "first difference: frame 0\n  bullet_kinds 0 a: 00000000 in %s, 00000003 in %s\n");
    r.b->bullet_kinds.a[0] = 0;
    r.b->fix.code[7] = 'A';
    print_trace("b", "w", r.b, UINT64_MAX);
    differs("a", "b", "first difference: frame 0\n  fix 7 code: 0 in %s, 41(65) in %s\n");
    r.b->fix.code[7] = 0;
    r.b->core.clock = 9;
    print_trace("b", "w", r.b, UINT64_MAX);
    differs("a", "b", "first difference: frame 0\n  board clock: 00000000 in %s, 00000009 in %s\n");
    rig_close(&r);
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

RUN_TESTS(setup, teardown)

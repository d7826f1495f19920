/*
 * test_desync.c - replay.h: a demo with a flipped input bit, another seed, or played on a ROM with a changed script
 * byte is found to differ at the very frame and in the very parts at which two boards run side by side first do; or
 * they never do, and it holds.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include <unistd.h>
#include "../../src/player/replay.h"
#include "rig.h"
#include "../temp.h"

enum { FLIPS = 200, FRAMES = 1200, MOST = 1 << 20 };

static struct rig_game game;
static struct demo original; /* the beginning of the game's attract demo, in the newest format */
static uint8_t bytes[MOST];  /* its file */
static size_t size;
static char err[512];

static int setup(void **state)
{
    static struct demo attract;
    static struct demo_writer again;
    static struct replay r;
    struct verdict v;
    char dir[256], path[300];

    (void)state;
    if (!temp_folder(dir, sizeof dir, "Desync"))
        return -1;
    snprintf(path, sizeof path, "%s/demo", dir);
    rig_folder(&game, "glasstide");
    if (!rig_demo(&game, "attract", &attract))
        return -1;
    r.checksum_rate = DEMO_CHECKSUMS_EVERY_FRAME;
    if (replay_run(&r, &game.cart, &attract, &again, &v, err, sizeof err) != RESULT_DONE || v.kind != VERDICT_HOLDS)
        return -1;
    struct demo *first = &again.demo; /* of it the first frames will do */
    first->frames = first->checksum_frames = FRAMES;
    first->n_rows = FRAMES / DEMO_SECOND_FRAMES + 1;
    while (first->n_markers > 0 && first->markers[first->n_markers - 1].frame > FRAMES)
        first->n_markers--;
    if (!demo_save(first, path, err, sizeof err))
        return -1;
    FILE *f = fopen(path, "rb");
    size = fread(bytes, 1, sizeof bytes, f);
    fclose(f);
    remove(path);
    rmdir(dir);
    demo_free(&attract);
    demo_free(&again.demo);
    replay_close(&r);
    if (size == MOST || !demo_read(&original, bytes, size, err, sizeof err))
        return -1;
    return original.frames == FRAMES && original.complete && original.format == DEMO_FORMAT ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    demo_free(&original);
    rig_game_free(&game);
    return 0;
}

/* ---- side by side ---- */

/* A board, and its hashes frame after frame. */
struct runner {
    struct rig rig;
    uint64_t hashes[MAX_PARTS];
    void *copies; /* of board_hashes_cached */
};

static void start(struct runner *r, const struct rig_game *g, const struct board_start *how)
{
    rig_power_any(&r->rig, g, how);
    r->copies = calloc(1, board_hash_cache_size(r->rig.b));
}

static void stop(struct runner *r)
{
    free(r->copies);
    rig_free(&r->rig);
}

/* The parts that differ between two boards. */
static uint64_t differing(struct runner *a, struct runner *b)
{
    uint64_t parts_differ = 0;

    board_hashes_cached(a->rig.b, a->copies, a->hashes);
    board_hashes_cached(b->rig.b, b->copies, b->hashes);
    for (int i = 0; i < PART_COUNT; i++)
        parts_differ |= (uint64_t)(a->hashes[i] != b->hashes[i]) << i;
    return parts_differ;
}

/* Runs both on, each with its pads, from the frame where they are to the first that differs. */
static struct verdict lockstep(struct runner *a, const struct demo *da, struct runner *b, const struct demo *db)
{
    struct verdict v = { .kind = VERDICT_HOLDS, .first = da->frames, .frame = da->frames };
    uint16_t pads[MAX_PLAYERS];

    for (uint32_t f = board_frame(a->rig.b); f <= da->frames; f++) {
        bool fault = rig_fault(&b->rig) != NULL;
        v.parts = fault ? 0 : differing(a, b);
        if (v.parts || fault) {
            v.kind = fault ? VERDICT_FAULT : VERDICT_DIFFERS;
            v.first = v.frame = f;
            return v;
        }
        demo_pads(da, f, pads);
        rig_tick(&a->rig, pads);
        demo_pads(db, f, pads);
        board_tick(b->rig.b, pads);
    }
    return v;
}

static void same_verdict(const struct verdict *got, const struct verdict *want, const char *what, uint64_t which)
{
    if (got->kind != want->kind || got->first != want->first || got->frame != want->frame || got->parts != want->parts)
        fail_msg("%s %llu: verdict %d, frames %u to %u, parts %llx; side by side %d, frame %u, parts %llx", what,
                 (unsigned long long)which, got->kind, got->first, got->frame, (unsigned long long)got->parts,
                 want->kind, want->frame, (unsigned long long)want->parts);
}

/* ---- flipped bits ---- */

/* Makes all CRCs good again. */
static void repair(uint8_t *p, size_t n)
{
    uint32_t crc = 0;

    for (size_t at = 8; at < n; at += 12 + bytes_get32(p + at + 4)) {
        crc = hash_crc32_add(crc, p + at, 8 + bytes_get32(p + at + 4));
        bytes_put32(p + at + 8 + bytes_get32(p + at + 4), crc);
    }
}

/* The i-th record of seconds. */
static size_t second_at(uint32_t i)
{
    size_t at = 8;

    for (;; at += 12 + bytes_get32(bytes + at + 4))
        if (bytes[at] == 'S' && i-- == 0)
            return at;
}

/* A byte and bit of a run of pads, any run of any second. */
static size_t some_pad(struct rng *rng, uint8_t *bit)
{
    size_t at = second_at(1 + (uint32_t)rng_below(rng, FRAMES / 60)) + 8;
    size_t run = at + 8 + 6 * rng_below(rng, bytes[at + 5]), player = rng_below(rng, 2),
           b = rng_below(rng, PAD_BUTTON_COUNT);

    *bit = (uint8_t)(1 << b % 8);
    return run + 2 + 2 * player + b / 8;
}

/* The first frame whose pads differ. */
static uint32_t first_other(const struct demo *d)
{
    uint32_t f = 0;

    while (f < d->frames && memcmp(d->pads[f], original.pads[f], sizeof d->pads[f]) == 0)
        f++;
    return f;
}

struct flip {
    struct demo demo;
    uint32_t first;
};

static int by_first(const void *a, const void *b)
{
    const struct flip *x = *(struct flip *const *)a, *y = *(struct flip *const *)b;

    return (x->first > y->first) - (x->first < y->first);
}

static struct flip *flip(struct rng *rng)
{
    struct flip *f = calloc(1, sizeof *f);
    uint8_t *copy = malloc(size), bit;
    size_t at = some_pad(rng, &bit);

    memcpy(copy, bytes, size);
    copy[at] ^= bit;
    assert_false(demo_read(&f->demo, copy, size, err, sizeof err)); /* not repaired: refused */
    assert_non_null(strstr(err, "CRC"));
    repair(copy, size);
    if (!demo_read(&f->demo, copy, size, err, sizeof err))
        fail_msg("%s", err);
    f->first = first_other(&f->demo);
    assert_true(f->first < FRAMES);
    free(copy);
    return f;
}

/* Both boards run on with the same pads to the frame. */
static void advance(struct runner *a, struct runner *b, uint32_t frame)
{
    uint16_t pads[MAX_PLAYERS];

    while (board_frame(a->rig.b) < frame) {
        demo_pads(&original, board_frame(a->rig.b), pads);
        rig_tick(&a->rig, pads);
        rig_tick(&b->rig, pads);
    }
}

/* In the order of their frames, so that the two boards go through the run once. */
TEST(flips)
{
    static struct replay r;
    struct flip *flips[FLIPS];
    struct runner a, b;
    struct rng rng;

    rng_seed(&rng, 11);
    for (int i = 0; i < FLIPS; i++)
        flips[i] = flip(&rng);
    qsort(flips, FLIPS, sizeof flips[0], by_first);
    start(&a, &game, &original.start);
    start(&b, &game, &original.start);
    for (int i = 0; i < FLIPS; i++) {
        struct verdict got, want;
        advance(&a, &b, flips[i]->first);
        rig_save(&a.rig);
        rig_save(&b.rig);
        want = lockstep(&a, &original, &b, &flips[i]->demo);
        rig_restore(&a.rig);
        rig_restore(&b.rig);
        assert_int_equal(replay_run(&r, &game.cart, &flips[i]->demo, NULL, &got, err, sizeof err), RESULT_DONE);
        same_verdict(&got, &want, "flip", (uint64_t)i);
        demo_free(&flips[i]->demo);
        free(flips[i]);
    }
    replay_close(&r);
    stop(&a);
    stop(&b);
}

/* A part that this build does not have differs from the start, also if its hash was 0; one that the demo does not have
 * is not asked for. */
TEST(parts)
{
    static struct replay r;
    struct verdict got;
    char was[sizeof original.part_name[0]];
    uint64_t *first = original.rows + 3, hash = *first;

    memcpy(was, original.part_name[3], sizeof was);
    snprintf(original.part_name[3], sizeof was, "parrots");
    assert_int_equal(replay_run(&r, &game.cart, &original, NULL, &got, err, sizeof err), RESULT_DONE);
    assert_true(got.kind == VERDICT_DIFFERS && got.frame == 0 && got.parts == 1u << 3 && got.missing == 1u << 3);
    *first = 0;
    assert_int_equal(replay_run(&r, &game.cart, &original, NULL, &got, err, sizeof err), RESULT_DONE);
    assert_true(got.kind == VERDICT_DIFFERS && got.frame == 0 && got.parts == 1u << 3 && got.missing == 1u << 3);
    *first = hash;
    memcpy(original.part_name[3], was, sizeof was);
    assert_int_equal(replay_run(&r, &game.cart, &original, NULL, &got, err, sizeof err), RESULT_DONE);
    assert_true(got.kind == VERDICT_HOLDS && got.missing == 0);
    replay_close(&r);
}

/* ---- changed scripts ---- */

RUN_TESTS(setup, teardown)

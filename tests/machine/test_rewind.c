/*
 * test_rewind.c - the past of a run: whatever way a frame is come back to, it is the frame that was. The hashes of a
 * run that goes straight on are the reference.
 */
#include "rig.h"
#include "../../src/demo/rewind.h"

enum { MIB = 1 << 20, PLENTY = 64 * MIB };

static struct rewind *open_past(size_t bytes)
{
    void *memory = malloc(bytes);

    assert_non_null(memory);
    return rewind_open(memory, bytes, 0);
}

/* ---- a run ---- */

enum { MOST_FRAMES = 20000 };

struct run {
    struct rig_game game;
    struct demo demo;
    uint32_t frames;
    uint16_t pads[MOST_FRAMES][MAX_PLAYERS];
    uint64_t hash[MOST_FRAMES + 1];
};

static struct run glasstide;

/* A run of the first frames of a demo. */
static void run_of_demo(struct run *run, const char *folder, const char *name, uint32_t frames)
{
    struct rig r;

    rig_folder(&run->game, folder);
    assert_true(rig_demo(&run->game, name, &run->demo));
    run->frames = frames < run->demo.frames ? frames : run->demo.frames;
    rig_power(&r, &run->game, &run->demo.start);
    for (uint32_t f = 0;; f++) {
        run->hash[f] = board_hash(r.b);
        if (f == run->frames)
            break;
        demo_pads(&run->demo, f, run->pads[f]);
        rig_tick(&r, run->pads[f]);
    }
    rig_free(&r);
}

static int open_runs(void **state)
{
    (void)state;
    run_of_demo(&glasstide, "glasstide", "run", rig_long() ? MOST_FRAMES : 4000);
    return 0;
}

static int close_runs(void **state)
{
    (void)state;
    demo_free(&glasstide.demo);
    rig_game_free(&glasstide.game);
    return 0;
}

static void same_frame(const struct run *run, const struct rig *r, uint32_t frame)
{
    assert_int_equal(board_frame(r->b), frame);
    if (board_hash(r->b) != run->hash[frame])
        fail_msg("frame %u is not the frame it was", frame);
}

static void check_keys(const struct rewind *p)
{
    assert_in_range(p->n, 0, p->slots);
    for (uint32_t i = 0; i < p->slots; i++) /* each slot is in the list once */
        for (uint32_t k = 0; k < i; k++)
            assert_int_not_equal(p->key[i].slot, p->key[k].slot);
    for (uint32_t i = 1; i < p->n; i++)
        assert_true(p->key[i - 1].frame < p->key[i].frame);
}

/* On by n frames of the run, as far as it goes. */
static void forward(struct rewind *p, const struct run *run, struct rig *r, uint32_t n)
{
    for (uint32_t f = board_frame(r->b); n-- > 0 && f < run->frames; f++) {
        assert_true(rewind_push(p, r->b, run->pads[f]));
        rig_tick(r, run->pads[f]);
    }
    assert_true(rewind_end(p) >= board_frame(r->b)); /* the same pads lead to the same future */
}

/* ---- walks ---- */

/* Where the next step leads: mostly near. */
static uint32_t somewhere(const struct rewind *p, const struct rig *r, struct rng *rng)
{
    uint32_t now = board_frame(r->b), first = rewind_first(p), end = rewind_end(p), span;

    switch (rng_below(rng, 64)) {
    case 0:
        return first + (uint32_t)rng_below(rng, end - first + 1);
    case 1:
        return first;
    case 2:
        return end;
    default:
        span = 1 + (uint32_t)rng_below(rng, 40);
        if (rng_below(rng, 3) == 0)
            return end - now < span ? end : now + span;
        return now - first < span ? first : now - span;
    }
}

static void walk(const struct run *run, size_t bytes, int steps, uint64_t seed)
{
    struct rewind *p = open_past(bytes);
    struct rng rng;
    struct rig r;

    rng_seed(&rng, seed);
    rig_power(&r, &run->game, &run->demo.start);
    forward(p, run, &r, run->frames / 2);
    for (int i = 0; i < steps; i++) {
        if (rng_below(&rng, 20) == 0)
            forward(p, run, &r, 1 + (uint32_t)rng_below(&rng, 100));
        else
            assert_true(rewind_to(p, r.b, somewhere(p, &r, &rng)));
        same_frame(run, &r, board_frame(r.b));
        check_keys(p);
    }
    free(p);
    rig_free(&r);
}

TEST(walks)
{
    int steps = rig_long() ? 20000 : 1500;

    walk(&glasstide, PLENTY, steps, 1);
    walk(&glasstide, 12 * MIB, steps, 2);
    walk(&glasstide, 6 * MIB, steps / 3, 3);
    walk(&glasstide, 3 * MIB, steps / 3, 4); /* one key frame has room */
}

/* ---- what it costs ---- */

/* Frame by frame from the end back to `to`; the most ticks that a step took. */
static uint64_t backwards(struct rewind *p, const struct run *run, struct rig *r, uint32_t to)
{
    uint64_t most = 0;

    for (uint32_t f = board_frame(r->b); f-- > to;) {
        uint64_t before = p->replayed;
        assert_true(rewind_to(p, r->b, f));
        same_frame(run, r, f);
        check_keys(p);
        most = p->replayed - before > most ? p->replayed - before : most;
    }
    return most;
}

/* A minute is there, and back through all of it no gap is run through again for every frame. */
TEST(a_minute_backwards)
{
    struct rewind *p = open_past(PLENTY);
    struct rig r;

    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    forward(p, &glasstide, &r, 3600);
    assert_int_equal(rewind_first(p), 0);
    assert_in_range(backwards(p, &glasstide, &r, 3540), 1, 32); /* the last second */
    assert_in_range(backwards(p, &glasstide, &r, 0), 1, 512);
    assert_in_range(p->replayed, 3600, 5 * 3600);
    forward(p, &glasstide, &r, 100);
    assert_int_equal(rewind_end(p), 3600); /* nothing was pressed that was not pressed then */
    uint64_t again = p->replayed;
    assert_true(rewind_to(p, r.b, 3600));
    same_frame(&glasstide, &r, 3600);
    /* A key frame near the end is still there: the last minute isn't computed again from its start. How far apart key
     * frames are depends on their sizes, and those of Lua's strings differ from run to run. */
    assert_in_range(p->replayed - again, 0, 1024);
    free(p);

    rig_free(&r);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    p = open_past(24 * MIB); /* with few key frames gaps are wide, and still run through only a few times */
    forward(p, &glasstide, &r, 2000);
    uint32_t reach = rewind_end(p) - rewind_first(p);
    backwards(p, &glasstide, &r, rewind_first(p));
    assert_in_range(reach, 1000, 2100);
    assert_in_range(p->replayed, reach, 20 * (uint64_t)reach);
    free(p);
    rig_free(&r);
}

/* Pads alone do not grow for ever either. */
TEST(pads_have_a_share)
{
    struct rig_game g;
    struct rig r;
    const uint16_t none[MAX_PLAYERS] = { 0 };

    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    const size_t bytes = board_snapshot_size(r.b) * 10;
    struct rewind *p = open_past(bytes);
    for (int i = 0; i < 100000; i++) {
        assert_true(rewind_push(p, r.b, none));
        rig_tick(&r, none);
    }
    check_keys(p);
    assert_true(p->pads_cap < 100000 && p->pads_cap * sizeof *p->pads <= bytes / 16);
    assert_true(rewind_first(p) > 0 && rewind_end(p) - rewind_first(p) > 1000);
    free(p);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- another future ---- */

TEST(taking_over)
{
    struct rewind *p = open_past(PLENTY);
    struct rig r, straight;
    struct rng rng;
    uint16_t pads[200][MAX_PLAYERS];

    rng_seed(&rng, 6);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    rig_power(&straight, &glasstide.game, &glasstide.demo.start);
    forward(p, &glasstide, &r, 900);
    assert_true(rewind_to(p, r.b, 700));
    for (uint32_t f = 0; f < 700; f++)
        rig_tick(&straight, glasstide.pads[f]);
    for (int i = 0; i < 200; i++) {
        rig_pads(&rng, pads[i]);
        assert_true(rewind_push(p, r.b, pads[i]));
        assert_int_equal(rewind_end(p), 701 + i);
        rig_tick(&r, pads[i]);
        rig_tick(&straight, pads[i]);
    }
    assert_true(board_hash(r.b) == board_hash(straight.b));
    assert_true(board_hash(r.b) != glasstide.hash[900]);
    assert_false(rewind_to(p, r.b, 901)); /* never was */
    assert_int_equal(board_frame(r.b), 900);
    assert_true(rewind_to(p, r.b, 650)); /* the past before is the old one */
    same_frame(&glasstide, &r, 650);
    assert_true(rewind_to(p, r.b, 900));
    assert_true(board_hash(r.b) == board_hash(straight.b));
    rewind_forget(p, 900);
    assert_int_equal(rewind_first(p), 900);
    assert_int_equal(rewind_end(p), 900);
    assert_false(rewind_to(p, r.b, 700));
    free(p);
    rig_free(&r);
    rig_free(&straight);
}

/* A board that is at a frame of no past begins one. */
TEST(another_place)
{
    struct rewind *p = open_past(PLENTY);
    struct rig r;
    const uint16_t none[MAX_PLAYERS] = { 0 };

    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    forward(p, &glasstide, &r, 100);
    rig_run(&r, 5); /* not pushed */
    assert_true(rewind_push(p, r.b, none));
    assert_int_equal(rewind_first(p), 105);
    assert_int_equal(rewind_end(p), 106);
    rig_tick(&r, none);
    assert_false(rewind_to(p, r.b, 100));
    assert_true(rewind_to(p, r.b, 105));
    assert_int_equal(board_frame(r.b), 105);
    free(p);
    rig_free(&r);
}

/* ---- faults ---- */

TEST(back_from_a_fault)
{
    static const char text[] = "task.go(function()\n"
                               "  for i = 1, 150 do board.note(i * rng.int(1, 1000)) wait(1) end\n"
                               "  error('the end')\n"
                               "end)\n";
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rewind *p = open_past(PLENTY);
    struct rig r;
    uint64_t hash[151];
    uint32_t dead = 0;

    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    while (!rig_fault(&r)) {
        dead = board_frame(r.b);
        assert_in_range(dead, 0, 150);
        hash[dead] = board_hash(r.b);
        assert_true(rewind_push(p, r.b, none));
        board_tick(r.b, none);
    }
    assert_int_equal(dead, 150);
    for (int again = 0; again < 3; again++) {
        for (uint32_t f = dead + 1; f-- > 0; f -= f % 7 ? 0 : f / 9) {
            assert_true(rewind_to(p, r.b, f));
            rig_sound(&r);
            assert_int_equal(board_frame(r.b), f);
            assert_true(board_hash(r.b) == hash[f]);
        }
        assert_false(rewind_to(p, r.b, dead + 1));
        assert_non_null(rig_fault(&r));
        assert_string_equal(rig_fault(&r)->message, "main.lua:3: the end");
    }
    free(p);
    rig_free(&r);
    rig_game_free(&g);
}

/* board.reset lays RAM out anew in the middle of a run. */
TEST(back_before_a_reset)
{
    static const char text[] = "board.note(save.get('n', 0))\n"
                               "local t = {}\n"
                               "task.go(function()\n"
                               "  for i = 1, forever do\n"
                               "    t[i] = ('%d'):format(rng.int(1, 1000)):rep(20)\n"
                               "    board.note(t[i])\n"
                               "    if pad.pressed 'fire' then save.set('n', save.get('n', 0) + i) board.reset() end\n"
                               "    wait(1)\n"
                               "  end\n"
                               "end)\n";
    struct rig_game g;
    struct rewind *p = open_past(PLENTY);
    struct rig r;
    struct rng rng;
    uint64_t hash[401];

    rng_seed(&rng, 8);
    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    for (uint32_t f = 0; f < 400; f++) {
        const uint16_t pads[MAX_PLAYERS] = { f % 90 == 77 ? PAD_FIRE : 0, 0 };
        hash[f] = board_hash(r.b);
        assert_true(rewind_push(p, r.b, pads));
        rig_tick(&r, pads);
    }
    hash[400] = board_hash(r.b);
    for (int i = 0; i < 600; i++) {
        uint32_t to = (uint32_t)rng_below(&rng, 401);
        assert_true(rewind_to(p, r.b, to));
        assert_true(board_frame(r.b) == to && board_hash(r.b) == hash[to]);
    }
    free(p);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- snapshots that grow ---- */

/* The slots are enlarged several times, while some of them are free. */
TEST(slots_grow)
{
    static const char text[] = "local t = {}\n"
                               "task.go(function()\n"
                               "  for i = 1, forever do\n"
                               "    t[i] = ('%d'):format(rng.int(1, 1000)):rep(500)\n"
                               "    board.note(t[i])\n"
                               "    wait(1)\n"
                               "  end\n"
                               "end)\n";
    enum { FRAMES = 400 };
    uint16_t pads[MAX_PLAYERS] = { 0 };
    struct rewind *p = open_past(10 * MIB);
    struct rig_game g;
    struct rig r;
    struct rng rng;
    uint64_t hash[FRAMES + 1];
    int grown = 0;
    size_t slot_size = 0;

    rng_seed(&rng, 9);
    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    for (uint32_t f = 0; f < FRAMES;) {
        hash[f] = board_hash(r.b);
        pads[0] ^= PAD_FIRE; /* drops the future after going back, and frees slots */
        assert_true(rewind_push(p, r.b, pads));
        rig_tick(&r, pads);
        hash[++f] = board_hash(r.b);
        check_keys(p);
        if (rng_below(&rng, 20) == 0)
            f -= (uint32_t)rng_below(&rng, f < 60 ? f + 1 : 60);
        else if (p->slot_size == slot_size)
            continue;
        grown += p->slot_size > slot_size;
        slot_size = p->slot_size;
        for (uint32_t i = 0; i < p->n; i++) {
            const uint32_t to = p->key[i].frame;
            assert_true(rewind_to(p, r.b, to));
            assert_true(board_frame(r.b) == to && board_hash(r.b) == hash[to]);
        }
        assert_true(rewind_to(p, r.b, f));
    }
    assert_true(grown > 3);
    free(p);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- memory that runs out ---- */

/* However little there is: every frame of the past comes back right, and without a key frame nothing is promised. */
static int play_lean(size_t bytes, int steps)
{
    struct rewind *p = open_past(bytes);
    struct rig r;
    struct rng rng;
    int without = 0;

    rng_seed(&rng, bytes);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    for (int i = 0; i < steps; i++) {
        uint32_t f = board_frame(r.b);
        if (rng_below(&rng, 60) > 0 && f < glasstide.frames) {
            if (!rewind_push(p, r.b, glasstide.pads[f])) {
                without++;
                assert_int_equal(p->n, 0);
                assert_false(rewind_to(p, r.b, f));
            }
            rig_tick(&r, glasstide.pads[f]);
        } else if (p->n > 0) {
            uint32_t span = rewind_end(p) - rewind_first(p), most = span < 90 ? span : 90;
            assert_true(rewind_to(p, r.b, rewind_end(p) - (uint32_t)rng_below(&rng, most + 1)));
        }
        same_frame(&glasstide, &r, board_frame(r.b));
        check_keys(p);
    }
    free(p);
    rig_free(&r);
    return without;
}

TEST(memory_runs_out)
{
    struct rig r;

    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    const size_t size = board_snapshot_size(r.b);
    rig_free(&r);
    assert_in_range(play_lean(size / 2, 500), 400, 500);
    assert_int_equal(play_lean(size * 4 / 3, 1500), 0);
    assert_int_equal(play_lean(size * 4, 1500), 0);
}

/* The key frames used last stay, whatever their gaps. */
TEST(recent_stay)
{
    enum { RECENT = 12, STEPS = 300 };
    const size_t bytes = 64 * MIB;
    void *memory = malloc(bytes);
    struct rig r;
    uint32_t removed = 0;

    assert_non_null(memory);
    struct rewind *p = rewind_open(memory, bytes, RECENT);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    for (uint32_t f = 0; f < STEPS; f++) {
        rewind_add(p, r.b, f % 2, true);
        rewind_add(p, r.b, f % 2, false); /* there already */
        for (uint32_t i = 0; i < RECENT && i <= f; i++) {
            assert_non_null(rewind_find(p, f - i, (f - i) % 2));
            assert_null(rewind_find(p, f - i, 2));
        }
        rig_tick(&r, glasstide.pads[f]);
    }
    for (uint32_t f = 0; f < STEPS; f++) {
        struct rewind_key *k = rewind_find(p, f, f % 2);
        removed += k == NULL;
        if (k) {
            rewind_restore(p, k, r.b);
            same_frame(&glasstide, &r, f);
        }
    }
    assert_in_range(removed, STEPS / 2, STEPS - RECENT);
    assert_in_range(p->key[0].frame, 0, STEPS / 8); /* and older ones with gaps that grow */
    free(p);
    rig_free(&r);
}

/* With space for two key frames, the one that was used stays, though it is the first and the gaps are wide. */
TEST(first_stays)
{
    const size_t most = 64 * MIB;
    void *memory = malloc(most);
    struct rewind *p;
    struct rig r;

    assert_non_null(memory);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    size_t bytes = board_snapshot_size(r.b);
    do {
        p = rewind_open(memory, bytes += 1 << 16, 2);
        rewind_add(p, r.b, 0, true);
    } while (p->slots < 2);
    assert_int_equal(p->slots, 2);
    for (uint32_t f = 0; f <= 400; f++) {
        if (f % 200 == 0)
            rewind_add(p, r.b, 0, false);
        rig_tick(&r, glasstide.pads[f]);
    }
    assert_non_null(rewind_find(p, 0, 0));
    free(memory);
    rig_free(&r);
}

RUN_TESTS(open_runs, close_runs)

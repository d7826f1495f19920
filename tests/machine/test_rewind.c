/*
 * test_rewind.c - the past of a run: whatever way a frame is come back to, it is the frame that was. The hashes of a
 * run that goes straight on are the reference.
 */
#include "rig.h"
#include "../../src/demo/rewind.h"

enum { MIB = 1 << 20, PLENTY = 64 * MIB };

static struct rewind *p;
static struct rig r;

/* A board at its start, and an empty past. */
static void begin(const struct rig_game *g, const struct board_start *start, size_t bytes, uint32_t recent)
{
    void *memory = malloc(bytes);

    assert_non_null(memory);
    p = rewind_open(memory, bytes, recent);
    rig_power(&r, g, start);
}

static void end(void)
{
    free(p);
    rig_free(&r);
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

static void begin_run(size_t bytes)
{
    begin(&glasstide.game, &glasstide.demo.start, bytes, 0);
}

static int open_runs(void **state)
{
    struct run *run = &glasstide;

    (void)state;
    rig_folder(&run->game, "glasstide");
    assert_true(rig_demo(&run->game, "run", &run->demo));
    run->frames = rig_long() ? run->demo.frames : 4000;
    assert_in_range(run->frames, 1, MOST_FRAMES);
    rig_power(&r, &run->game, &run->demo.start);
    for (uint32_t f = 0;; f++) {
        run->hash[f] = board_hash(r.b);
        if (f == run->frames)
            break;
        demo_pads(&run->demo, f, run->pads[f]);
        rig_tick(&r, run->pads[f]);
    }
    rig_free(&r);
    return 0;
}

static int close_runs(void **state)
{
    (void)state;
    demo_free(&glasstide.demo);
    rig_game_free(&glasstide.game);
    return 0;
}

static void same_frame(uint32_t frame, const uint64_t *hash)
{
    rig_sound(&r);
    assert_int_equal(board_frame(r.b), frame);
    if (board_hash(r.b) != hash[frame])
        fail_msg("frame %u is not the frame it was", frame);
}

static void check_keys(void)
{
    assert_in_range(p->n, 0, p->slots);
    for (uint32_t i = 0; i < p->slots; i++) /* each slot is in the list once */
        for (uint32_t k = 0; k < i; k++)
            assert_int_not_equal(p->key[i].slot, p->key[k].slot);
    for (uint32_t i = 1; i < p->n; i++)
        assert_true(p->key[i - 1].frame < p->key[i].frame);
}

static void go_to(uint32_t frame, const uint64_t *hash)
{
    assert_true(rewind_to(p, r.b, frame));
    same_frame(frame, hash);
    check_keys();
}

/* On by n frames of the run, as far as it goes. */
static void forward(uint32_t n)
{
    for (uint32_t f = board_frame(r.b); n-- > 0 && f < glasstide.frames; f++) {
        assert_true(rewind_push(p, r.b, glasstide.pads[f]));
        rig_tick(&r, glasstide.pads[f]);
    }
    assert_true(rewind_end(p) >= board_frame(r.b)); /* the same pads lead to the same future */
}

/* ---- walks ---- */

/* Where the next step leads: mostly near. */
static uint32_t somewhere(struct rng *rng)
{
    const uint32_t now = board_frame(r.b), first = rewind_first(p), end = rewind_end(p);
    const uint32_t span = 1 + (uint32_t)rng_below(rng, 40);

    switch (rng_below(rng, 32)) {
    case 0:
        return first + (uint32_t)rng_below(rng, end - first + 1);
    case 1:
        return end;
    default:
        if (rng_below(rng, 3) == 0)
            return end - now < span ? end : now + span;
        return now - first < span ? first : now - span;
    }
}

static void walk(size_t bytes, int steps)
{
    struct rng rng;

    rng_seed(&rng, bytes);
    begin_run(bytes);
    forward(glasstide.frames / 2);
    for (int i = 0; i < steps; i++)
        if (rng_below(&rng, 20) == 0)
            forward(1 + (uint32_t)rng_below(&rng, 100));
        else
            go_to(somewhere(&rng), glasstide.hash);
    end();
}

TEST(walks)
{
    const int steps = rig_long() ? 20000 : 1500;

    walk(PLENTY, steps);
    walk(6 * MIB, steps / 3);
    walk(3 * MIB, steps / 3); /* one key frame fits */
}

/* ---- what it costs ---- */

/* Frame by frame from the end back to `to`; the most ticks that a step took. */
static uint64_t backwards(uint32_t to)
{
    uint64_t most = 0;

    for (uint32_t f = board_frame(r.b); f-- > to;) {
        const uint64_t before = p->replayed;
        go_to(f, glasstide.hash);
        most = p->replayed - before > most ? p->replayed - before : most;
    }
    return most;
}

/* A minute is there, and back through all of it no gap is run through again for every frame. */
TEST(a_minute_backwards)
{
    begin_run(PLENTY);
    forward(3600);
    assert_int_equal(rewind_first(p), 0);
    assert_in_range(backwards(3540), 1, 32); /* the last second */
    assert_in_range(backwards(0), 1, 512);
    assert_in_range(p->replayed, 3600, 5 * 3600);
    forward(100);
    assert_int_equal(rewind_end(p), 3600);
    const uint64_t again = p->replayed;
    go_to(3600, glasstide.hash);
    /* A key frame near the end is still there: the last minute isn't computed again from its start. How far apart key
     * frames are depends on their sizes, and those of Lua's strings differ from run to run. */
    assert_in_range(p->replayed - again, 0, 1024);
    end();

    begin_run(24 * MIB); /* with few key frames gaps are wide, and still run through only a few times */
    forward(2000);
    const uint32_t reach = rewind_end(p) - rewind_first(p);
    backwards(rewind_first(p));
    assert_in_range(reach, 1000, 2100);
    assert_in_range(p->replayed, reach, 20 * (uint64_t)reach);
    end();
}

/* Pads alone do not grow forever either. */
TEST(pads_have_a_share)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };
    const size_t bytes = 5 * MIB;
    struct rig_game g;

    rig_script(&g, NULL, "");
    begin(&g, NULL, bytes, 0);
    for (int i = 0; i < 100000; i++) {
        assert_true(rewind_push(p, r.b, none));
        rig_tick(&r, none);
    }
    check_keys();
    assert_true(p->pads_cap < 100000 && p->pads_cap * sizeof *p->pads <= bytes / 16);
    assert_true(rewind_first(p) > 0 && rewind_end(p) - rewind_first(p) > 1000);
    end();
    rig_game_free(&g);
}

/* A board that is at a frame of no past begins one. */
TEST(another_place)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };

    begin_run(PLENTY);
    forward(100);
    rig_run(&r, 5); /* not pushed */
    assert_true(rewind_push(p, r.b, none));
    assert_int_equal(rewind_first(p), 105);
    assert_int_equal(rewind_end(p), 106);
    assert_false(rewind_to(p, r.b, 100));
    end();
}

/* board.reset lays RAM out again in the middle of a run, and a script's error ends it. */
TEST(back_from_a_reset_and_a_fault)
{
    static const char text[] = "board.note(save.get('n', 0))\n"
                               "local t = {}\n"
                               "task.go(function()\n"
                               "  for i = 1, 150 do\n"
                               "    t[i] = ('%d'):format(rng.int(1, 1000)):rep(20)\n"
                               "    board.note(t[i])\n"
                               "    if pad.pressed 'fire' then save.set('n', save.get('n', 0) + i) board.reset() end\n"
                               "    wait(1)\n"
                               "  end\n"
                               "  error('the end')\n"
                               "end)\n";
    struct rig_game g;
    struct rng rng;
    uint64_t hash[401];
    uint32_t dead = 0;

    rng_seed(&rng, 8);
    rig_script(&g, NULL, text);
    begin(&g, NULL, PLENTY, 0);
    while (!rig_fault(&r)) {
        const uint16_t pads[MAX_PLAYERS] = { dead == 77 || dead == 167 ? PAD_FIRE : 0 };
        dead = board_frame(r.b);
        assert_in_range(dead, 0, 400);
        hash[dead] = board_hash(r.b);
        assert_true(rewind_push(p, r.b, pads));
        board_tick(r.b, pads);
    }
    assert_true(dead > 167 + 149);
    for (int i = 0; i < 600; i++)
        go_to((uint32_t)rng_below(&rng, dead + 1), hash);
    assert_false(rewind_to(p, r.b, dead + 1));
    assert_non_null(rig_fault(&r));
    assert_string_equal(rig_fault(&r)->message, "main.lua:10: the end");
    end();
    rig_game_free(&g);
}

/* ---- snapshots that grow ---- */

/* After each step back there is another future. The slots are enlarged several times, while some of them are free. */
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
    enum { FRAMES = 360 };
    uint16_t pads[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rng rng;
    uint64_t hash[FRAMES + 1];
    int grown = 0;
    size_t slot_size = 0;

    rng_seed(&rng, 9);
    rig_script(&g, NULL, text);
    begin(&g, NULL, 10 * MIB, 0);
    for (uint32_t f = 0; f < FRAMES;) {
        hash[f] = board_hash(r.b);
        pads[0] ^= PAD_FIRE; /* drops the future after going back, and frees slots */
        assert_true(rewind_push(p, r.b, pads));
        rig_tick(&r, pads);
        hash[++f] = board_hash(r.b);
        check_keys();
        if (rng_below(&rng, 20) == 0)
            f -= (uint32_t)rng_below(&rng, f < 60 ? f + 1 : 60);
        else if (p->slot_size == slot_size)
            continue;
        grown += p->slot_size > slot_size;
        slot_size = p->slot_size;
        for (uint32_t i = 0; i < p->n; i++)
            go_to(p->key[i].frame, hash);
        go_to(f, hash);
    }
    assert_true(grown > 3);
    end();
    rig_game_free(&g);
}

/* ---- memory that runs out ---- */

/* However little there is: every frame of the past comes back right, and without a key frame nothing is promised. */
static int play_lean(size_t bytes, int steps)
{
    struct rng rng;
    int without = 0;

    rng_seed(&rng, bytes);
    begin_run(bytes);
    for (int i = 0; i < steps; i++) {
        const uint32_t f = board_frame(r.b);
        if (rng_below(&rng, 60) > 0 && f < glasstide.frames) {
            if (!rewind_push(p, r.b, glasstide.pads[f])) {
                without++;
                assert_int_equal(p->n, 0);
                assert_false(rewind_to(p, r.b, f));
            }
            rig_tick(&r, glasstide.pads[f]);
            same_frame(f + 1, glasstide.hash);
        } else if (p->n > 0) {
            const uint32_t span = rewind_end(p) - rewind_first(p), most = span < 90 ? span : 90;
            go_to(rewind_end(p) - (uint32_t)rng_below(&rng, most + 1), glasstide.hash);
        }
    }
    end();
    return without;
}

TEST(memory_runs_out)
{
    begin_run(MIB);
    const size_t size = board_snapshot_size(r.b);
    end();
    assert_in_range(play_lean(size / 2, 500), 400, 500);
    assert_int_equal(play_lean(size * 4 / 3, 1500), 0);
    assert_int_equal(play_lean(size * 4, 1500), 0);
}

/* The key frames used last stay, whatever their gaps. */
TEST(recent_stay)
{
    enum { RECENT = 12, STEPS = 300 };
    uint32_t removed = 0;

    begin(&glasstide.game, &glasstide.demo.start, PLENTY, RECENT);
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
            same_frame(f, glasstide.hash);
        }
    }
    assert_in_range(removed, STEPS / 2, STEPS - RECENT);
    assert_in_range(p->key[0].frame, 0, STEPS / 8); /* and older ones with gaps that grow */
    end();
}

/* With space for two key frames, the one that was used stays, though it is the first and the gaps are wide. */
TEST(first_stays)
{
    begin(&glasstide.game, &glasstide.demo.start, PLENTY, 2);
    size_t bytes = board_snapshot_size(r.b);
    do {
        p = rewind_open(p, bytes += 1 << 16, 2);
        rewind_add(p, r.b, 0, true);
    } while (p->slots < 2);
    for (uint32_t f = 0; f <= 400; f++) {
        if (f % 200 == 0)
            rewind_add(p, r.b, 0, false);
        rig_tick(&r, glasstide.pads[f]);
    }
    assert_non_null(rewind_find(p, 0, 0));
    end();
}

RUN_TESTS(open_runs, close_runs)

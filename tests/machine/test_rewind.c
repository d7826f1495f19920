/*
 * test_rewind.c - the past of a run: whatever way a frame is come back to, it is the frame that was. The hashes of a
 * run that goes straight on are the reference.
 */
#include "rig.h"
#include "../../src/cab/run/rewind.h"

/* ---- rewind.c once more, with memory that can run out ---- */

static uint64_t scarce_one_in; /* 0: there is enough; n: every nth request fails, by chance; 1: there is none */
static struct rng scarce_rng;

static void *scarce(size_t n)
{
    return scarce_one_in && rng_below(&scarce_rng, scarce_one_in) == 0 ? NULL : malloc(n);
}

#define malloc        scarce
#define rewind_open   lean_open
#define rewind_close  lean_close
#define rewind_push   lean_push
#define rewind_first  lean_first
#define rewind_end    lean_end
#define rewind_to     lean_to
#define rewind_drop   lean_drop
#define rewind_forget lean_forget
#define rewind_pads   lean_pads
#include "../../src/cab/run/rewind.c"
#undef malloc
#undef rewind_open
#undef rewind_close
#undef rewind_push
#undef rewind_first
#undef rewind_end
#undef rewind_to
#undef rewind_drop
#undef rewind_forget
#undef rewind_pads

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

static void in_budget(const struct rewind *p)
{
    size_t sum = p->pads_room * sizeof *p->pads;

    for (int i = 0; i < p->n; i++) {
        sum += p->key[i].room;
        assert_true(i == 0 || p->key[i - 1].frame < p->key[i].frame);
    }
    assert_int_equal(p->held, sum);
    assert_true(p->n <= 1 || p->held <= p->budget);
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

static void walk(const struct run *run, size_t budget, int steps, uint64_t seed)
{
    struct rewind p;
    struct rng rng;
    struct rig r;

    rng_seed(&rng, seed);
    rewind_open(&p, budget);
    rig_power(&r, &run->game, &run->demo.start);
    forward(&p, run, &r, run->frames / 2);
    for (int i = 0; i < steps; i++) {
        if (rng_below(&rng, 20) == 0)
            forward(&p, run, &r, 1 + (uint32_t)rng_below(&rng, 100));
        else
            assert_true(rewind_to(&p, r.b, somewhere(&p, &r, &rng)));
        same_frame(run, &r, board_frame(r.b));
        in_budget(&p);
    }
    rewind_close(&p);
    rewind_close(&p);
    rig_free(&r);
}

static void walks(void **state)
{
    int steps = rig_long() ? 20000 : 1500;

    (void)state;
    walk(&glasstide, REWIND_BYTES, steps, 1);
    walk(&glasstide, 12 << 20, steps, 2);
    walk(&glasstide, 3 << 20, steps / 3, 3);
    walk(&glasstide, 700000, steps / 3, 4); /* one key frame has room */
    walk(&glasstide, 0, steps / 3, 5);
}

/* ---- what it costs ---- */

/* Frame by frame from the end back to `to`; the most ticks that a step took. */
static uint64_t backwards(struct rewind *p, const struct run *run, struct rig *r, uint32_t to)
{
    uint64_t most = 0;

    for (uint32_t f = board_frame(r->b); f-- > to;) {
        uint64_t before = p->again;
        assert_true(rewind_to(p, r->b, f));
        same_frame(run, r, f);
        in_budget(p);
        most = p->again - before > most ? p->again - before : most;
    }
    return most;
}

/* A minute is there, and back through all of it no gap is run through again for every frame. */
static void a_minute_backwards(void **state)
{
    struct rewind p;
    struct rig r;

    (void)state;
    rewind_open(&p, REWIND_BYTES);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    forward(&p, &glasstide, &r, 3600);
    assert_int_equal(rewind_first(&p), 0);
    assert_in_range(backwards(&p, &glasstide, &r, 3540), 1, 32); /* the last second */
    assert_in_range(backwards(&p, &glasstide, &r, 0), 1, 512);
    assert_in_range(p.again, 3600, 5 * 3600);
    forward(&p, &glasstide, &r, 100);
    assert_int_equal(rewind_end(&p), 3600); /* nothing was pressed that was not pressed then */
    uint64_t again = p.again;
    assert_true(rewind_to(&p, r.b, 3600));
    same_frame(&glasstide, &r, 3600);
    /* A key frame near the end is still there: the last minute isn't computed again from its start. How far apart key
     * frames are depends on their sizes, and those of Lua's strings differ from run to run. */
    assert_in_range(p.again - again, 0, 1024);
    rewind_close(&p);

    rig_free(&r);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    rewind_open(&p, 24 << 20); /* with few key frames gaps are wide, and still run through only a few times */
    forward(&p, &glasstide, &r, 2000);
    uint32_t reach = rewind_end(&p) - rewind_first(&p);
    backwards(&p, &glasstide, &r, rewind_first(&p));
    assert_in_range(reach, 1000, 2100);
    assert_in_range(p.again, reach, 20 * (uint64_t)reach);
    rewind_close(&p);
    rig_free(&r);
}

/* Pads alone do not grow for ever either. */
static void pads_have_a_share(void **state)
{
    struct rewind p;
    struct rig_game g;
    struct rig r;
    const uint16_t none[MAX_PLAYERS] = { 0 };

    (void)state;
    rig_script(&g, NULL, "");
    rig_power(&r, &g, NULL);
    rewind_open(&p, board_snapshot_size(r.b) * 10);
    for (int i = 0; i < 100000; i++) {
        assert_true(rewind_push(&p, r.b, none));
        rig_tick(&r, none);
    }
    in_budget(&p);
    assert_true(p.pads_room < 100000 && p.pads_room * sizeof *p.pads <= p.budget / 8);
    assert_true(rewind_first(&p) > 0 && rewind_end(&p) - rewind_first(&p) > 1000);
    rewind_close(&p);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- another future ---- */

static void taking_over(void **state)
{
    struct rewind p;
    struct rig r, straight;
    struct rng rng;
    uint16_t pads[200][MAX_PLAYERS];

    (void)state;
    rng_seed(&rng, 6);
    rewind_open(&p, REWIND_BYTES);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    rig_power(&straight, &glasstide.game, &glasstide.demo.start);
    forward(&p, &glasstide, &r, 900);
    assert_true(rewind_to(&p, r.b, 700));
    for (uint32_t f = 0; f < 700; f++)
        rig_tick(&straight, glasstide.pads[f]);
    for (int i = 0; i < 200; i++) {
        rig_pads(&rng, pads[i]);
        assert_true(rewind_push(&p, r.b, pads[i]));
        assert_int_equal(rewind_end(&p), 701 + i);
        rig_tick(&r, pads[i]);
        rig_tick(&straight, pads[i]);
    }
    assert_true(board_hash(r.b) == board_hash(straight.b));
    assert_true(board_hash(r.b) != glasstide.hash[900]);
    assert_false(rewind_to(&p, r.b, 901)); /* never was */
    assert_int_equal(board_frame(r.b), 900);
    assert_true(rewind_to(&p, r.b, 650)); /* the past before is the old one */
    same_frame(&glasstide, &r, 650);
    assert_true(rewind_to(&p, r.b, 900));
    assert_true(board_hash(r.b) == board_hash(straight.b));
    rewind_drop(&p, 800);
    assert_int_equal(rewind_end(&p), 800);
    assert_false(rewind_to(&p, r.b, 801));
    rewind_forget(&p);
    assert_false(rewind_to(&p, r.b, 700));
    rewind_close(&p);
    rig_free(&r);
    rig_free(&straight);
}

/* A board that is at a frame of no past begins one. */
static void another_place(void **state)
{
    struct rewind p;
    struct rig r;
    const uint16_t none[MAX_PLAYERS] = { 0 };

    (void)state;
    rewind_open(&p, REWIND_BYTES);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    forward(&p, &glasstide, &r, 100);
    rig_run(&r, 5); /* not pushed */
    assert_true(rewind_push(&p, r.b, none));
    assert_int_equal(rewind_first(&p), 105);
    assert_int_equal(rewind_end(&p), 106);
    rig_tick(&r, none);
    assert_false(rewind_to(&p, r.b, 100));
    assert_true(rewind_to(&p, r.b, 105));
    assert_int_equal(board_frame(r.b), 105);
    rewind_close(&p);
    rig_free(&r);
}

/* ---- faults ---- */

static void back_from_a_fault(void **state)
{
    static const char text[] = "task.go(function()\n"
                               "  for i = 1, 150 do board.note(i * rng.int(1, 1000)) wait(1) end\n"
                               "  error('the end')\n"
                               "end)\n";
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rewind p;
    struct rig r;
    uint64_t hash[151];
    uint32_t dead = 0;

    (void)state;
    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rewind_open(&p, REWIND_BYTES);
    while (!rig_fault(&r)) {
        dead = board_frame(r.b);
        assert_in_range(dead, 0, 150);
        hash[dead] = board_hash(r.b);
        assert_true(rewind_push(&p, r.b, none));
        board_tick(r.b, none);
    }
    assert_int_equal(dead, 150);
    for (int again = 0; again < 3; again++) {
        for (uint32_t f = dead + 1; f-- > 0; f -= f % 7 ? 0 : f / 9) {
            assert_true(rewind_to(&p, r.b, f));
            rig_sound(&r);
            assert_int_equal(board_frame(r.b), f);
            assert_true(board_hash(r.b) == hash[f]);
        }
        assert_false(rewind_to(&p, r.b, dead + 1));
        assert_non_null(rig_fault(&r));
        assert_string_equal(rig_fault(&r)->message, "main.lua:3: the end");
    }
    rewind_close(&p);
    rig_free(&r);
    rig_game_free(&g);
}

/* board.reset lays RAM out anew in the middle of a run. */
static void back_before_a_reset(void **state)
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
    struct rewind p;
    struct rig r;
    struct rng rng;
    uint64_t hash[401];

    (void)state;
    rng_seed(&rng, 8);
    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rewind_open(&p, REWIND_BYTES);
    for (uint32_t f = 0; f < 400; f++) {
        const uint16_t pads[MAX_PLAYERS] = { f % 90 == 77 ? PAD_FIRE : 0, 0 };
        hash[f] = board_hash(r.b);
        assert_true(rewind_push(&p, r.b, pads));
        rig_tick(&r, pads);
    }
    hash[400] = board_hash(r.b);
    for (int i = 0; i < 600; i++) {
        uint32_t to = (uint32_t)rng_below(&rng, 401);
        assert_true(rewind_to(&p, r.b, to));
        assert_true(board_frame(r.b) == to && board_hash(r.b) == hash[to]);
    }
    rewind_close(&p);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- memory that runs out ---- */

/* Whatever of it there is: what is in the past comes back right, and without a key frame nothing is promised. */
static void lean(size_t budget, uint64_t one_in, int steps)
{
    struct rewind p;
    struct rig r;
    struct rng rng;
    int without = 0;

    rng_seed(&rng, one_in);
    rng_seed(&scarce_rng, one_in);
    lean_open(&p, budget);
    rig_power(&r, &glasstide.game, &glasstide.demo.start);
    for (int i = 0; i < steps; i++) {
        uint32_t f = board_frame(r.b);
        scarce_one_in = i % 500 < 400 ? one_in : i % 500 < 420 ? 1u : 0u;
        if (rng_below(&rng, 60) > 0 && f < glasstide.frames) {
            if (!lean_push(&p, r.b, glasstide.pads[f])) {
                without++;
                assert_int_equal(p.n, 0);
            }
            rig_tick(&r, glasstide.pads[f]);
        } else if (p.n > 0 && board_frame(r.b) <= lean_end(&p)) {
            uint32_t first = lean_first(&p), span = lean_end(&p) - first, most = span < 90 ? span : 90;
            assert_true(lean_to(&p, r.b, lean_end(&p) - (uint32_t)rng_below(&rng, most + 1)));
        }
        same_frame(&glasstide, &r, board_frame(r.b));
        in_budget(&p);
    }
    scarce_one_in = 0;
    assert_true(without > 0);
    lean_close(&p);
    rig_free(&r);
}

static void memory_runs_out(void **state)
{
    (void)state;
    lean(REWIND_BYTES, 3, 1500);
    lean(4 << 20, 2, 1500);
    lean(0, 2, 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walks),
        cmocka_unit_test(a_minute_backwards),
        cmocka_unit_test(pads_have_a_share),
        cmocka_unit_test(taking_over),
        cmocka_unit_test(another_place),
        cmocka_unit_test(back_from_a_fault),
        cmocka_unit_test(back_before_a_reset),
        cmocka_unit_test(memory_runs_out),
    };

    return cmocka_run_group_tests(tests, open_runs, close_runs);
}

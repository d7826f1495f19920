/*
 * test_lockstep.c - two boards with the same ROM and pads are the same in every part at every frame; what was recorded
 * plays again; and scripts that act differently differ in part `script` in that frame.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include <unistd.h>
#include "rig.h"
#include "../temp.h"

static char dir[256], path[300], err[512];

/* ---- two boards ---- */

static void lockstep(const char *name, int frames)
{
    struct rig_game g;
    struct rig a, b;
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    rig_folder(&g, name);
    rig_power(&a, &g, NULL);
    rig_power(&b, &g, NULL);
    rng_seed(&rng, 7);
    for (int f = 0; f <= frames; f++) {
        const char *part = rig_differs(&a, &b);
        if (part)
            fail_msg("%s: frame %d: part %s differs", name, f, part);
        assert_true(board_hash(a.b) == board_hash(b.b));
        if (f % 16 == 0)
            assert_true(rig_picture(&a) == rig_picture(&b));
        rig_pads(&rng, pads);
        rig_tick(&a, pads);
        rig_tick(&b, pads);
    }
    rig_free(&a);
    rig_free(&b);
    rig_game_free(&g);
}

TEST(torture)
{
    lockstep("torture", 1500);
}

TEST(glasstide)
{
    lockstep("glasstide", 3000);
}

/* Another seed, other pads: other hashes. A hash that never moves would pass everything above. */
TEST(hash_moves)
{
    struct rig_game g;
    struct rig a, b;
    struct board_start start = { .seed = 2, .difficulty = -1 };
    const uint16_t fire[MAX_PLAYERS] = { PAD_FIRE, 0 }, none[MAX_PLAYERS] = { 0 };

    rig_folder(&g, "torture");
    rig_power(&a, &g, NULL);
    rig_power(&b, &g, &start);
    assert_string_equal(rig_differs(&a, &b), "board");
    assert_true(board_hash(a.b) != board_hash(b.b));
    rig_free(&b);
    rig_power(&b, &g, NULL);
    rig_tick(&a, fire);
    rig_tick(&b, none);
    assert_non_null(rig_differs(&a, &b));
    uint64_t was = board_hash(a.b);
    rig_tick(&a, fire);
    assert_true(board_hash(a.b) != was);
    rig_free(&a);
    rig_free(&b);
    rig_game_free(&g);
}

/* ---- record, play, compare ---- */

enum { RECORDED = 1000 };

static void record(const struct rig_game *g, const struct board_start *start, struct demo_writer *w, const char *to)
{
    struct rig r;
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    rig_power(&r, g, start);
    rng_seed(&rng, 3);
    memset(w, 0, sizeof *w);
    assert_true(demo_begin(w, to, &g->cart, r.b, start, 0));
    for (int f = 0; f < RECORDED; f++) {
        rig_pads(&rng, pads);
        rig_tick(&r, pads);
        assert_true(demo_record_frame(w, r.b, pads));
    }
    assert_true(demo_end(w, r.b));
    rig_free(&r);
}

/* Plays a demo; the first frame that differs, and the first part that does; -1: it holds. */
static int play(const struct rig_game *g, const struct demo *d, const struct board_start *start, const char **part)
{
    struct rig r;
    uint64_t hashes[MAX_PARTS];
    uint16_t pads[MAX_PLAYERS];
    int wrong = -1;

    rig_power(&r, g, start);
    for (uint32_t f = 0; f <= d->frames && wrong < 0; f++) {
        board_hashes(r.b, hashes);
        uint64_t differ = demo_differing_parts(d, f, hashes);
        for (int i = d->n_parts - 1; i >= 0; i--)
            if (differ >> i & 1) {
                wrong = (int)f;
                *part = d->part_name[i];
            }
        demo_pads(d, f, pads);
        if (f < d->frames)
            rig_tick(&r, pads);
    }
    rig_free(&r);
    return wrong;
}

TEST(record_play)
{
    struct rig_game g;
    struct board_start start = { .seed = 99, .difficulty = -1 };
    struct demo_writer w;
    struct demo d;
    const char *part = NULL;

    rig_folder(&g, "torture");
    record(&g, &start, &w, path);
    assert_int_equal(w.demo.frames, RECORDED);
    assert_int_equal(w.demo.n_rows, (RECORDED + 59) / 60 + 1);
    assert_int_equal(play(&g, &w.demo, &w.demo.start, &part), -1);

    memset(&d, 0, sizeof d);
    assert_true(demo_load(&d, path, err, sizeof err));
    assert_true(d.complete && demo_check_cart(&d, &g.cart, err, sizeof err));
    assert_int_equal(d.start.seed, 99);
    assert_int_equal(play(&g, &d, &d.start, &part), -1);

    /* a pad that was not pressed, and a seed that was not drawn */
    d.pads[400][0] ^= PAD_FIRE;
    int frame = play(&g, &d, &d.start, &part);
    assert_true(frame > 400 && frame <= 420);
    d.pads[400][0] ^= PAD_FIRE;
    d.start.seed = 100;
    assert_int_equal(play(&g, &d, &d.start, &part), 0);
    demo_free(&d);
    demo_free(&w.demo);
    rig_game_free(&g);
}

/* ---- scripts that act differently ---- */

/* What a script does in frame `at` when the DIP says so. Nothing of it shows in any other part but where it says so. */
struct act {
    const char *name, *code;
    const char *other; /* another part that differs too, or NULL */
};

enum { AT = 137 };

static const struct act acts[] = {
    { "an argument", "mark.speed = odd and 0.0 or -0.0", NULL },
    { "a call more", "if odd then bullet.group():turn(0) end", NULL },
    { "another order", "if odd then mark:turn(0) mark.bank = 1 else mark.bank = 1 mark:turn(0) end", NULL },
    { "a draw of the dice", "if odd then rng.int(1, 6) end", "board" },
    { "a longer wait", "wait(odd and 3 or 2)", "tasks" },
    { "a task that starts", "if odd then task.go(function() end) end", "tasks" },
    { "a task that ends", "if odd then task.stop(other) end", "tasks" },
    { "a note", "board.note(odd)", "board" },
    { "a query", "query.near { what = 'bullet', x = odd and 1 or 2, y = 2, radius = 3 }", NULL },
    { "a write to the dead", "gone.x = odd and 1 or 2", NULL },
    { "a string", "bullet.group(odd and 'a' or 'b')", NULL },
};

static void game_of(struct rig_game *g, const struct act *act)
{
    static const char frame[] = "bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"
                                "local mark = bullet.fire { kind = 'dot', x = 50, y = 50, speed = 0 }\n"
                                "local gone = bullet.fire { kind = 'dot', x = 50, y = 50, speed = 0 }\n"
                                "bullet.group 'a' bullet.group 'b'\n"
                                "gone:remove()\n"
                                "local other = task.go(function() wait(forever) end)\n"
                                "task.go(function()\n"
                                "  local odd = board.dip 'odd' == 1\n"
                                "  wait(%d)\n"
                                "  %s\n"
                                "  while true do wait(1) end\n"
                                "end)\n";
    static char text[2048];
    struct manifest m = rig_manifest();

    snprintf(text, sizeof text, frame, AT - 1, act->code);
    m.n_dips = 1;
    snprintf(m.dips[0].name, sizeof m.dips[0].name, "odd");
    m.dips[0].is_number = true;
    m.dips[0].lo = 0;
    m.dips[0].hi = 1;
    rig_script(g, &m, text);
}

/* In the frame it happens, and not before, part `script` differs, and nothing else but `other`. */
static void diverges(const struct act *act)
{
    struct rig_game g;
    struct rig a, b;
    struct board_start start[2] = { { .seed = 1, .difficulty = -1 }, { .seed = 1, .difficulty = -1, .dip = { 1 } } };
    uint64_t ha[MAX_PARTS], hb[MAX_PARTS];

    game_of(&g, act);
    rig_power(&a, &g, &start[0]);
    rig_power(&b, &g, &start[1]);
    for (int f = 1; f < AT; f++) {
        rig_run(&a, 1);
        rig_run(&b, 1);
        if (rig_differs(&a, &b))
            fail_msg("%s: frame %d: part %s differs too soon", act->name, f, rig_differs(&a, &b));
    }
    rig_run(&a, 1);
    rig_run(&b, 1);
    board_hashes(a.b, ha);
    board_hashes(b.b, hb);
    for (int i = 0; i < board_part_count(a.b); i++) {
        const char *part = board_part_name(a.b, i);
        bool may = act->other && !strcmp(part, act->other), must = !strcmp(part, "script");
        if (must ? ha[i] == hb[i] : ha[i] != hb[i] && !may)
            fail_msg("%s: part %s %s", act->name, part, must ? "does not differ" : "differs");
    }
    assert_true(board_hash(a.b) != board_hash(b.b));
    rig_free(&a);
    rig_free(&b);
    rig_game_free(&g);
}

TEST(diverges)
{
    for (size_t i = 0; i < sizeof acts / sizeof *acts; i++)
        diverges(&acts[i]);
}

/* The same through a demo: it names frame and part. */
static void demo_diverges(const struct act *act)
{
    struct rig_game g;
    struct board_start start = { .seed = 1, .difficulty = -1 };
    struct demo_writer w;
    const char *part = NULL;

    game_of(&g, act);
    record(&g, &start, &w, NULL);
    assert_int_equal(play(&g, &w.demo, &start, &part), -1);
    start.dip[0] = 1;
    int frame = play(&g, &w.demo, &start, &part);
    if (frame != AT || strcmp(part, "script"))
        fail_msg("%s: frame %d: part %s", act->name, frame, part ? part : "none");
    demo_free(&w.demo);
    rig_game_free(&g);
}

TEST(demo_diverges)
{
    for (size_t i = 0; i < sizeof acts / sizeof *acts; i++)
        demo_diverges(&acts[i]);
}

static int setup(void **state)
{
    (void)state;
    if (!temp_folder(dir, sizeof dir, "lockstep"))
        return -1;
    snprintf(path, sizeof path, "%s/a.demo", dir);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    remove(path);
    rmdir(dir);
    return 0;
}

RUN_TESTS(setup, teardown)

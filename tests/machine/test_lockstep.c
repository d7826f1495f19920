/*
 * test_lockstep.c - two boards with the same ROM and pads are the same in every part at every frame; and scripts that
 * act differently differ in part `script` in that frame. test_desync.c records and compares demos of such runs.
 */
#include "rig.h"

TEST(lockstep)
{
    struct rig_game g;
    struct rig a, b;
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    rig_folder(&g, "torture");
    rig_power(&a, &g, NULL);
    rig_power(&b, &g, NULL);
    rng_seed(&rng, 7);
    for (int f = 0; f <= 1500; f++) {
        const char *part = rig_differs(&a, &b);
        if (part)
            fail_msg("frame %d: part %s differs", f, part);
        if (f % 16 == 0)
            assert_true(rig_picture(&a) == rig_picture(&b));
        rig_pads(&rng, pads);
        rig_tick(&a, pads);
        rig_tick(&b, pads);
    }
    rig_free(&a);
    rig_close(&b);
}

/* Another seed, other pads: other hashes. A hash that never moves would pass everything above. */
TEST(hash_moves)
{
    const struct board_start start = { .seed = 2, .difficulty = -1 };
    struct rig_game g;
    struct rig a, b, other;

    rig_folder(&g, "torture");
    rig_power(&a, &g, NULL);
    rig_power(&b, &g, NULL);
    rig_power(&other, &g, &start);
    assert_string_equal(rig_differs(&a, &other), "board");
    rig_tick(&a, (const uint16_t[MAX_PLAYERS]){ PAD_FIRE });
    rig_tick(&b, (const uint16_t[MAX_PLAYERS]){ 0 });
    assert_non_null(rig_differs(&a, &b));
    rig_free(&a);
    rig_free(&b);
    rig_close(&other);
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
    rig_close(&b);
}

TEST(diverges)
{
    for (size_t i = 0; i < sizeof acts / sizeof *acts; i++)
        diverges(&acts[i]);
}

RUN_TESTS(NULL, NULL)

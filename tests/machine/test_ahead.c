/*
 * test_ahead.c - a look at the next frame leaves nothing behind: hashes, what the last tick handed out, sound and the
 * past are those of a run that never looked; and what was seen is the frame that comes, if the pads stay.
 */
#include "rig.h"
#include "../../src/player/run/ahead.h"

enum { FRAMES = 1500, SIZE = 240 * 320 };

struct seen {
    uint8_t pix[SIZE];
    uint32_t rgb[256];
};

static void see(struct rig *r, const struct board *b, struct seen *to)
{
    board_draw(b, NULL, &r->fb, to->rgb, r->scratch);
    assert_int_equal(r->fb.w * r->fb.h, SIZE);
    for (int y = 0; y < r->fb.h; y++)
        memcpy(to->pix + y * r->fb.w, r->fb.pix + y * r->fb.pitch, (size_t)r->fb.w);
}

static void output_is(const struct board *b, const uint8_t *was, uint8_t *now)
{
    board_output_save(b, now);
    assert_memory_equal(now, was, board_output_size());
}

/* A recorded run, looked ahead in each frame, beside the same run straight on. */
TEST(leaves_nothing)
{
    static struct seen ahead, then;
    struct rig_game game;
    struct demo demo;
    struct rig straight;
    struct guard g;
    struct ahead a = { 0 };
    char err[256];
    int same_pads = 0;

    rig_folder(&game, "glasstide");
    assert_true(rig_demo(&game, "run", &demo));
    rig_power(&straight, &game, &demo.start);
    assert_true(guard_power(&g, &game.image.rom, &demo.start, err, sizeof err));
    assert_true(guard_store_past(&g));
    uint8_t *was = malloc(board_output_size()), *now = malloc(board_output_size());
    for (uint32_t f = 0; f < FRAMES; f++) {
        uint16_t pads[MAX_PLAYERS], next[MAX_PLAYERS];
        demo_pads(&demo, f, pads);
        demo_pads(&demo, f + 1, next);
        rig_tick(&straight, pads);
        guard_tick(&g, pads);
        board_output_save(g.board, was);
        assert_true(ahead_begin(&a, &g, pads));
        assert_int_equal(board_frame(g.board), f + 2);
        see(&straight, g.board, &ahead);
        ahead_end(&a, &g);
        assert_int_equal(board_frame(g.board), f + 1);
        assert_true(board_hash(g.board) == board_hash(straight.b));
        output_is(g.board, was, now);
        if (memcmp(pads, next, sizeof pads) != 0 || f % 50)
            continue;
        guard_tick(&g, next); /* the frame that was seen */
        see(&straight, g.board, &then);
        assert_memory_equal(&ahead, &then, sizeof ahead);
        assert_true(guard_rewind(&g, f + 1)); /* the past knows nothing of it either */
        assert_true(board_hash(g.board) == board_hash(straight.b));
        same_pads++;
    }
    assert_true(same_pads > 10);
    free(was);
    free(now);
    ahead_close(&a);
    ahead_close(&a);
    guard_close(&g);
    rig_free(&straight);
    demo_free(&demo);
    rig_game_free(&game);
}

static void power(struct guard *g, struct rig_game *game, const char *script)
{
    static const struct board_start start = { .seed = 1, .difficulty = -1 };
    char err[256];

    rig_script(game, NULL, script);
    assert_true(guard_power(g, &game->image.rom, &start, err, sizeof err));
    assert_null(board_last_output(g->board)->fault);
}

/* A tick that faults, or never ends, is not looked at; when it comes, it faults as it would have. */
static void refuses(const char *script, enum board_fault_kind kind)
{
    const uint16_t pads[MAX_PLAYERS] = { 0 };
    struct rig_game game;
    struct guard g;
    struct ahead a = { 0 };

    power(&g, &game, script);
    for (int i = 0; i < 3; i++)
        guard_tick(&g, pads);
    const uint64_t hash = board_hash(g.board);
    assert_false(ahead_begin(&a, &g, pads));
    assert_false(a.saved);
    assert_null(board_last_output(g.board)->fault);
    assert_true(board_hash(g.board) == hash && board_frame(g.board) == 3);
    assert_int_equal(guard_tick(&g, pads)->fault->kind, kind);
    ahead_close(&a);
    guard_close(&g);
    rig_game_free(&game);
}

TEST(refuses)
{
    refuses("task.go(function() wait(3) error('now') end)", FAULT_SCRIPT);
    refuses("task.go(function() wait(3) while true do end end)", FAULT_LOOP);
}

RUN_TESTS(NULL, NULL)

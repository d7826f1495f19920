/*
 * test_collect.c - Lua's collector, a turn between two frames: what is garbage goes in time, in small heaps and full
 * ones, and no state depends on when.
 */
#include "rig.h"

enum { FRAMES = 2000, WARM = 300 };

/* Some garbage in each frame, and a state that depends on what is kept. */
static const char litter[] = "local kept = {}\n"
                             "task.go(function()\n"
                             "  for i = 1, %d do kept[i] = ('x'):rep(4000) .. i end\n"
                             "  local n = 0\n"
                             "  while true do\n"
                             "    local t = {}\n"
                             "    for i = 1, 20 do t[i] = { i, n } end\n"
                             "    n = n + #t + #(kept[n %% 7 + 1] or '')\n"
                             "    board.note(n)\n"
                             "    wait(1)\n"
                             "  end\n"
                             "end)\n";

static void open(struct rig_game *g, struct rig *r, int texts, int kib)
{
    struct manifest m = rig_manifest();
    char script[1000];

    m.lua_kib = kib;
    snprintf(script, sizeof script, litter, texts);
    rig_script(g, &m, script);
    rig_power(r, g, NULL);
}

static void done(struct rig_game *g, struct rig *r)
{
    assert_null(rig_fault(r));
    rig_free(r);
    rig_game_free(g);
}

/* Does a game that keeps so many texts run for so many frames? */
static bool holds(int texts, int frames)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rig r;

    open(&g, &r, texts, 1024);
    for (int f = 0; f < frames && !rig_fault(&r); f++)
        board_tick(r.b, none);
    const bool fine = !rig_fault(&r);
    if (fine && frames == FRAMES)
        assert_true(heap_used(r.b->vm.heap) > (450u << 10)); /* what the first frame leaves has the rest */
    rig_close(&r);
    return fine;
}

/* With a heap as full as it can be when the first frame is over, but for little, there is room for what each frame
 * leaves. */
TEST(nearly_full)
{
    int texts = 16;

    while (holds(texts + 8, 1))
        texts += 8;
    assert_true(holds(texts - 8, FRAMES));
}

/* The same frames, where it never comes and where a round begins anew in each frame. */
TEST(no_state)
{
    struct rig_game g[3];
    struct rig r[3];

    for (int k = 0; k < 3; k++)
        open(&g[k], &r[k], 8, 4096);
    for (int f = 0; f < WARM; f++) {
        r[1].b->vm.collect_at = SIZE_MAX;
        r[2].b->vm.collect_at = 0;
        for (int k = 0; k < 3; k++)
            rig_run(&r[k], 1);
        assert_true(board_hash(r[0].b) == board_hash(r[1].b) && board_hash(r[0].b) == board_hash(r[2].b));
    }
    assert_true(heap_used(r[1].b->vm.heap) > heap_used(r[0].b->vm.heap));
    for (int k = 0; k < 3; k++)
        done(&g[k], &r[k]);
}

RUN_TESTS(NULL, NULL)

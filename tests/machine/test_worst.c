/*
 * test_worst.c - no operation of Lua does much for little: each of tools/lab/bench/worst.c, in an endless loop, is
 * stopped by the guard, and after no more rounds than its work allows. Nor does C do much that is not counted: each
 * frame of tools/lab/bench/dearest.c counts what it does, and stays below the limit or ends in a fault soon above it.
 * How long all that takes, `make bench ARGS=guards` measures.
 */
#include "../test.h"
#include "../../tools/lab/bench/dearest.h"
#include "../../tools/lab/bench/scene.h"
#include "../../tools/lab/bench/worst.h"

static struct rom_image image;

static int load(void **state)
{
    char err[256];
    (void)state;
    return pack_load_game("roms/bench", false, &image, err, sizeof err) ? 0 : -1;
}

static int drop(void **state)
{
    (void)state;
    rom_image_free(&image);
    return 0;
}

static void stops(const struct worst *w)
{
    const struct scene_want want = { .does = "prices", .price = "straight", .n = 4096, .bullets = 4096 };
    const char *fault;
    struct scene s;
    char err[256];

    if (!scene_open(&s, &image.rom, &want, err, sizeof err))
        fail_msg("%s", err);
    uint64_t rounds = worst_run(s.b, w, &fault);
    if (!fault || !strstr(fault, "infinite loop: more than 5000000 instructions"))
        fail_msg("%s: %s", w->what, fault ? fault : "it ended");
    if (rounds * w->cost > 2 * WORST_LIMIT) /* looks are coarse: few rounds may be charged for one less or more */
        fail_msg("%s: %llu rounds for %d instructions, so one cost less than %u", w->what, (unsigned long long)rounds,
                 (int)WORST_LIMIT, (unsigned)w->cost);
    scene_close(&s);
}

TEST(every_operation_is_charged)
{
    for (int i = 0; i < WORST_COUNT; i++)
        stops(&WORST[i]);
}

/* The fault that a script ends with; good until the next call. */
static const char *fault_of(const char *text)
{
    static char said[512];
    const struct scene_want want = { .does = "prices", .price = "straight", .n = 1, .bullets = 64 };
    const struct worst w = { "", 1, text };
    const char *fault;
    struct scene s;
    char err[256];

    assert_true(scene_open(&s, &image.rom, &want, err, sizeof err));
    worst_run(s.b, &w, &fault);
    snprintf(said, sizeof said, "%s", fault);
    scene_close(&s);
    return said;
}

/* What makes instructions dear is named. */
TEST(the_reason_is_said)
{
    assert_string_equal(fault_of("local a, b = ('n'):rep(65536), 1 while true do b = a == b end"),
                        "worst:1: infinite loop: more than 5000000 instructions in one line (each counts as 65 with a "
                        "string of 65536 bytes in scope)");
    assert_string_equal(fault_of("local function f(...) while true do end end f(table.unpack({}, 1, 240))"),
                        "worst:1: infinite loop: more than 5000000 instructions in one line (each counts as 2 with 240 "
                        "arguments in scope)");
    assert_string_equal(fault_of("while true do end"),
                        "worst:1: infinite loop: more than 5000000 instructions in one line");
}

/* A string of 65,536 bytes is made in any way; one more byte is a fault that names place and length. */
TEST(texts_have_a_limit)
{
    static const char *const make[] = {
        "local s = ('a'):rep(%d) while true do end",
        "local s = ('a'):rep(%d - 1) s = s .. 'a' while true do end",
        "local s = table.concat({ ('a'):rep(%d - 1), 'a' }) while true do end",
        "local s = ('%%s'):rep(2):format(('a'):rep(%d - 1), 'a') while true do end",
        "local s = ('b'):rep(%d // 16):gsub('b', ('a'):rep(16)) .. ('a'):rep(%d %% 16) while true do end",
    };

    for (size_t i = 0; i < sizeof make / sizeof *make; i++) {
        char text[256];
        snprintf(text, sizeof text, make[i], MAX_TEXT, MAX_TEXT);
        assert_non_null(strstr(fault_of(text), "infinite loop"));
        snprintf(text, sizeof text, make[i], MAX_TEXT + 1, MAX_TEXT + 1);
        assert_string_equal(fault_of(text), "worst:1: string too long: 65537 bytes (at most 65536)");
    }
}

/* The dearest frame that a scene has, and what it ends with. */
static void counts(const struct dearest *d)
{
    const uint64_t most = WORK_LIMIT + WORK_LIMIT / 4; /* a call is counted whole, and then not done */
    uint64_t work = 0;
    struct scene s;
    char err[256];
    bool fine = true;

    if (!scene_power(&s, &image.rom, &d->want, err, sizeof err))
        fail_msg("%s: %s", d->what, err);
    for (int i = 0; fine && i < d->frames; i++) {
        fine = scene_tick(&s);
        work = s.b->vm.work > work ? s.b->vm.work : work;
    }
    if (fine != !d->says || (d->says && !strstr(board_last_output(s.b)->fault->message, d->says)))
        fail_msg("%s: it ended with %s, after %llu units of work", d->what,
                 fine ? "nothing" : board_last_output(s.b)->fault->message, (unsigned long long)work);
    if (work < d->least || work > (d->says ? most : WORK_LIMIT))
        fail_msg("%s: %llu units of work, expected %llu to %llu", d->what, (unsigned long long)work,
                 (unsigned long long)d->least, (unsigned long long)most);
    scene_close(&s);
}

TEST(every_frame_is_bounded)
{
    for (int i = 0; i < DEAREST_COUNT; i++)
        counts(&DEAREST[i]);
}

/* What is too much to draw is not drawn: a host that draws after the fault must not hang. */
TEST(too_large_a_picture_is_not_drawn)
{
    const struct dearest *d = NULL;
    struct scene s;
    char err[256];

    for (int i = 0; i < DEAREST_COUNT; i++)
        d = DEAREST[i].says && strstr(DEAREST[i].says, "drawing: ") ? &DEAREST[i] : d;
    assert_non_null(d);
    assert_true(scene_power(&s, &image.rom, &d->want, err, sizeof err));
    assert_false(scene_tick(&s));
    scene_draw(&s);
    assert_int_equal(s.drawn, 0);
    for (int i = 0; i < s.fb.h * s.fb.pitch; i++)
        assert_int_equal(s.fb.pix[i], 0);
    scene_close(&s);
}

RUN_TESTS(load, drop)

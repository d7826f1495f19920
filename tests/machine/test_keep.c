/*
 * test_keep.c - what keeping a run asks of a recording: a spare file that grows beside it, a whole demo of the run as
 * it is now, and a session that goes on where a demo ends.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include "../../platform/platform.h"
#include "../../src/player/replay.h"
#include "../../src/player/play/session.h"
#include "rig.h"
#include "../temp.h"

enum { MOST = 1 << 21 };

static char dir[256], file[300], spare[300], err[DEMO_ERR_SIZE];
static struct rig_game game;
static uint8_t a[MOST], b[MOST];

static int open_game(void **state)
{
    (void)state;
    assert_true(temp_folder(dir, sizeof dir, "curtain-keep"));
    snprintf(file, sizeof file, "%s/a.demo", dir);
    snprintf(spare, sizeof spare, "%s/b.demo", dir);
    rig_script(&game, NULL,
               "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
               "task.go(function()\n"
               "  while true do\n"
               "    if pad.down('fire') then board.note(rng.int(0, 9)) end\n"
               "    if pad.down('bomb') then save.set('bombs', save.get('bombs', 0) + 1) end\n"
               "    if pad.down('select') then error 'select' end\n"
               "    wait(1)\n"
               "  end\n"
               "end)\n"
               "stage.def('one', function() while true do wait(50) stage.mark 'fifty' end end)\n"
               "task.go(stage.play, 'one')");
    return 0;
}

static int close_game(void **state)
{
    char command[300];

    (void)state;
    rig_game_free(&game);
    snprintf(command, sizeof command, "rm -rf '%s'", dir);
    return system(command);
}

static const struct board_start start = { .seed = 7, .difficulty = -1 };

static void play(struct demo_writer *w, struct rig *r, struct rng *rng, int frames)
{
    uint16_t pads[MAX_PLAYERS] = { 0 };

    for (int i = 0; i < frames; i++) {
        pads[0] = (uint16_t)(rng_next(rng) & (PAD_FIRE | PAD_BOMB | PAD_LEFT));
        rig_tick(r, pads);
        assert_true(demo_record_frame(w, r->b, pads));
    }
}

static void same_files(void)
{
    const long n = plat_load(file, a, MOST);

    assert_true(n > 0);
    assert_int_equal(plat_load(spare, b, MOST), n);
    assert_memory_equal(a, b, (size_t)n);
}

static void spare_has(uint32_t frames, uint32_t flags)
{
    struct demo d;

    assert_true(demo_load(&d, spare, err, sizeof err));
    assert_int_equal(d.frames, frames);
    assert_int_equal(d.flags, flags);
    demo_free(&d);
}

/* Whenever it is begun, the spare reads as the recording does; from the beginning on they are the same bytes. */
TEST(spare)
{
    struct demo_writer w = { .recording = false };
    struct rng rng;
    struct rig r;

    rng_seed(&rng, 1);
    rig_power(&r, &game, &start);
    assert_true(demo_begin(&w, file, &game.cart, r.b, &start, 0));
    demo_record_to_spare_file(&w, spare);
    play(&w, &r, &rng, 130);
    assert_true(demo_add_flags(&w, DEMO_ASSISTED));
    same_files();
    demo_record_to_spare_file(&w, NULL);
    play(&w, &r, &rng, 77);
    assert_true(plat_file_size(spare) < plat_file_size(file)); /* it was left as it was */
    demo_record_to_spare_file(&w, spare);
    play(&w, &r, &rng, 120);
    spare_has(300, DEMO_ASSISTED);
    assert_true(demo_rewind(&w, 200));
    spare_has(180, DEMO_ASSISTED | DEMO_BRANCHED);
    demo_writer_free(&w);
    rig_free(&r);
}

/* The end is written into both. A spare that cannot be written does not end the recording. */
TEST(spare_ends)
{
    struct demo_writer w = { .recording = false };
    struct rng rng;
    struct rig r;

    rng_seed(&rng, 2);
    rig_power(&r, &game, &start);
    assert_true(demo_begin(&w, NULL, &game.cart, r.b, &start, DEMO_RESUMED));
    demo_record_to_spare_file(&w, "/proc/nothing/b.demo");
    assert_string_equal(w.spare_err, "/proc/nothing/b.demo: cannot be written (No such file or directory)");
    assert_true(w.spare_file.write_failed);
    play(&w, &r, &rng, 100);
    demo_record_to_spare_file(&w, spare);
    assert_string_equal(w.spare_err, "");
    play(&w, &r, &rng, 99);
    assert_true(demo_end(&w, r.b));
    spare_has(199, DEMO_RESUMED);
    demo_writer_free(&w);
    rig_free(&r);
}

static void holds(const uint8_t *bytes, size_t size, uint32_t frames)
{
    struct replay replay = { .hash_cache = NULL };
    struct verdict v;
    struct demo d;

    assert_true(demo_read(&d, bytes, size, err, sizeof err));
    assert_true(d.complete && d.frames == frames);
    assert_int_equal(replay_run(&replay, &game.cart, &d, NULL, &v, err, sizeof err), RESULT_DONE);
    assert_int_equal(v.kind, VERDICT_HOLDS);
    replay_close(&replay);
    demo_free(&d);
}

/* At any frame the bytes are a whole demo that holds, and the recording goes on as if nothing had been. */
TEST(now)
{
    struct demo_writer w = { .recording = false };
    uint16_t select[MAX_PLAYERS] = { PAD_SELECT };
    struct rng rng;
    struct rig r;
    size_t size;
    uint8_t *bytes;

    assert_null(demo_encode_now(&w, NULL, &size)); /* nothing is recorded */
    rng_seed(&rng, 3);
    rig_power(&r, &game, &start);
    assert_true(demo_begin(&w, file, &game.cart, r.b, &start, 0));
    for (uint32_t frames = 0, by = 0; frames < 400; by = 1 + (uint32_t)rng_below(&rng, 40), frames += by) {
        play(&w, &r, &rng, (int)by);
        bytes = demo_encode_now(&w, r.b, &size);
        assert_non_null(bytes);
        holds(bytes, size, frames);
        free(bytes);
    }
    board_tick(r.b, select);
    assert_true(demo_record_frame(&w, r.b, select));
    bytes = demo_encode_now(&w, r.b, &size);
    assert_non_null(bytes);
    holds(bytes, size, w.demo.frames);
    assert_true(demo_end(&w, r.b));
    assert_int_equal(plat_load(file, a, MOST), (long)size);
    assert_memory_equal(a, bytes, size); /* what the recording itself comes to */
    free(bytes);
    demo_writer_free(&w);
    rig_free(&r);
}

static uint32_t ticks;
static void count(void *of, const struct session *s)
{
    assert_ptr_equal(of, s);
    ticks += board_frame(session_board(s)) > 0;
}

/* A demo in which a pad is held for some frames. */
static struct demo recorded(const uint16_t pads[MAX_PLAYERS], int frames)
{
    struct session s;
    struct demo d;

    assert_true(session_open(&s, &game.cart, &start, NULL, file));
    for (int i = 0; i < frames; i++)
        assert_true(session_tick(&s, pads));
    assert_true(session_close(&s));
    assert_true(demo_load(&d, file, err, sizeof err));
    return d;
}

static void go_to(struct session *s, uint32_t frame)
{
    session_goto(s, frame);
    while (s->state != SESSION_PLAYING)
        assert_true(session_work(s, UINT64_MAX));
}

/* A session that was left goes on: the same run, not branched, flagged; its scores would count. */
TEST(go_on)
{
    static const uint16_t bomb[MAX_PLAYERS] = { PAD_BOMB };
    struct session s;
    struct demo d;

    d = recorded(bomb, 500);
    assert_true(session_open(&s, &game.cart, &d.start, &d, NULL));
    assert_false(session_resume(&s, DEMO_RESUMED)); /* not there yet */
    s.ticked = count;
    s.context = &s;
    ticks = 0;
    go_to(&s, d.frames);
    assert_int_equal(ticks, 500);
    assert_true(session_resume(&s, DEMO_RESUMED));
    assert_false(session_resume(&s, DEMO_RESUMED)); /* it is no playback any more */
    assert_false(s.rewound);
    assert_null(s.demo);
    for (int i = 0; i < 100; i++)
        assert_true(session_tick(&s, bomb));
    demo_record_to_spare_file(&s.now->writer, spare);
    assert_true(session_close(&s));
    demo_free(&d);

    spare_has(600, DEMO_RESUMED);
    const long n = plat_load(spare, b, MOST);
    holds(b, (size_t)n, 600);
}

/* Where the run is another one now, it does not go on. */
TEST(differs)
{
    static const uint16_t none[MAX_PLAYERS] = { 0 };
    struct session s;
    struct demo d;

    d = recorded(none, 100);
    d.pads[50][0] = PAD_FIRE;
    assert_true(session_open(&s, &game.cart, &d.start, &d, NULL));
    go_to(&s, d.frames);
    assert_false(session_resume(&s, DEMO_RESUMED));
    assert_string_equal(s.err, "playback diverged from the recording");
    assert_true(session_close(&s));
    demo_free(&d);
}

RUN_TESTS(open_game, close_game)

/*
 * test_stream.c - recordings as music, on whole boards: that the loop is exact, that left and right stay apart, what
 * scripts see of the beat, and that they continue where they were.
 */
#include "rig.h"
#include <math.h>

static struct rig_game game;
static struct rig rig;

enum { BEAT = 24000, LEAD = 4800, FRAMES = LEAD + 10 * BEAT, LOOP = LEAD + 2 * BEAT, ROUND = FRAMES - LOOP };

static const struct art_marker markers[] = { { "around", 2 }, { "first", 0 }, { "turn", 6.5 } };

/* At 48 kHz 0.1 s before the first beat, ten beats at 120 a minute, of which the last eight go round: a tone on the
 * left, another one on the right. */
static void make_stream(struct pcm *p)
{
    *p = (struct pcm){ .n = FRAMES, .rate = 48000, .channels = 2, .loop = LOOP, .loop_end = -1 };
    p->frames = malloc(FRAMES * 2 * sizeof *p->frames);
    assert_non_null(p->frames);
    for (int i = 0; i < FRAMES; i++) {
        const double turn = 2 * 3.14159265358979 * (i - LOOP) / ROUND, loud = 12000 + 8000 * sin(turn);
        p->frames[2 * i] = (int16_t)lrint(loud * sin(400 * turn));
        p->frames[2 * i + 1] = (int16_t)lrint(loud * sin(601 * turn));
    }
}

/* A game with that stream, "reel", and another piece, "short", of a second without a loop. */
static void power(const char *script, bool exact)
{
    struct art_sound about = { .volume = 255,
                               .priority = 4,
                               .limit = 1,
                               .beats_per_bar = 4,
                               .tempo = 12000,
                               .stereo = true,
                               .exact = exact,
                               .offset = 0.1,
                               .n_markers = 3 };
    struct recording_bytes made[4];
    struct manifest m = rig_manifest();
    struct pcm p;
    char err[256];

    m.has_sound = 1;
    rig_script(&game, &m, script);
    make_stream(&p);
    assert_true(recording_music(&p, &about, markers, &made[0], &made[1], err, sizeof err));
    p.n = 48000;
    p.loop = -1;
    about.n_markers = 0;
    about.stereo = false;
    assert_true(recording_music(&p, &about, markers, &made[2], &made[3], err, sizeof err));
    free(p.frames);
    static const char *const names[] = { "tune/reel", "wave/reel", "tune/short", "wave/short" };
    for (int i = 3; i >= 0; i--) { /* a tune is refused without its wave */
        rig_lump(&game, names[i], made[i].data, made[i].n);
        free(made[i].data);
    }
    rig_power(&rig, &game, NULL);
}

static int16_t sound[2 * BOARD_SOUND_FRAMES];

/* All that is heard of n frames; free it. */
static int16_t *listen(int n)
{
    int16_t *out = malloc((size_t)n * sizeof sound);

    assert_non_null(out);
    for (int f = 0; f < n; f++) {
        rig_run(&rig, 1);
        board_mix_sound(rig.b, &rig_sound_tables, out + (size_t)f * 2 * BOARD_SOUND_FRAMES);
    }
    return out;
}

/* Beyond the attack of the first frame it is the recording, at a third of its level, left and right apart; and from the
 * loop's end on what is eight beats before, to the last bit. */
TEST(exact)
{
    enum { N = 1200 };
    struct pcm p;

    for (int exact = 0; exact < 2; exact++) {
        power("music.play('reel')", exact);
        make_stream(&p);
        int16_t *all = listen(N);
        for (int i = 2 * 1000; i < 2 * (FRAMES - 1000); i++)
            assert_true(abs(all[i] - p.frames[i] / 3) <= (exact ? 3 : 300));
        const int from = 2 * (LOOP + 100), to = 2 * (N * BOARD_SOUND_FRAMES - ROUND);
        assert_memory_equal(all + from, all + from + 2 * ROUND, (size_t)(to - from) * sizeof *all);
        free(all);
        free(p.frames);
        rig_close(&rig);
    }
}

/* What the script prints in n frames. */
static const char *printed(int n)
{
    static char log[1024];

    log[0] = '\0';
    for (int f = 0; f < n; f++) {
        rig_run(&rig, 1);
        const struct board_out *out = board_last_output(rig.b);
        snprintf(log + strlen(log), sizeof log - strlen(log), "%.*s", (int)out->log_size, out->log);
    }
    return log;
}

/* The first beat is 0.1 s behind the beginning; a beat is 30 frames. A marker comes in the frame of its beat, and again
 * each time round; beats and bars count on. */
TEST(beats)
{
    power(
        "music.play('reel')\n"
        "task.go(function() while true do print('beat', music.wait(), music.bar(), board.frame()) wait(200) end end)\n"
        "task.go(function() music.wait('first') print('first', board.frame()) end)\n"
        "task.go(function() while true do music.wait('turn') print('turn', music.beat(), board.frame()) end end)\n"
        "task.go(function() while true do music.wait('around') print('around', music.marker(), board.frame()) end end)",
        false);
    assert_string_equal(printed(800), "first\t7\n"
                                      "beat\t1\t0\t36\n"
                                      "around\taround\t67\n"
                                      "turn\t6\t202\n"
                                      "beat\t8\t2\t246\n"
                                      "around\taround\t307\n"
                                      "turn\t14\t442\n"
                                      "beat\t15\t3\t456\n"
                                      "around\taround\t547\n"
                                      "beat\t22\t5\t666\n"
                                      "turn\t22\t682\n"
                                      "around\taround\t787\n");
    assert_int_equal(seq_beats(&rig.b->music), 26);
    rig_close(&rig);
}

/* Put aside for another piece and back: it goes on where it was, to the sample, in the frame after the one in which it
 * comes in; also when the other one ends by itself, and with the loop passed before. */
TEST(aside)
{
    enum { N = 200 };

    for (int at = 90; at < 700; at += 500) {
        char script[256];
        power("music.play('reel')", false);
        rig_run(&rig, at);
        int16_t *all = listen(N);
        rig_close(&rig);
        snprintf(script, sizeof script,
                 "music.play('reel') task.go(function() wait(%d) music.play('short', { back = true }) end)", at);
        power(script, false);
        rig_run(&rig, at + 10);
        while (rig.b->music.tune != 1)
            rig_run(&rig, 1);
        for (int f = 1; f < 30; f++) {
            rig_run(&rig, 1);
            board_mix_sound(rig.b, &rig_sound_tables, sound);
            if (f >= 4)
                assert_memory_equal(sound, all + (size_t)f * 2 * BOARD_SOUND_FRAMES, sizeof sound);
        }
        free(all);
        rig_close(&rig);
    }
}

/* After thirteen hours, when the place in the recording would leave its number's range, it goes on as ever. */
TEST(hours)
{
    power("music.play('reel')", true);
    rig_run(&rig, 100);
    int16_t *all = listen(600);
    rig_free(&rig);
    rig_power(&rig, &game, NULL);
    rig_run(&rig, 100);
    for (int i = 0; i < 2; i++)
        rig.b->voices.phase[i] += (uint64_t)((1u << 30) / ROUND + 2) * ROUND << 32;
    for (int f = 0; f < 600; f++) {
        rig_run(&rig, 1);
        board_mix_sound(rig.b, &rig_sound_tables, sound);
        if (f > 300) /* it was not in the loop yet */
            assert_memory_equal(sound, all + (size_t)f * 2 * BOARD_SOUND_FRAMES, sizeof sound);
        assert_true(f == 0 || rig.b->voices.phase[0] >> 32 < 1u << 30);
    }
    free(all);
    rig_close(&rig);
}

RUN_TESTS(rig_make_sound_tables, NULL)

/*
 * test_stream.c - recordings as music, on whole boards: that the loop is exact, that left and right stay apart, what
 * scripts see of the beat, and that they sound the same however they are come by.
 */
#include "rig.h"
#include <math.h>
#include "../../src/machine/sound.h"
#include "../../src/sound/tables.h"

static struct snd_tables tables;
static struct rig_game game;
static struct rig rig;

static int make_tables(void **state)
{
    (void)state;
    board_sound_init_tables(&tables);
    return 0;
}

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
    struct lump lumps[RIG_LUMPS];
    struct pcm p;
    char err[256];

    m.has_sound = 1;
    rig_script(&game, &m, script);
    struct rig_game had = game;
    int n = (int)had.image.rom.count;
    for (int i = 0; i < n; i++)
        rom_lump(&had.image.rom, i, &lumps[i]);
    make_stream(&p);
    assert_true(recording_music(&p, &about, markers, &made[0], &made[1], err, sizeof err));
    p.n = 48000;
    p.loop = -1;
    about.n_markers = 0;
    about.stereo = false;
    assert_true(recording_music(&p, &about, markers, &made[2], &made[3], err, sizeof err));
    free(p.frames);
    static const char *const names[] = { "tune/reel", "wave/reel", "tune/short", "wave/short" };
    for (int i = 0; i < 4; i++)
        lumps[n++] = (struct lump){ names[i], made[i].data, (uint32_t)made[i].n };
    rig_write(&game, lumps, n);
    for (int i = 0; i < 4; i++)
        free(made[i].data);
    free(had.image.bytes);
    rig_power(&rig, &game, NULL);
}

static void done(void)
{
    rig_free(&rig);
    rig_game_free(&game);
}

static int16_t sound[2 * BOARD_SOUND_FRAMES];

/* All that is heard of n frames; free it. */
static int16_t *listen(int n)
{
    int16_t *out = malloc((size_t)n * sizeof sound);

    assert_non_null(out);
    for (int f = 0; f < n; f++) {
        rig_run(&rig, 1);
        board_mix_sound(rig.b, &tables, out + (size_t)f * 2 * BOARD_SOUND_FRAMES);
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
        int most = 0;
        for (int i = 1000; i < FRAMES - 1000; i++)
            for (int c = 0; c < 2; c++) {
                const int d = abs(all[2 * i + c] - p.frames[2 * i + c] / 3);
                most = d > most ? d : most;
            }
        printf("# %s: off by %d at most\n", exact ? "16 bits" : "ADPCM", most);
        assert_true(most <= (exact ? 3 : 300));
        for (int i = LOOP + 100; i + ROUND < N * BOARD_SOUND_FRAMES; i++)
            for (int c = 0; c < 2; c++)
                assert_int_equal(all[2 * i + c], all[2 * (i + ROUND) + c]);
        free(all);
        free(p.frames);
        done();
    }
}

/* What a script prints in n frames. */
static const char *said(int n)
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
    assert_string_equal(said(800), "first\t7\n"
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
    done();
}

/* A stream without a loop ends, and its voices are free; in a pause it is held where it is. */
TEST(end)
{
    power("music.play('short')", false);
    rig_run(&rig, 30);
    board_mix_sound(rig.b, &tables, sound);
    assert_true(abs(sound[500]) + abs(sound[700]) > 100);
    assert_memory_equal(&sound[500], &sound[501], 2); /* of one voice, in the middle */
    rig_run(&rig, 40);
    for (int i = 0; i < VOICE_SLOTS; i++)
        assert_false(voices_is_busy(&rig.b->voices, i));
    done();
}

/* From snapshots, in any order and with RAM spoilt between, the same samples. */
TEST(restored)
{
    enum { N = 400 };

    power("music.play('reel')", false);
    int16_t *all = listen(N);
    rig_free(&rig);
    rig_power(&rig, &game, NULL);
    for (int f = 0; f < N; f++) {
        rig_run(&rig, 1);
        rig_spoil(&rig);
        board_mix_sound(rig.b, &tables, sound);
        assert_memory_equal(sound, all + (size_t)f * 2 * BOARD_SOUND_FRAMES, sizeof sound);
    }
    free(all);
    done();
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
        done();
        snprintf(script, sizeof script,
                 "music.play('reel') task.go(function() wait(%d) music.play('short', { back = true }) end)", at);
        power(script, false);
        rig_run(&rig, at + 10);
        while (rig.b->music.tune != 1)
            rig_run(&rig, 1);
        for (int f = 1; f < 30; f++) {
            rig_run(&rig, 1);
            board_mix_sound(rig.b, &tables, sound);
            int best = -1;
            for (int k = 0; k < N && best < 0; k++)
                if (memcmp(sound, all + (size_t)k * 2 * BOARD_SOUND_FRAMES, sizeof sound) == 0)
                    best = k;
            assert_true(f < 4 || best == f);
        }
        free(all);
        done();
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
        board_mix_sound(rig.b, &tables, sound);
        if (f > 300) /* it was not in the loop yet */
            assert_memory_equal(sound, all + (size_t)f * 2 * BOARD_SOUND_FRAMES, sizeof sound);
        assert_true(f == 0 || rig.b->voices.phase[0] >> 32 < 1u << 30);
    }
    free(all);
    done();
}

RUN_TESTS(make_tables, NULL)

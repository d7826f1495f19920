/*
 * test_speaker.c - what goes to the host's speaker, with simulated clocks: the card is this file's plat_queue_sound,
 * and time is what the tests say. Sound is unbroken whatever the clocks do, joints do not click and are over when they
 * say, and with the rate held at 1 what is played is what board_mix_sound makes.
 */
#include <math.h>
#include "rig.h"
#include "../../platform/platform.h"
#include "../../src/player/speaker/speaker.h"

enum { PLAYED = 48000 * 60, QUEUE = 48000, TAKEN = 512 };

/* ---- a card ---- */

static struct {
    bool gone;
    double used;                /* frames that the card would have played until now */
    int queued;                 /* frames of the queue */
    int16_t queue[2 * QUEUE];   /* the first one next */
    int16_t played[2 * PLAYED]; /* what was heard */
    int n, gaps, calls;
    int silent; /* frames of the last gap */
    double rate;
} card;

int plat_queue_sound(const int16_t *lr, int frames)
{
    const int waiting = card.queued;

    card.calls++;
    if (card.gone)
        return -1;
    assert_true(card.queued + frames <= QUEUE);
    if (frames)
        memcpy(card.queue + 2 * card.queued, lr, (size_t)frames * 4);
    card.queued += frames;
    return waiting ? waiting + TAKEN : 0;
}

/* So much time of the game's clock passes: the card plays, and where nothing waits, silence. */
static void pass(double usec)
{
    card.used += usec * 48000 / 1e6 * card.rate;
    int n = (int)card.used;

    card.used -= n;
    const int has = n < card.queued ? n : card.queued;
    assert_true(card.n + n <= PLAYED);
    memcpy(card.played + 2 * card.n, card.queue, (size_t)has * 4);
    memset(card.played + 2 * (card.n + has), 0, (size_t)(n - has) * 4);
    card.gaps += has < n && card.n > 0;
    card.n += n;
    card.queued -= has;
    memmove(card.queue, card.queue + 2 * has, (size_t)card.queued * 4);
}

/* ---- a window ---- */

static struct rig_game game;
static struct rig rig;
static struct speaker speaker;
static void *tables;

static void power(const char *script)
{
    struct manifest m = rig_manifest();

    m.has_sound = 1;
    rig_script(&game, &m, script);
    rig_sounds(&game);
    rig_power(&rig, &game, NULL);
    memset(&card, 0, sizeof card);
    card.rate = 1;
    speaker_open(&speaker, 100, false, false);
}

static void done(void)
{
    speaker_close(&speaker);
    rig_free(&rig);
    rig_game_free(&game);
}

/* Something sounds always, and never twice the same. */
static const char steady[] = "music.play('tide')";

static void tick(void)
{
    rig_run(&rig, 1);
    speaker_add_frame(&speaker, rig.b, SPEAKER_FORWARD, 1);
}

static void frame(int ticks, double late, double lost)
{
    for (int i = 0; i < ticks; i++)
        tick();
    const struct speaker_elapsed time = { ticks ? ticks : 1, 1, (uint64_t)late, (uint64_t)lost };
    speaker_advance(&speaker, &time);
}

static const double sixtieth = 1e6 / 60;

/* The program's clock (play.c) with ticks that take so long: where it is in time, and what is due. */
struct clock {
    double now, base;
    int frames;
};

/* A frame of the window: waits until it is due, ticks what is due, at most four; what is later is dropped. */
static void clock_frame(struct clock *c, double tick_usec, double draw_usec)
{
    double due = c->base + c->frames * sixtieth, lost = 0;

    if (c->now < due) {
        pass(due - c->now);
        c->now = due;
    }
    const double begun = c->now;
    int n = 1;
    while (n < 4 && c->base + (c->frames + n) * sixtieth <= begun)
        n++;
    c->frames += n;
    if (c->base + c->frames * sixtieth <= begun) {
        lost = begun + sixtieth - (c->base + c->frames * sixtieth);
        c->base = begun;
        c->frames = 1;
    }
    pass(n * tick_usec);
    c->now += n * tick_usec;
    frame(n, c->now - due, lost);
    pass(draw_usec);
    c->now += draw_usec;
}

/* ---- the clocks ---- */

/* The longest silence and the greatest bend, from frame `from` on; a bend is how far a sample is from between its
 * neighbours. */
static void look(int from, int *silence, int *bend)
{
    int run = 0;

    *silence = *bend = 0;
    for (int i = from; i < card.n - 1; i++) {
        const int16_t *p = card.played + 2 * i;
        run = p[0] == 0 && p[1] == 0 ? run + 1 : 0;
        *silence = run > *silence ? run : *silence;
        *bend = i ? (abs(2 * p[0] - p[2] - p[-2]) > *bend ? abs(2 * p[0] - p[2] - p[-2]) : *bend) : 0;
    }
}

/* What the piece itself bends at most. */
static int own_bend(int frames)
{
    static int16_t all[2 * 800 * 3600];
    int most = 0;

    for (int f = 0; f < frames; f++) {
        rig_run(&rig, 1);
        board_mix_sound(rig.b, tables, all + f * 1600);
    }
    for (int i = 1; i < frames * 800 - 1; i++)
        most = abs(2 * all[2 * i] - all[2 * i + 2] - all[2 * i - 2]) > most
                   ? abs(2 * all[2 * i] - all[2 * i + 2] - all[2 * i - 2])
                   : most;
    return most;
}

/* A card half a percent faster or slower than it says, with frames that come late by anything up to 15 ms: no gap in a
 * minute but the one before the first sound, what waits stays where it is said to, and no sound is later than 50 ms. */
TEST(drift)
{
    static const double rates[] = { 1, 1.005, 0.995, 1.0003 };
    struct rng rng;

    rng_seed(&rng, 5);
    for (int k = 0; k < 4; k++) {
        struct clock c = { 0 };
        power(steady);
        card.rate = rates[k];
        for (int i = 0; i < 3000; i++)
            clock_frame(&c, 300, i % 7 ? 2000 : (double)rng_below(&rng, 30000));
        assert_int_equal(card.gaps, 0);
        assert_int_equal(speaker.stats.underruns, 0);
        assert_int_equal(speaker.stats.dropped, 0);
        assert_true(fabs(1 / (1 + speaker.drift.rate) - rates[k]) < 0.0006);
        assert_true(speaker.stats.queued_sum / speaker.stats.measurements > SPEAKER_TARGET_QUEUE - 150);
        assert_true(speaker.stats.queued_sum / speaker.stats.measurements < SPEAKER_TARGET_QUEUE + 150);
        assert_true(speaker.stats.queued_max + RESAMPLE_AFTER <= 2400);
        done();
    }
    assert_true(SPEAKER_LATENCY <= 2400); /* 50 ms */
}

/* What waits when a frame is due is what is said, however long its tick takes then. */
TEST(latency)
{
    static const double ticks[] = { 300, 12000 };

    for (int k = 0; k < 2; k++) {
        struct clock c = { 0 };
        power(steady);
        for (int i = 0; i < 1800; i++) {
            clock_frame(&c, ticks[k], 500);
            pass(c.base + c.frames * sixtieth - c.now);
            c.now = c.base + c.frames * sixtieth;
            assert_true(i < 1200 || abs(card.queued + TAKEN - SPEAKER_TARGET_QUEUE) < 40);
        }
        done();
    }
}

/* A game that dips: frames of up to 45 ms now and then are made up for, and nobody hears them. */
TEST(dips)
{
    struct clock c = { 0 };
    int silence, bend;

    power(steady);
    const int own = own_bend(1300);
    rig_free(&rig);
    rig_power(&rig, &game, NULL);
    for (int i = 0; c.now < 20e6; i++)
        clock_frame(&c, i % 40 < 3 ? 9000 : 500, i % 40 == 20 ? 42000 : 1000);
    assert_int_equal(card.gaps, 0);
    look(SPEAKER_TARGET_QUEUE, &silence, &bend);
    assert_true(silence < 400);
    assert_true(bend < own * 5 / 4);
    done();
}

/* A game that cannot follow the clock for some seconds, a tick taking 20 or 40 ms: once it is known, what is heard is
 * slower and lower, without a gap, nothing cut and nothing twice; afterwards it is as before. */
TEST(slow_game)
{
    for (int k = 0; k < 2; k++) {
        struct clock c = { 0 };
        int silence, bend;

        (void)state;
        power(steady);
        while (c.now < 2e6)
            clock_frame(&c, 500, 1000);
        assert_int_equal(card.gaps, 0);
        while (c.now < 3e6)
            clock_frame(&c, k ? 40000 : 20000, 1000);
        const int began = card.n, gaps = card.gaps, refused = (int)speaker.stats.dropped;
        while (c.now < 12e6)
            clock_frame(&c, k ? 40000 : 20000, 1000);
        const int over = card.n;
        assert_int_equal(card.gaps, gaps);
        while (c.now < 20e6)
            clock_frame(&c, 500, 1000);
        assert_int_equal(card.gaps, gaps);
        assert_int_equal(speaker.stats.dropped, refused);
        look(began, &silence, &bend);
        assert_true(silence < 400 * (k ? 3 : 2));
        assert_true(bend < 30000);
        assert_true(over > began);
        assert_true(speaker.game_speed == 1);
        done();
    }
}

/* A single stop, as of a reload, is one gap and no slowness. */
TEST(one_stop)
{
    struct clock c = { 0 };

    power(steady);
    for (int i = 0; i < 900; i++) {
        clock_frame(&c, 500, i == 300 ? 1e6 : 1000);
        assert_true(speaker.game_speed == 1);
        assert_true(i < 304 || abs(speaker.queued - SPEAKER_TARGET_QUEUE) < 300);
    }
    assert_int_equal(speaker.stats.underruns, 1);
    assert_int_equal(speaker.stats.dropped, 1); /* of the four that are made up for, what would wait for too long */
    done();
}

/* ---- exactly what the board says ---- */

static int16_t *unbroken; /* the sound of the frames, one after the other, from the first on */

static void make_unbroken(int frames)
{
    unbroken = malloc((size_t)frames * 3200);
    for (int f = 0; f < frames; f++) {
        rig_run(&rig, 1);
        board_mix_sound(rig.b, tables, unbroken + f * 1600);
    }
    rig_free(&rig);
    rig_power(&rig, &game, NULL);
}

static void exact(int frames)
{
    power(steady);
    make_unbroken(frames);
    speaker_open(&speaker, 100, false, true);
}

/* The place in what was played of a frame of the window: behind the first silence, blocks follow one another. */
static const int16_t *heard(int block)
{
    return card.played + 2 * (SPEAKER_TARGET_QUEUE - TAKEN + block * SPEAKER_BLOCK);
}

static void same_sound(const char *what, int block, int frame, int from, int to)
{
    const int16_t *got = heard(block), *want = unbroken + (frame - 1) * 1600;

    for (int i = 2 * from; i < 2 * to; i++)
        if (got[i] != want[i])
            fail_msg("%s: block %d, sample %d: %d, expected %d", what, block, i / 2, got[i], want[i]);
}

static void even(int frames)
{
    for (int i = 0; i < frames; i++) {
        frame(1, 0, 0);
        pass(sixtieth);
    }
}

static void flush(void)
{
    while (card.queued)
        pass(1000);
}

/* From the first sample on, to the bit. */
TEST(exact)
{
    exact(200);
    even(200);
    flush();
    for (int i = 0; i < 199; i++)
        same_sound("played", i, i + 1, 0, SPEAKER_BLOCK);
    assert_int_equal(card.gaps, 1); /* the flush */
    done();
    free(unbroken);
}

/* A pause is silent, and 8 ms after both of its ends what is heard is exact: silence, and the unbroken run. */
TEST(pause)
{
    const struct speaker_elapsed time = { 1, 1, 0, 0 };

    exact(100);
    even(40);
    for (int i = 0; i < 20; i++) {
        speaker_advance(&speaker, &time);
        pass(sixtieth);
    }
    even(20);
    flush();
    same_sound("before", 39, 40, 0, SPEAKER_BLOCK);
    for (int i = 2 * SPEAKER_CROSSFADE; i < 20 * 1600; i++)
        assert_int_equal(heard(40)[i], 0);
    assert_true(heard(40)[2 * SPEAKER_CROSSFADE / 4] != 0);
    same_sound("after", 60, 41, SPEAKER_CROSSFADE, SPEAKER_BLOCK);
    same_sound("and on", 61, 42, 0, SPEAKER_BLOCK);
    assert_true(memcmp(heard(60), unbroken + 40 * 1600, 4 * SPEAKER_CROSSFADE) != 0);
    done();
    free(unbroken);
}

/* A restored board: the first 8 ms pass over, and then it is the unbroken run. Not louder on the way than the two. */
TEST(restore)
{
    exact(100);
    even(30);
    rig_save(&rig);
    even(30);
    board_restore(rig.b, rig.snapshot);
    even(20);
    flush();
    same_sound("before", 59, 60, 0, SPEAKER_BLOCK);
    same_sound("after", 60, 31, SPEAKER_CROSSFADE, SPEAKER_BLOCK);
    for (int i = 1; i < 19; i++)
        same_sound("and on", 60 + i, 31 + i, 0, SPEAKER_BLOCK);
    for (int i = 0; i < 2 * SPEAKER_CROSSFADE; i++) {
        const int was = heard(60)[-1 - (i ^ 1)], is = unbroken[30 * 1600 + i], got = heard(60)[i];
        assert_true(got <= (was > is ? was : is) && got >= (was < is ? was : is));
    }
    done();
    free(unbroken);
}

/* Back in time: each block is turned round, and they follow one another to the bit. */
TEST(rewind)
{
    const struct speaker_elapsed time = { 1, 1, 0, 0 };
    uint8_t *saved[60];

    exact(100);
    for (int i = 0; i < 60; i++) {
        even(1);
        saved[i] = malloc(board_snapshot_size(rig.b));
        board_save(rig.b, saved[i]);
    }
    for (int i = 58; i >= 30; i--) {
        board_restore(rig.b, saved[i]);
        speaker_add_frame(&speaker, rig.b, SPEAKER_REVERSE, 1);
        speaker_advance(&speaker, &time);
        pass(sixtieth);
    }
    even(10);
    flush();
    for (int k = 1; k < 28; k++)
        for (int i = 0; i < SPEAKER_BLOCK; i++)
            for (int c = 0; c < 2; c++)
                assert_int_equal(heard(60 + k)[2 * i + c], unbroken[(58 - k) * 1600 + 2 * (SPEAKER_BLOCK - 1 - i) + c]);
    same_sound("on again", 89, 32, SPEAKER_CROSSFADE, SPEAKER_BLOCK);
    same_sound("and on", 90, 33, 0, SPEAKER_BLOCK);
    for (int i = 0; i < 60; i++)
        free(saved[i]);
    done();
    free(unbroken);
}

/* Half and quarter speed: no gap, as many frames as time passes, an octave lower: what is heard of every second or
 * fourth sample is the block. */
TEST(slow_motion)
{
    for (int slow = 2; slow <= 4; slow *= 2) {
        const struct speaker_elapsed time = { 1, slow, 0, 0 };

        (void)state;
        exact(100);
        even(20);
        for (int i = 0; i < 80; i++) {
            if (i % slow == slow - 1) { /* as play.c does: the tick comes last */
                rig_run(&rig, 1);
                speaker_add_frame(&speaker, rig.b, SPEAKER_FORWARD, slow);
            }
            speaker_advance(&speaker, &time);
            pass(sixtieth);
            assert_true(card.queued + TAKEN > SPEAKER_TARGET_QUEUE - 64 &&
                        card.queued + TAKEN < SPEAKER_TARGET_QUEUE + 64);
        }
        assert_int_equal(card.gaps, 0);
        even(10);
        flush();
        const int lead = (slow - 1) * SPEAKER_BLOCK; /* silence until the first of them */
        const int16_t *got = heard(20) + 2 * lead, *want = unbroken + 20 * 1600;
        for (int i = SPEAKER_CROSSFADE; i < 4 * SPEAKER_BLOCK; i++)
            assert_int_equal(got[2 * (slow * i + (slow - 1) * RESAMPLE_AFTER)], want[2 * i]);
        done();
        free(unbroken);
    }
}

/* ---- what the host does ---- */

/* No speaker, then one, then none, then one: what is there is used, nothing is asked of what is not, and after the
 * first 8 ms it is the board's sound. */
TEST(lost_and_found)
{
    exact(200);
    card.gone = true;
    even(10);
    assert_int_equal(speaker.state, SPEAKER_MISSING);
    assert_int_equal(card.n - 8000, 0);
    card.n = 0;
    card.gone = false;
    even(30);
    assert_int_equal(speaker.state, SPEAKER_RUNNING);
    card.gone = true;
    card.queued = 0; /* the card took it along */
    even(30);
    assert_int_equal(speaker.state, SPEAKER_MISSING);
    card.gone = false;
    const int from = card.n;
    even(30);
    flush();
    assert_int_equal(speaker.state, SPEAKER_RUNNING);
    int at = 0; /* frame 72's second block is somewhere behind */
    for (int i = from; i < card.n - 800 && !at; i++)
        at = memcmp(card.played + 2 * i, unbroken + 72 * 1600, 3200) == 0 ? i : 0;
    assert_true(at > 0);
    for (int k = 0; k < 20; k++)
        assert_memory_equal(card.played + 2 * (at + k * 800), unbroken + (72 + k) * 1600, 3200);
    done();
    free(unbroken);
}

/* A game without sound, or a muted one, asks nothing of the host. */
TEST(nothing_to_hear)
{
    rig_script(&game, NULL, "");
    rig_power(&rig, &game, NULL);
    memset(&card, 0, sizeof card);
    speaker_open(&speaker, 100, false, false);
    even(10);
    done();
    assert_int_equal(card.calls, 0);
    power(steady);
    speaker.muted = true;
    even(10);
    assert_null(speaker.tables);
    done();
    assert_int_equal(card.calls, 0);
}

/* Muted and loud again is a pause for the ear, and the run goes on; volume is a share of each sample. */
TEST(mute_and_volume)
{
    exact(100);
    even(20);
    speaker.muted = true;
    even(10);
    speaker.muted = false;
    even(10);
    speaker.volume = 30;
    even(10);
    speaker.volume = 0;
    even(10);
    flush();
    for (int i = 2 * SPEAKER_CROSSFADE; i < 10 * 1600; i++)
        assert_int_equal(heard(20)[i], 0);
    same_sound("again", 30, 31, SPEAKER_CROSSFADE, SPEAKER_BLOCK);
    same_sound("on", 31, 32, 0, SPEAKER_BLOCK);
    for (int i = 0; i < 1600; i++)
        assert_int_equal(heard(41)[i], unbroken[41 * 1600 + i] * 30 / 100);
    for (int i = 0; i < 1600; i++)
        assert_int_equal(heard(51)[i], 0);
    done();
    free(unbroken);
}

/* A card that stands still: what would wait for too long is left out, so what is heard then is not late for ever. */
TEST(stuck)
{
    power(steady);
    even(60);
    for (int i = 0; i < 300; i++)
        frame(1, 0, 0);
    assert_true(card.queued < 2 * SPEAKER_MAX_QUEUE);
    assert_true(speaker.stats.dropped > 250);
    even(200);
    assert_int_equal(card.gaps, 0);
    assert_true(card.queued < SPEAKER_MAX_QUEUE);
    done();
}

/* A joint does not click: of a level that turns round, no step is larger than a raised cosine's of 8 ms. */
TEST(joints)
{
    int silence, bend;

    power(steady);
    const int own = own_bend(600);
    rig_free(&rig);
    rig_power(&rig, &game, NULL);
    even(30);
    rig_save(&rig);
    for (int i = 0; i < 100; i++) {
        even(3 + i % 5);
        board_restore(rig.b, rig.snapshot);
    }
    look(SPEAKER_TARGET_QUEUE, &silence, &bend);
    assert_true(bend <= 3 * own);
    done();
}

/* What is reported is what was seen. */
TEST(report)
{
    char line[256];

    power(steady);
    speaker_report(&speaker, line, sizeof line);
    assert_string_equal(line, "sound: nothing was played");
    even(600);
    speaker_report(&speaker, line, sizeof line);
    if (strncmp(line, "sound: latency 40.", 18) != 0 || !strstr(line, "gaps 0, dropped blocks 0"))
        fail_msg("%s", line);
    flush();
    even(10);
    speaker_report(&speaker, line, sizeof line);
    assert_non_null(strstr(line, "gaps 1,"));
    done();
}

/* A frame whose clock jumped: what waits to be heard stays inside its buffer, and goes on. */
static void jump(double late, double lost)
{
    frame(1, late, lost);
    const struct resample *r = speaker.resample;
    assert_in_range(r->frames, RESAMPLE_BEFORE, RESAMPLE_CAPACITY);
    assert_in_range(r->position >> 32, RESAMPLE_BEFORE, r->frames);
    pass(sixtieth);
}

/* A machine that slept, a clock that was set, a card that stands still: in each state of the speaker, by any time. */
TEST(clock_jumps)
{
    static const double times[] = { 0, 1e5, 1e6, 5e6, 3.6e9, 8.64e10, 1.8e19 };

    for (size_t i = 0; i < sizeof times / sizeof *times; i++)
        for (int slowed = 0; slowed < 3; slowed++) { /* the second and third time it is believed to be */
            power(steady);
            even(60);
            for (int k = 0; k < 4 && slowed; k++)
                jump(2e4, 1e5);
            for (int k = 0; k < 40 && slowed == 2; k++)
                jump(0, 0);
            assert_int_equal(speaker.slow_left > 0, slowed > 0);
            jump(times[i], 0);
            jump(0, times[i]);
            jump(times[i], times[i]);
            card.rate = 0; /* stands still */
            for (int k = 0; k < 120; k++)
                jump(0, 0);
            card.rate = 1;
            jump(times[i], 0);
            const int before = card.n, gaps = card.gaps;
            for (int k = 0; k < 300; k++)
                jump(0, 0);
            assert_in_range(card.n - before, 300 * 800 - 2, 300 * 800 + 2);
            assert_in_range(card.gaps - gaps, 0, 2);
            done();
        }
}

/* No step takes the place out of the buffer. */
TEST(any_step)
{
    static struct resample r;
    static int16_t in[2 * SPEAKER_BLOCK], out[2 * SPEAKER_BLOCK];
    static const uint64_t steps[] = { RESAMPLE_ONE, 3 * RESAMPLE_ONE + 7, 30 * RESAMPLE_ONE, 1 << 20, UINT64_MAX / 2 };

    resample_open(&r);
    for (int i = 0; i < 1000; i++) {
        resample_add(&r, in, SPEAKER_BLOCK);
        resample_take(&r, steps[i % 5], RESAMPLE_CAPACITY, out, SPEAKER_BLOCK);
        assert_in_range(r.frames, RESAMPLE_BEFORE, RESAMPLE_CAPACITY);
        assert_in_range(r.position >> 32, RESAMPLE_BEFORE, r.frames);
    }
}

static int make_tables(void **state)
{
    (void)state;
    tables = malloc(board_sound_tables_size());
    board_sound_init_tables(tables);
    return 0;
}

static int free_tables(void **state)
{
    (void)state;
    free(tables);
    return 0;
}

RUN_TESTS(make_tables, free_tables)

/*
 * test_speaker.c - what goes to the host's speaker, with simulated clocks: the card is this file's plat_queue_sound,
 * and time is what the tests say. Sound is unbroken whatever the clocks do, a joint is over after 8 ms, and with the
 * rate held at 1 what is played is what board_mix_sound makes.
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
static int16_t *unbroken; /* the sound of the frames, one after the other, from the first on; or NULL */

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
    free(unbroken);
    unbroken = NULL;
    speaker_close(&speaker);
    rig_close(&rig);
}

/* Something sounds always, and never twice the same. */
static const char steady[] = "music.play('tide')";

static void tick(void)
{
    rig_run(&rig, 1);
    speaker_add_frame(&speaker, rig.b, NULL, SPEAKER_FORWARD);
}

static void frame(int ticks, double late, double lost)
{
    for (int i = 0; i < ticks; i++)
        tick();
    const struct speaker_elapsed time = { ticks ? ticks : 1, 100, (uint64_t)late, (uint64_t)lost };
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

/* The longest silence from frame `from` on. */
static int longest_silence(int from)
{
    int run = 0, most = 0;

    for (int i = from; i < card.n; i++) {
        run = card.played[2 * i] || card.played[2 * i + 1] ? 0 : run + 1;
        most = run > most ? run : most;
    }
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

static void clock_until(struct clock *c, double now, double tick_usec)
{
    while (c->now < now)
        clock_frame(c, tick_usec, 1000);
}

/* A game that cannot follow the clock for some seconds, a tick taking 20 or 40 ms: once it is known, what is heard is
 * slower and lower, without a gap, nothing cut and nothing twice; afterwards it is as before. */
TEST(slow_game)
{
    static const double ticks[] = { 20000, 40000 };

    for (int k = 0; k < 2; k++) {
        struct clock c = { 0 };
        power(steady);
        clock_until(&c, 2e6, 500);
        assert_int_equal(card.gaps, 0);
        clock_until(&c, 3e6, ticks[k]);
        const int began = card.n, gaps = card.gaps, dropped = (int)speaker.stats.dropped;
        clock_until(&c, 12e6, ticks[k]);
        clock_until(&c, 20e6, 500);
        assert_int_equal(card.gaps, gaps);
        assert_int_equal(speaker.stats.dropped, dropped);
        assert_true(longest_silence(began) < 400 * (k ? 3 : 2));
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

/* Powers on with the rate held at 1, and mixes the sound of so many frames into unbroken. */
static void exact(int frames)
{
    power(steady);
    unbroken = malloc((size_t)frames * 3200);
    for (int f = 0; f < frames; f++) {
        rig_run(&rig, 1);
        board_mix_sound(rig.b, tables, unbroken + f * 1600);
    }
    rig_free(&rig);
    rig_power(&rig, &game, NULL);
    speaker_open(&speaker, 100, false, true);
}

/* The place in what was played of a frame of the window: behind the first silence, blocks follow one another. */
static const int16_t *heard(int block)
{
    return card.played + 2 * (SPEAKER_TARGET_QUEUE - TAKEN + block * SPEAKER_BLOCK);
}

static void same_sound(int block, int frame, int from, int to)
{
    const int16_t *got = heard(block), *want = unbroken + (frame - 1) * 1600;

    for (int i = 2 * from; i < 2 * to; i++)
        if (got[i] != want[i])
            fail_msg("block %d, sample %d: %d, expected %d", block, i / 2, got[i], want[i]);
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

/* A pause is silent, and 8 ms after both of its ends what is heard is exact: silence, and the unbroken run. */
TEST(pause)
{
    exact(100);
    even(40);
    for (int i = 0; i < 20; i++) {
        frame(0, 0, 0);
        pass(sixtieth);
    }
    even(20);
    flush();
    same_sound(39, 40, 0, SPEAKER_BLOCK);
    for (int i = 2 * SPEAKER_CROSSFADE; i < 20 * 1600; i++)
        assert_int_equal(heard(40)[i], 0);
    assert_true(heard(40)[2 * SPEAKER_CROSSFADE / 4] != 0);
    same_sound(60, 41, SPEAKER_CROSSFADE, SPEAKER_BLOCK);
    same_sound(61, 42, 0, SPEAKER_BLOCK);
    assert_true(memcmp(heard(60), unbroken + 40 * 1600, 4 * SPEAKER_CROSSFADE) != 0);
    done();
}

/* From the first sample on it is the run, to the bit. Where a board is restored, the first 8 ms pass over, not louder
 * than the two, and then it is the run again. */
TEST(restore)
{
    exact(100);
    even(30);
    rig_save(&rig);
    even(30);
    board_restore(rig.b, rig.snapshot);
    even(20);
    flush();
    for (int i = 0; i < 60; i++)
        same_sound(i, i + 1, 0, SPEAKER_BLOCK);
    same_sound(60, 31, SPEAKER_CROSSFADE, SPEAKER_BLOCK);
    for (int i = 1; i < 19; i++)
        same_sound(60 + i, 31 + i, 0, SPEAKER_BLOCK);
    for (int i = 0; i < 2 * SPEAKER_CROSSFADE; i++) {
        const int was = heard(60)[-1 - (i ^ 1)], is = unbroken[30 * 1600 + i], got = heard(60)[i];
        assert_true(got <= (was > is ? was : is) && got >= (was < is ? was : is));
    }
    for (int c = 0; c < 2; c++) { /* no step at its start */
        const int was = heard(60)[c - 2], is = unbroken[30 * 1600 + c];
        assert_true(abs(heard(60)[c] - was) <= 1 + abs(is - was) / 50);
    }
    done();
}

/* Back in time: each block is turned round, and they follow one another to the bit. */
TEST(rewind)
{
    const struct speaker_elapsed time = { 1, 100, 0, 0 };
    uint8_t *saved[60];

    exact(100);
    for (int i = 0; i < 60; i++) {
        even(1);
        saved[i] = malloc(board_snapshot_size(rig.b));
        board_save(rig.b, saved[i]);
    }
    for (int i = 58; i >= 30; i--) {
        board_restore(rig.b, saved[i]);
        speaker_add_frame(&speaker, rig.b, NULL, SPEAKER_REVERSE);
        speaker_advance(&speaker, &time);
        pass(sixtieth);
    }
    even(10);
    flush();
    for (int k = 1; k < 28; k++)
        for (int i = 0; i < SPEAKER_BLOCK; i++)
            for (int c = 0; c < 2; c++)
                assert_int_equal(heard(60 + k)[2 * i + c], unbroken[(58 - k) * 1600 + 2 * (SPEAKER_BLOCK - 1 - i) + c]);
    same_sound(89, 32, SPEAKER_CROSSFADE, SPEAKER_BLOCK);
    same_sound(90, 33, 0, SPEAKER_BLOCK);
    for (int i = 0; i < 60; i++)
        free(saved[i]);
    done();
}

/* Half and quarter speed: no gap, as many frames as time passes, an octave lower: what is heard of every second or
 * fourth sample is the block. */
TEST(slow_motion)
{
    for (int slow = 2; slow <= 4; slow *= 2) {
        const struct speaker_elapsed time = { 1, 100 / slow, 0, 0 };

        (void)state;
        exact(100);
        even(20);
        for (int i = 0; i < 80; i++) {
            if (i % slow == slow - 1) { /* as play.c does: the tick comes last */
                rig_run(&rig, 1);
                speaker_add_frame(&speaker, rig.b, NULL, SPEAKER_FORWARD);
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
    }
}

/* Any other speed: no gap, and the queue stays at its length. */
TEST(any_speed)
{
    for (int speed = 25; speed < 100; speed += 5) {
        const struct speaker_elapsed time = { 1, speed, 0, 0 };

        (void)state;
        exact(200);
        even(20);
        for (int i = 0, due = 0; i < 120; i++) {
            due += speed;
            if (due >= 100) {
                due -= 100;
                rig_run(&rig, 1);
                speaker_add_frame(&speaker, rig.b, NULL, SPEAKER_FORWARD);
            }
            speaker_advance(&speaker, &time);
            pass(sixtieth);
            assert_true(card.queued + TAKEN > SPEAKER_TARGET_QUEUE - 256 &&
                        card.queued + TAKEN < SPEAKER_TARGET_QUEUE + 256);
        }
        assert_int_equal(card.gaps, 0);
        done();
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
    same_sound(30, 31, SPEAKER_CROSSFADE, SPEAKER_BLOCK);
    same_sound(31, 32, 0, SPEAKER_BLOCK);
    for (int i = 0; i < 1600; i++)
        assert_int_equal(heard(41)[i], unbroken[41 * 1600 + i] * 30 / 100);
    for (int i = 0; i < 1600; i++)
        assert_int_equal(heard(51)[i], 0);
    done();
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
    static const double times[] = { 1e5, 5e6, 3.6e9, 1.8e19 };

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

/*
 * speaker.c - plays sound (speaker.h).
 *
 * In a crossfade, the last samples are played backwards and fade out while the new sound fades in. The level therefore
 * doesn't jump, and no samples have to be held back.
 *
 * The length of the queue is read when a frame arrives, which may be late. The sound that the card has played meanwhile
 * is added to the length, so the rate follows the clocks and not the load. If the game is too slow for the clock, its
 * sound is slowed down like a tape's, without gaps or repetitions.
 */
#include "speaker.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "../../board/board.h"
#include "../../base/int.h"

enum {
    TICK = 100,                         /* percent of a tick per sixtieth, at full speed */
    MAX_OUTPUT = 2 * RESAMPLE_CAPACITY, /* frames per call */
    SIXTIETH_USEC = 1000000 / 60,
    MAX_LATE_USEC = 100000, /* later frames are not used for measuring */
    SLOW_FRAMES = 60,
    PRIME_FRAMES = 160, /* of silence per call */
    DRAIN_STEP_USEC = 2000,
    MAX_DRAIN_USEC = 250000,
    MAX_EXACT_DRAIN_USEC = 4000000
};

#define MIN_SPEED      0.25
#define MAX_SPEED      4.0
#define SPEED_RECOVERY 0.125 /* of the difference, per frame */

void speaker_open(struct speaker *s, int volume, bool muted, bool exact)
{
    *s = (struct speaker){
        .volume = volume, .music = 100, .sounds = 100, .muted = muted, .exact = exact, .game_speed = 1
    };
}

void speaker_set_levels(struct speaker *s, int music, int sounds)
{
    s->music = music;
    s->sounds = sounds;
    if (s->tables)
        board_sound_set_levels(s->tables, music, sounds);
}

/* ---- blocks ---- */

/* Allocates tables and resampler if necessary. Returns false when out of memory. */
static bool prepare(struct speaker *s)
{
    if (s->tables)
        return true;
    struct resample *r = malloc(sizeof *r);
    void *tables = malloc(board_sound_tables_size());
    if (!r || !tables) {
        free(r);
        free(tables);
        return false;
    }
    board_sound_init_tables(tables);
    board_sound_set_levels(tables, s->music, s->sounds);
    resample_open(r);
    s->tables = tables;
    s->resample = r;
    return true;
}

static void start_crossfade(struct speaker *s)
{
    memcpy(s->fading_out, s->recent, sizeof s->fading_out);
    s->crossfade_left = SPEAKER_CROSSFADE;
}

/* Returns the weight of the old sound `left` frames before the end of the crossfade, 0 to 32768, on a smooth curve. */
static int32_t fade_out_weight(int left)
{
    const int64_t t = ((int64_t)left << 15) / (SPEAKER_CROSSFADE + 1);

    return (int32_t)((t * t * (3 * 32768 - 2 * t)) >> 30);
}

static void crossfade(struct speaker *s, int16_t *block, int frames)
{
    for (int i = 0; i < frames && s->crossfade_left > 0; i++, s->crossfade_left--) {
        const int32_t old = fade_out_weight(s->crossfade_left);
        for (int c = 0; c < 2; c++) {
            const int32_t was = s->fading_out[2 * (s->crossfade_left - 1) + c], is = block[2 * i + c];
            block[2 * i + c] = (int16_t)((was * old + is * (32768 - old)) / 32768);
        }
    }
}

static void append(struct speaker *s, int16_t *block, int frames, bool continues)
{
    const int kept_frames = int_max(SPEAKER_CROSSFADE - frames, 0), new_frames = SPEAKER_CROSSFADE - kept_frames;

    if (!continues)
        start_crossfade(s);
    crossfade(s, block, frames);
    resample_add(s->resample, block, frames);
    memmove(s->recent, s->recent + 2 * new_frames, (size_t)kept_frames * 2 * sizeof *block);
    memcpy(s->recent + 2 * kept_frames, block + 2 * (frames - new_frames), (size_t)new_frames * 2 * sizeof *block);
}

static void append_silence(struct speaker *s, int frames)
{
    int16_t block[2 * SPEAKER_BLOCK] = { 0 };

    append(s, block, frames, !s->board);
    s->board = NULL;
}

static void reverse(int16_t block[2 * SPEAKER_BLOCK])
{
    for (int i = 0, k = SPEAKER_BLOCK - 1; i < k; i++, k--)
        for (int c = 0; c < 2; c++) {
            const int16_t other = block[2 * i + c];
            block[2 * i + c] = block[2 * k + c];
            block[2 * k + c] = other;
        }
}

/* Returns whether this frame continues the last block. The first frame of a run continues silence. */
static bool is_continuous(const struct speaker *s, const struct board *b, enum speaker_mode mode)
{
    const uint32_t frame = board_frame(b);

    if (!s->board)
        return frame == 1 && mode == SPEAKER_FORWARD;
    return s->board == b && s->mode == mode && frame == (mode == SPEAKER_REVERSE ? s->frame - 1 : s->frame + 1);
}

static void measure_peak(struct speaker *s, const int16_t *block)
{
    s->peak[0] = s->peak[1] = 0;
    for (int i = 0; i < 2 * SPEAKER_BLOCK; i++)
        s->peak[i & 1] = int_max(s->peak[i & 1], abs(block[i]));
}

static void add_block(struct speaker *s, const struct board *b, int16_t *block, enum speaker_mode mode)
{
    const int volume = mode == SPEAKER_FAST ? s->volume / 2 : s->volume;

    for (int i = 0; i < 2 * SPEAKER_BLOCK && volume != 100; i++)
        block[i] = (int16_t)(block[i] * volume / 100);
    if (mode == SPEAKER_REVERSE)
        reverse(block);
    append(s, block, SPEAKER_BLOCK, is_continuous(s, b, mode));
    s->board = b;
    s->frame = board_frame(b);
    s->mode = mode;
}

/* Adds the sound of another board to a block. */
static void mix_over(const struct speaker *s, const struct board *over, int16_t block[2 * SPEAKER_BLOCK])
{
    int16_t added[2 * SPEAKER_BLOCK];

    board_mix_sound(over, s->tables, added);
    for (int i = 0; i < 2 * SPEAKER_BLOCK; i++)
        block[i] = (int16_t)int_max(int_min(block[i] + added[i], INT16_MAX), INT16_MIN);
}

void speaker_add_frame(struct speaker *s, const struct board *b, const struct board *over, enum speaker_mode mode)
{
    const bool plays = !s->muted && s->state != SPEAKER_MISSING;
    int16_t block[2 * SPEAKER_BLOCK];

    if (!(plays || s->metering) || !board_has_sound(b) || !prepare(s))
        return;
    if (plays)
        s->buffered += TICK;
    if (plays && s->drop_blocks > 0) {
        s->drop_blocks--;
        s->stats.dropped++;
        return;
    }
    board_mix_sound(b, s->tables, block);
    if (over)
        mix_over(s, over, block);
    measure_peak(s, block);
    if (plays)
        add_block(s, b, block, mode);
}

/* ---- the queue ---- */

/* Fills an empty queue with silence, so that it has its target length after this frame. */
static void prime_queue(struct speaker *s, int sixtieths)
{
    static const int16_t silence[2 * SPEAKER_BLOCK];
    const int target = SPEAKER_TARGET_QUEUE - SPEAKER_BLOCK * (sixtieths - 1);

    if (s->state == SPEAKER_RUNNING) { /* fade in, because a sudden start would click */
        s->stats.underruns++;
        s->fade_in_left = s->exact ? 0 : SPEAKER_CROSSFADE;
    }
    for (int n = 0, i = 0; n < target && i < SPEAKER_TARGET_QUEUE / PRIME_FRAMES; i++, n = plat_queue_sound(NULL, 0))
        plat_queue_sound(silence, int_min(target - n, PRIME_FRAMES));
    drift_reset_error(&s->drift);
}

/* Estimates the game's speed relative to the clock. A single stall doesn't count as slowness; it causes a gap. */
static void estimate_game_speed(struct speaker *s, const struct speaker_elapsed *t)
{
    const double passed = (double)t->sixtieths * SIXTIETH_USEC, speed = passed / (passed + (double)t->lost);

    s->slow_left = t->lost && s->stall_window ? SLOW_FRAMES : int_max(s->slow_left - 1, 0);
    s->stall_window = t->lost ? SLOW_FRAMES : int_max(s->stall_window - 1, 0);
    s->game_speed = speed < s->game_speed ? speed : s->game_speed + (speed - s->game_speed) * SPEED_RECOVERY;
    s->game_speed = s->slow_left ? fmax(s->game_speed, MIN_SPEED) : 1;
}

static void record_latency(struct speaker *s, double ahead)
{
    s->stats.measurements++;
    s->stats.queued_sum += (uint64_t)ahead;
    s->stats.queued_max = (uint32_t)fmax(s->stats.queued_max, ahead);
}

/* Returns the rate for a slow game: its speed, adjusted to bring the queue to its target length. `error` (frames above
 * the target) can have any size after a stall, or when the host's clock is set. */
static double slow_rate(const struct speaker *s, double error)
{
    return fmin(fmax(s->game_speed * (1 + error / (2 * SPEAKER_TARGET_QUEUE)), MIN_SPEED), MAX_SPEED);
}

/* Returns the rate that holds the queue at its target length. */
static double choose_rate(struct speaker *s, const struct speaker_elapsed *t)
{
    const double ahead = s->queued + (double)t->late * SPEAKER_RATE / 1e6;

    if (s->queued > 0 && t->late < MAX_LATE_USEC && !s->slow_left)
        record_latency(s, ahead);
    if (s->exact)
        return 1;
    if (s->slow_left) /* frames arrive late and in groups, so the queue is always this long */
        return slow_rate(s, (s->slow_left > SLOW_FRAMES / 2 ? s->queued : ahead) - SPEAKER_TARGET_QUEUE);
    if (s->queued > 0 && t->late < MAX_LATE_USEC)
        drift_step(&s->drift, ahead - SPEAKER_TARGET_QUEUE);
    return 1 + s->drift.rate;
}

static void send_to_queue(struct speaker *s, const struct speaker_elapsed *t)
{
    static int16_t out[2 * MAX_OUTPUT];
    const int most = t->speed < TICK ? t->sixtieths * SPEAKER_BLOCK * t->speed / TICK : RESAMPLE_CAPACITY;
    const uint64_t step = (uint64_t)llrint((double)RESAMPLE_ONE * choose_rate(s, t)) * (uint64_t)t->speed / TICK;
    const int n = resample_take(s->resample, step, most, out, MAX_OUTPUT);

    for (int i = 0; i < n && s->fade_in_left > 0; i++, s->fade_in_left--)
        for (int c = 0; c < 2; c++)
            out[2 * i + c] = (int16_t)(out[2 * i + c] * (32768 - fade_out_weight(s->fade_in_left)) / 32768);
    plat_queue_sound(out, n);
}

/* Adds silence for elapsed time without sound. Below full speed, a tick lasts longer than a sixtieth. */
static void add_missing_silence(struct speaker *s, int sixtieths, int speed)
{
    s->buffered -= sixtieths * speed;
    for (; s->buffered < 0; s->buffered += speed) {
        if (s->drop_blocks > 0)
            s->drop_blocks--;
        else
            append_silence(s, SPEAKER_BLOCK * speed / TICK);
    }
    s->buffered = speed < TICK ? s->buffered : 0;
}

/* Starts from silence when the host's speaker is available again. */
static void restart(struct speaker *s)
{
    memset(s->recent, 0, sizeof s->recent);
    s->board = NULL;
    s->crossfade_left = s->buffered = s->drop_blocks = 0;
    resample_clear(s->resample);
    drift_reset_error(&s->drift);
}

/* Decides how many blocks to drop because the queue would become too long: after the card or the game has stalled. */
static void drop_late_blocks(struct speaker *s, const struct speaker_elapsed *t)
{
    if (s->exact || s->slow_left)
        return;
    if (s->queued > SPEAKER_MAX_QUEUE)
        s->drop_blocks = (s->queued - SPEAKER_TARGET_QUEUE) / SPEAKER_BLOCK;
    else if (s->queued == 0 && t->lost)
        s->drop_blocks = int_max(t->sixtieths * SPEAKER_BLOCK - SPEAKER_TARGET_QUEUE, 0) / SPEAKER_BLOCK;
}

void speaker_advance(struct speaker *s, const struct speaker_elapsed *t)
{
    if (!s->tables && s->state == SPEAKER_UNUSED) /* nothing was played yet */
        return;
    s->queued = plat_queue_sound(NULL, 0);
    if (s->queued < 0 || !prepare(s)) {
        s->state = SPEAKER_MISSING;
        return;
    }
    if (s->state == SPEAKER_MISSING)
        restart(s);
    estimate_game_speed(s, t);
    add_missing_silence(s, t->sixtieths, t->speed);
    if (s->queued == 0)
        prime_queue(s, t->sixtieths);
    s->state = SPEAKER_RUNNING;
    send_to_queue(s, t);
    drop_late_blocks(s, t);
}

bool speaker_sets_pace(const struct speaker *s)
{
    return s->exact && s->state == SPEAKER_RUNNING;
}

bool speaker_is_due(const struct speaker *s)
{
    return !speaker_sets_pace(s) || plat_queue_sound(NULL, 0) <= SPEAKER_TARGET_QUEUE;
}

void speaker_report(const struct speaker *s, char *line, size_t size)
{
    const struct speaker_stats *n = &s->stats;
    const double frame = 1000.0 / SPEAKER_RATE;

    if (s->state == SPEAKER_UNUSED || !n->measurements) {
        snprintf(line, size, "sound: nothing was played");
        return;
    }
    snprintf(line, size,
             "sound: latency %.1f ms on average, %.1f ms at most; clock drift of the sound card %+.3f %%; gaps %u, "
             "dropped blocks %u",
             ((double)n->queued_sum / (double)n->measurements + RESAMPLE_AFTER) * frame,
             (n->queued_max + RESAMPLE_AFTER) * frame, -100 * s->drift.sum, (unsigned)n->underruns,
             (unsigned)n->dropped);
}

/* Waits until the queue is empty, at most `limit` usec, even if the clock is set back meanwhile. */
static void drain(uint64_t limit)
{
    for (uint64_t passed = 0, last = plat_usec(); passed < limit && plat_queue_sound(NULL, 0) > 0;
         passed += clock_lap(&last))
        plat_wait(last + DRAIN_STEP_USEC);
}

void speaker_close(struct speaker *s)
{
    static const struct speaker_elapsed one = { 1, TICK, MAX_LATE_USEC, 0 };

    if (s->state == SPEAKER_RUNNING) {
        append_silence(s, SPEAKER_BLOCK);
        send_to_queue(s, &one);
        drain(s->exact ? MAX_EXACT_DRAIN_USEC : MAX_DRAIN_USEC);
    }
    free(s->tables);
    free(s->resample);
    *s = (struct speaker){ 0 };
}

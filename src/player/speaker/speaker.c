/*
 * speaker.c - see speaker.h.
 *
 * At a joint what was heard last is carried on as its own mirror image and fades out while the new sound fades in: the
 * level does not jump, and nothing has to be kept back for it.
 *
 * The queue is looked at when a frame comes, which may be late; as much as the card has used up meanwhile is added to
 * what waits, so that the rate follows the clocks and not the load. A game that cannot follow the clock at all is heard
 * as slow as it is, and lower, as a tape would be: there is no gap in it and nothing comes twice.
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
    ROOM = 2 * RESAMPLE_ROOM, /* frames that may come of one look */
    SIXTIETH = 1000000 / 60,  /* usec */
    LATE_MOST = 100000,       /* usec; later frames say nothing of the clocks */
    SLOWED = 60,              /* frames */
    PRIME = 160,              /* frames at once */
    DRAIN_STEP = 2000,        /* usec */
    DRAIN_MOST = 250000,
    DRAIN_EXACT = 4000000
};

#define PACE_LEAST 0.25
#define PACE_MOST  4.0
#define PACE_MENDS 0.125 /* of what is missing, in a frame */

void speaker_open(struct speaker *s, int volume, bool muted, bool exact)
{
    *s = (struct speaker){ .volume = volume, .music = 100, .sounds = 100, .muted = muted, .exact = exact, .pace = 1 };
}

void speaker_levels(struct speaker *s, int music, int sounds)
{
    s->music = music;
    s->sounds = sounds;
    if (s->memory)
        board_sound_set_levels(s->memory, music, sounds);
}

/* ---- blocks ---- */

/* What is made when it is first needed: tables and a resampler. */
static bool ready(struct speaker *s)
{
    if (s->memory)
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
    s->memory = tables;
    s->resample = r;
    return true;
}

static void begin_joint(struct speaker *s)
{
    memcpy(s->from, s->past, sizeof s->from);
    s->joint = SPEAKER_JOIN;
}

/* Of 32768, how much is left of the old sound `left` frames before the joint's end: a curve without corners. */
static int32_t old_share(int left)
{
    const int64_t t = ((int64_t)left << 15) / (SPEAKER_JOIN + 1);

    return (int32_t)((t * t * (3 * 32768 - 2 * t)) >> 30);
}

static void join(struct speaker *s, int16_t *block, int frames)
{
    for (int i = 0; i < frames && s->joint > 0; i++, s->joint--) {
        const int32_t old = old_share(s->joint);
        for (int c = 0; c < 2; c++) {
            const int32_t was = s->from[2 * (s->joint - 1) + c], is = block[2 * i + c];
            block[2 * i + c] = (int16_t)((was * old + is * (32768 - old)) / 32768);
        }
    }
}

static void append(struct speaker *s, int16_t *block, int frames, bool follows)
{
    const int kept = int_max(SPEAKER_JOIN - frames, 0), taken = SPEAKER_JOIN - kept;

    if (!follows)
        begin_joint(s);
    join(s, block, frames);
    resample_add(s->resample, block, frames);
    memmove(s->past, s->past + 2 * taken, (size_t)kept * 2 * sizeof *block);
    memcpy(s->past + 2 * kept, block + 2 * (frames - taken), (size_t)taken * 2 * sizeof *block);
}

static void append_silence(struct speaker *s, int frames)
{
    int16_t block[2 * SPEAKER_BLOCK] = { 0 };

    append(s, block, frames, !s->board);
    s->board = NULL;
}

static void turn_round(int16_t block[2 * SPEAKER_BLOCK])
{
    for (int i = 0, k = SPEAKER_BLOCK - 1; i < k; i++, k--)
        for (int c = 0; c < 2; c++) {
            const int16_t other = block[2 * i + c];
            block[2 * i + c] = block[2 * k + c];
            block[2 * k + c] = other;
        }
}

/* Does this frame follow the one heard before, without a joint? The first one ever follows silence as it is. */
static bool follows(const struct speaker *s, const struct board *b, enum speaker_way way)
{
    const uint32_t frame = board_frame(b);

    if (!s->board)
        return frame == 1 && way == SPEAKER_ON;
    return s->board == b && s->way == way && frame == (way == SPEAKER_BACK ? s->frame - 1 : s->frame + 1);
}

static void find_peak(struct speaker *s, const int16_t *block)
{
    s->peak[0] = s->peak[1] = 0;
    for (int i = 0; i < 2 * SPEAKER_BLOCK; i++)
        s->peak[i & 1] = int_max(s->peak[i & 1], abs(block[i]));
}

static void take(struct speaker *s, const struct board *b, int16_t *block, enum speaker_way way)
{
    const int volume = way == SPEAKER_FAST ? s->volume / 2 : s->volume;

    for (int i = 0; i < 2 * SPEAKER_BLOCK && volume != 100; i++)
        block[i] = (int16_t)(block[i] * volume / 100);
    if (way == SPEAKER_BACK)
        turn_round(block);
    append(s, block, SPEAKER_BLOCK, follows(s, b, way));
    s->board = b;
    s->frame = board_frame(b);
    s->way = way;
}

void speaker_hear(struct speaker *s, const struct board *b, enum speaker_way way, int slow)
{
    const bool plays = !s->muted && s->state != SPEAKER_GONE;
    int16_t block[2 * SPEAKER_BLOCK];

    if (!(plays || s->meter) || !board_has_sound(b) || !ready(s))
        return;
    if (plays)
        s->credit += slow;
    if (plays && s->refuse > 0) {
        s->refuse--;
        s->seen.refused++;
        return;
    }
    board_mix_sound(b, s->memory, block);
    find_peak(s, block);
    if (plays)
        take(s, b, block, way);
}

/* ---- the queue ---- */

/* Nothing waits: silence does, so that it is as after this frame it should be. */
static void prime(struct speaker *s, int sixtieths)
{
    static const int16_t silence[2 * SPEAKER_BLOCK];
    const int want = SPEAKER_AHEAD - SPEAKER_BLOCK * (sixtieths - 1);

    if (s->state == SPEAKER_GOOD) { /* there was a gap: what follows does not begin with a click */
        s->seen.dry++;
        s->rises = s->exact ? 0 : SPEAKER_JOIN;
    }
    for (int has = 0, i = 0; has < want && i < SPEAKER_AHEAD / PRIME; i++, has = plat_queue_sound(NULL, 0))
        plat_queue_sound(silence, int_min(want - has, PRIME));
    drift_jump(&s->drift);
}

/* How fast the game goes by the clock. A single stop is no slowness: what was missed then is a gap. */
static void find_pace(struct speaker *s, const struct speaker_time *t)
{
    const double passed = (double)t->sixtieths * SIXTIETH, pace = passed / (passed + (double)t->lost);

    s->slowed = t->lost && s->stumbled ? SLOWED : int_max(s->slowed - 1, 0);
    s->stumbled = t->lost ? SLOWED : int_max(s->stumbled - 1, 0);
    s->pace = pace < s->pace ? pace : s->pace + (pace - s->pace) * PACE_MENDS;
    s->pace = s->slowed ? fmax(s->pace, PACE_LEAST) : 1;
}

static void measure(struct speaker *s, double ahead)
{
    s->seen.looks++;
    s->seen.sum += (uint64_t)ahead;
    s->seen.most = (uint32_t)fmax(s->seen.most, ahead);
}

/* As the game goes, and towards what should wait, in some frames. `off` has no bound: a frame after a stop, or after
 * the host's clock was set, is late by any time. */
static double slowed_rate(const struct speaker *s, double off)
{
    return fmin(fmax(s->pace * (1 + off / (2 * SPEAKER_AHEAD)), PACE_LEAST), PACE_MOST);
}

/* How fast the blocks pass, so that what waits is as much as should. */
static double rate(struct speaker *s, const struct speaker_time *t)
{
    const double ahead = s->waiting + (double)t->late * SPEAKER_RATE / 1e6;

    if (s->waiting > 0 && t->late < LATE_MOST && !s->slowed)
        measure(s, ahead);
    if (s->exact)
        return 1;
    if (s->slowed) /* its frames come late, several at once: so much waits all the time */
        return slowed_rate(s, (s->slowed > SLOWED / 2 ? s->waiting : ahead) - SPEAKER_AHEAD);
    if (s->waiting > 0 && t->late < LATE_MOST)
        drift_step(&s->drift, ahead - SPEAKER_AHEAD);
    return 1 + s->drift.rate;
}

static void send(struct speaker *s, const struct speaker_time *t)
{
    static int16_t out[2 * ROOM];
    const int most = t->slow > 1 ? t->sixtieths * SPEAKER_BLOCK / t->slow : RESAMPLE_ROOM;
    const uint64_t step = (uint64_t)llrint((double)RESAMPLE_ONE * rate(s, t)) / (uint64_t)t->slow;
    const int n = resample_take(s->resample, step, most, out, ROOM);

    for (int i = 0; i < n && s->rises > 0; i++, s->rises--)
        for (int c = 0; c < 2; c++)
            out[2 * i + c] = (int16_t)(out[2 * i + c] * (32768 - old_share(s->rises)) / 32768);
    plat_queue_sound(out, n);
}

/* What has not passed is silence; frames that are taken in slow motion last longer. */
static void fill(struct speaker *s, int sixtieths, int slow)
{
    s->credit -= sixtieths;
    for (; s->credit < 0; s->credit++) {
        if (s->refuse > 0)
            s->refuse--;
        else
            append_silence(s, SPEAKER_BLOCK / slow);
    }
    s->credit = slow > 1 ? s->credit : 0;
}

/* There is a speaker, again or for the first time: nothing was heard. */
static void found(struct speaker *s)
{
    memset(s->past, 0, sizeof s->past);
    s->board = NULL;
    s->joint = s->credit = s->refuse = 0;
    resample_clear(s->resample);
    drift_jump(&s->drift);
}

/* What would wait for too long is not played: after a card that stood still, and after a stop of the game, whose last
 * frames come all at once. */
static void refuse_what_is_late(struct speaker *s, const struct speaker_time *t)
{
    if (s->exact || s->slowed)
        return;
    if (s->waiting > SPEAKER_MOST)
        s->refuse = (s->waiting - SPEAKER_AHEAD) / SPEAKER_BLOCK;
    else if (s->waiting == 0 && t->lost)
        s->refuse = int_max(t->sixtieths * SPEAKER_BLOCK - SPEAKER_AHEAD, 0) / SPEAKER_BLOCK;
}

void speaker_frame(struct speaker *s, const struct speaker_time *t)
{
    if (!s->memory && s->state == SPEAKER_OFF) /* nothing was ever heard */
        return;
    s->waiting = plat_queue_sound(NULL, 0);
    if (s->waiting < 0 || !ready(s)) {
        s->state = SPEAKER_GONE;
        return;
    }
    if (s->state == SPEAKER_GONE)
        found(s);
    find_pace(s, t);
    fill(s, t->sixtieths, t->slow);
    if (s->waiting == 0)
        prime(s, t->sixtieths);
    s->state = SPEAKER_GOOD;
    send(s, t);
    refuse_what_is_late(s, t);
}

bool speaker_leads(const struct speaker *s)
{
    return s->exact && s->state == SPEAKER_GOOD;
}

bool speaker_due(const struct speaker *s)
{
    return !speaker_leads(s) || plat_queue_sound(NULL, 0) <= SPEAKER_AHEAD;
}

void speaker_report(const struct speaker *s, char *line, size_t size)
{
    const struct speaker_seen *n = &s->seen;
    const double frame = 1000.0 / SPEAKER_RATE;

    if (s->state == SPEAKER_OFF || !n->looks) {
        snprintf(line, size, "sound: nothing was played");
        return;
    }
    snprintf(line, size,
             "sound: latency %.1f ms on average, %.1f ms at most; clock drift of the sound card %+.3f %%; gaps %u, "
             "dropped blocks %u",
             ((double)n->sum / (double)n->looks + RESAMPLE_AFTER) * frame, (n->most + RESAMPLE_AFTER) * frame,
             -100 * s->drift.sum, (unsigned)n->dry, (unsigned)n->refused);
}

/* Waits until all is heard, `most` usec at most, also of a clock that is set back meanwhile. */
static void drain(uint64_t most)
{
    for (uint64_t passed = 0, last = plat_usec(); passed < most && plat_queue_sound(NULL, 0) > 0;
         passed += clock_lap(&last))
        plat_wait(last + DRAIN_STEP);
}

void speaker_close(struct speaker *s)
{
    static const struct speaker_time one = { 1, 1, LATE_MOST, 0 };

    if (s->state == SPEAKER_GOOD) {
        append_silence(s, SPEAKER_BLOCK);
        send(s, &one);
        drain(s->exact ? DRAIN_EXACT : DRAIN_MOST);
    }
    free(s->memory);
    free(s->resample);
    *s = (struct speaker){ 0 };
}

/*
 * voices.c - see voices.h. The state advances a frame at a time; a frame is mixed in SND_FRAME_BLOCKS blocks of
 * SND_BLOCK samples. Each block starts at its exact phase. The level is interpolated linearly from the block's start to
 * its end, unless the level's slope jumps inside the block; then the level is computed for each sample.
 */
#include "voices.h"

#include "../base/trig.h"
#include "adpcm.h"
#include "fm.h"

static const struct column columns[] = {
    COLUMN(voices, phase),        COLUMN(voices, step0),        COLUMN(voices, step1),
    COLUMN(voices, age),          COLUMN(voices, release_age),  COLUMN(voices, fade_age),
    COLUMN(voices, pitch),        COLUMN(voices, target_pitch), COLUMN(voices, glide_step),
    COLUMN(voices, inst),         COLUMN(voices, wave),         COLUMN(voices, vol0),
    COLUMN(voices, vol1),         COLUMN(voices, pan0),         COLUMN(voices, pan1),
    REGISTER(voices, gain0),      REGISTER(voices, gain1),      REGISTER(voices, music_paused),
    REGISTER(voices, duck_depth),
};

const struct chip voices_chip = { .name = "voices", CHIP_COLUMNS(columns), .is_list = true, .unhashed = true };

/* ---- pitch ---- */

/* Returns an oscillator's value at an age, Q30. The oscillator stays at phase `turn` until its delay is over. */
static int32_t lfo_value(const struct lfo *l, int32_t age, uint32_t turn)
{
    const int32_t t = age - (int32_t)l->delay;

    return t <= 0 ? trig_sin30(turn) : trig_sin30(turn + (uint32_t)t * l->step);
}

/* Returns the phase step of slot i at an age, in the frame that starts at age `now`. An arpeggio's pitch is constant
 * during a frame. A recording's step is at most 4, which limits the samples that a frame reads. */
static uint64_t step_at(const struct voices *s, const uint8_t *rom, const struct inst *inst, int i, int32_t now,
                        int32_t age)
{
    const uint64_t max_step = (uint64_t)4 << 32;
    int32_t pitch = s->pitch[i];

    if (inst->arpeggio_count) {
        const int32_t frames = now > 0 ? (now + SND_FRAME - 1) / SND_FRAME : 0;
        pitch += (int8_t)inst->arpeggio[frames / inst->arpeggio_frames % inst->arpeggio_count] * PITCH_ONE;
    }
    if (inst->vibrato.depth)
        pitch += (int32_t)((int64_t)lfo_value(&inst->vibrato, age, 0) * inst->vibrato.depth >> 22);
    if (inst->pitch_curve)
        pitch += inst_curve_value(rom + s->inst[i] + inst->pitch_curve, age) * (PITCH_ONE / 256);
    if (inst->kind == INST_NOISE)
        return pitch_step(pitch) >> 12;
    if (inst->kind != INST_SAMPLE)
        return pitch_step(pitch);
    if (s->wave[i] == 0)
        return 0;
    const uint64_t step = pitch_ratio(pitch - inst->root) * sample_of(rom + s->wave[i]).rate / SND_RATE;
    return step < max_step ? step : max_step;
}

/* ---- starting and ending notes ---- */

/* Copies n slots. */
static void copy_slots(struct voices *s, int to, int from, int n)
{
    slots_copy_rows(&voices_chip, s, (uint32_t)to, (uint32_t)from, (uint32_t)n);
}

void voices_start_note(struct voices *s, const uint8_t *rom, int voice, const struct voice_note *n, int at)
{
    const struct inst i = inst_read(rom + n->inst);

    if (voices_is_busy(s, voice)) {
        copy_slots(s, VOICES + voice, voice, 1);
        voices_fade_out(s, VOICES + voice, at);
    }
    s->age[voice] = -at;
    s->release_age[voice] = s->fade_age[voice] = AGE_NEVER;
    s->pitch[voice] = s->target_pitch[voice] = n->pitch;
    s->glide_step[voice] = 0;
    s->inst[voice] = n->inst;
    s->wave[voice] = n->wave;
    s->vol0[voice] = s->vol1[voice] = n->vol;
    s->pan0[voice] = s->pan1[voice] = n->pan;
    s->step0[voice] = s->step1[voice] = step_at(s, rom, &i, voice, 0, 0);
    s->phase[voice] = 0 - (uint64_t)at * s->step0[voice];
}

void voices_slur(struct voices *s, const uint8_t *rom, int voice, int32_t pitch)
{
    if (!voices_is_busy(s, voice))
        return;
    const struct inst i = inst_read(rom + s->inst[voice]);
    s->pitch[voice] = s->target_pitch[voice] = pitch;
    s->glide_step[voice] = 0;
    s->step1[voice] = step_at(s, rom, &i, voice, s->age[voice], s->age[voice] + SND_FRAME);
}

void voices_glide(struct voices *s, int voice, int32_t pitch, int32_t frames)
{
    s->target_pitch[voice] = pitch;
    s->glide_step[voice] = (pitch - s->pitch[voice]) / (frames > 0 ? frames : 1);
    if (s->glide_step[voice] == 0)
        s->pitch[voice] = pitch;
}

void voices_release(struct voices *s, int voice, int at)
{
    const int32_t age = s->age[voice] + at;

    if (voices_is_busy(s, voice) && s->release_age[voice] == AGE_NEVER)
        s->release_age[voice] = age > 0 ? age : 0;
}

void voices_fade_out(struct voices *s, int voice, int at)
{
    const int32_t age = s->age[voice] + at;

    if (voices_is_busy(s, voice) && age < s->fade_age[voice])
        s->fade_age[voice] = age;
}

void voices_set_volume_and_pan(struct voices *s, int voice, uint16_t vol, uint8_t pan)
{
    s->vol1[voice] = vol;
    s->pan1[voice] = pan;
}

/* ---- suspended music ---- */

static int saved_slot(int save_index, int voice)
{
    return VOICE_SLOTS + save_index * VOICES_MUSIC + voice;
}

void voices_save_music(struct voices *s, int save_index)
{
    copy_slots(s, saved_slot(save_index, 0), 0, VOICES_MUSIC);
}

void voices_move_saved_music(struct voices *s, int to, int from)
{
    copy_slots(s, saved_slot(to, 0), saved_slot(from, 0), VOICES_MUSIC);
}

void voices_restore_music(struct voices *s, int save_index)
{
    for (int i = 0; i < VOICES_MUSIC; i++) {
        if (!voices_is_busy(s, saved_slot(save_index, i)))
            continue;
        if (voices_is_busy(s, i)) {
            copy_slots(s, VOICES + i, i, 1);
            voices_fade_out(s, VOICES + i, 0);
        }
        copy_slots(s, i, saved_slot(save_index, i), 1);
        s->vol0[i] = 0;
        s->inst[saved_slot(save_index, i)] = 0;
    }
}

/* ---- advancing by a frame ---- */

/* Advances the pitch by a frame of its slide. */
static void step_glide(struct voices *s, int i)
{
    const int32_t step = s->glide_step[i], to = s->target_pitch[i];

    if (step == 0)
        return;
    s->pitch[i] += step;
    if ((step > 0) == (s->pitch[i] >= to)) {
        s->pitch[i] = to;
        s->glide_step[i] = 0;
    }
}

/* Samples, 6 hours: ages stop here, and positions in loops, which are far shorter, move back by whole loops. */
enum { MAX_AGE = 1 << 30 };

static void step_slot(struct voices *s, const uint8_t *rom, int i)
{
    const struct inst inst = inst_read(rom + s->inst[i]);
    const uint64_t step = s->step0[i];
    const int64_t step_delta = (int64_t)(s->step1[i] - step) / SND_FRAME;
    bool has_ended = false;

    s->phase[i] += SND_FRAME * step + (uint64_t)(SND_FRAME * (SND_FRAME - 1) / 2 * step_delta);
    if (inst.kind == INST_SAMPLE && s->wave[i]) {
        const struct sample sample = sample_of(rom + s->wave[i]);
        const int64_t beyond = ((int64_t)s->phase[i] >> 32) - sample.n - SINC_TAPS,
                      loop = (int64_t)sample.n - sample.loop_start;
        if (sample.loop_start == SAMPLE_NO_LOOP)
            has_ended = beyond > 0;
        else if (beyond >= MAX_AGE)
            s->phase[i] -= (uint64_t)(beyond / loop * loop) << 32;
    }
    s->age[i] += s->age[i] < MAX_AGE ? SND_FRAME : 0;
    s->vol0[i] = s->vol1[i];
    s->pan0[i] = s->pan1[i];
    s->step0[i] = inst.arpeggio_count ? step_at(s, rom, &inst, i, s->age[i], s->age[i]) : s->step1[i];
    if (s->glide_step[i] || inst.arpeggio_count || inst.vibrato.depth || inst.pitch_curve) {
        step_glide(s, i);
        s->step1[i] = step_at(s, rom, &inst, i, s->age[i], s->age[i] + SND_FRAME);
    }
    if (has_ended || (s->fade_age[i] != AGE_NEVER && s->age[i] - s->fade_age[i] >= VOICE_FADE) ||
        wave_is_silent(&inst.env, s->age[i], s->release_age[i]))
        s->inst[i] = 0;
}

void voices_step(struct voices *s, const uint8_t *rom)
{
    for (int i = 0; i < VOICE_SLOTS; i++)
        if (voices_is_busy(s, i) && !(s->music_paused && i % VOICES < VOICES_MUSIC))
            step_slot(s, rom, i);
    s->gain0 = s->gain1;
}

/* ---- the mix ---- */

/* FILTERED_SAMPLES: maximum samples of a recording that a frame needs for interpolation, a multiple of four.
 * RAW_SAMPLES: FILTERED_SAMPLES plus the samples that the low-pass filters need on both sides. */
enum { FILTERED_SAMPLES = 4 * SND_FRAME + 64, RAW_SAMPLES = FILTERED_SAMPLES + LOW_PASS_TAPS };

/* A note in slot i, with the values that are computed once per frame. */
struct note {
    const struct voices *s;
    const struct snd_tables *t;
    int i;
    const uint8_t *bytes; /* the packed instrument */
    struct inst inst;
    struct fm_note fm;
    int32_t age, release_age, fade_age;
    int64_t step_delta; /* change of the step per sample */
    int mip0, mip1;
    int64_t first; /* sample index of filtered[0] in the recording */
    int16_t filtered[FILTERED_SAMPLES], raw[RAW_SAMPLES];
};

/* Returns the phase at sample `at` of the frame. */
static uint64_t phase_at(const struct note *n, int at)
{
    return n->s->phase[n->i] + (uint64_t)at * n->s->step0[n->i] +
           (uint64_t)((int64_t)at * (at - 1) / 2 * n->step_delta);
}

/* Reads the part of the sample that the frame needs, low-pass filtered so that it does not alias. */
static void read_sample(struct note *n, const uint8_t *rom)
{
    const struct voices *s = n->s;
    const struct sample sample = sample_of(rom + s->wave[n->i]);
    const int64_t last = ((int64_t)phase_at(n, SND_FRAME) >> 32) + SINC_TAPS;

    n->first = ((int64_t)s->phase[n->i] >> 32) - SINC_TAPS;
    const int64_t needed = last - n->first + 1;
    const int count = (int)(needed < FILTERED_SAMPLES ? needed : FILTERED_SAMPLES);
    if (snd_low_pass_row(s->step0[n->i]) < 0 && snd_low_pass_row(s->step1[n->i]) < 0) {
        sample_read(&sample, n->first, count, n->filtered);
        return;
    }
    sample_read(&sample, n->first - LOW_PASS_TAPS / 2, ((count + 3) & ~3) + LOW_PASS_TAPS, n->raw);
    wave_filter_low_pass(n->t, n->raw + LOW_PASS_TAPS / 2, count, s->step0[n->i], s->step1[n->i], n->filtered);
}

static void make_block(struct note *n, int b, int16_t out[SND_BLOCK])
{
    const uint64_t from = phase_at(n, b * SND_BLOCK), to = phase_at(n, (b + 1) * SND_BLOCK);
    const uint64_t step = (uint64_t)((int64_t)(to - from) / SND_BLOCK);
    const struct wave_params params = { from, step, n->mip0, n->mip1, b, (uint32_t)n->i, n->bytes + n->inst.wave };

    if (n->inst.kind == INST_SAMPLE)
        wave_resample_block(n->t, n->filtered + (((int64_t)from >> 32) - n->first), (uint32_t)from, step, out);
    else if (inst_op_count(n->inst.kind))
        fm_compute_note_block(&n->fm, n->t, n->age + b * SND_BLOCK, n->release_age, from, step, out);
    else
        wave_compute_block(n->t, &n->inst, &params, out);
}

/* ---- levels ---- */

/* Returns the note's level at an age, from its envelope, tremolo, volume curve and fade. */
static int32_t level_at(const struct note *n, int32_t age)
{
    const struct lfo *tremolo = &n->inst.tremolo;
    int32_t level = wave_level(&n->inst.env, age, n->release_age);

    if (tremolo->depth) {
        const int32_t attenuation =
            ((1 << 30) - lfo_value(tremolo, age, (uint32_t)1 << 30)) >> 16; /* cosine: 0 to 2, Q14 */
        level -= (level * tremolo->depth >> 15) * attenuation >> 15;
    }
    if (n->inst.volume_curve)
        level = level * inst_curve_value(n->bytes + n->inst.volume_curve, age) / 32767;
    if (n->fade_age == AGE_NEVER || age <= n->fade_age)
        return level;
    return age - n->fade_age >= VOICE_FADE ? 0 : level * (VOICE_FADE - (age - n->fade_age)) / VOICE_FADE;
}

static bool has_corner(const struct note *n, int32_t from, int32_t to)
{
    return wave_has_corner(&n->inst.env, from, to, n->release_age) ||
           (n->fade_age != AGE_NEVER && ((from < n->fade_age && to > n->fade_age) ||
                                         (from < n->fade_age + VOICE_FADE && to > n->fade_age + VOICE_FADE))) ||
           (n->inst.volume_curve && inst_curve_has_corner(n->bytes + n->inst.volume_curve, from, to));
}

/* Computes the levels of the samples of block b. Returns false if all are 0. */
static bool make_levels(const struct note *n, int b, int16_t out[SND_BLOCK])
{
    const int32_t from = n->age + b * SND_BLOCK, to = from + SND_BLOCK;

    if (has_corner(n, from, to)) {
        for (int k = 0; k < SND_BLOCK; k++)
            out[k] = (int16_t)level_at(n, from + k);
        return true;
    }
    const int32_t l0 = level_at(n, from), l1 = level_at(n, to);
    for (int k = 0, level = l0 * SND_BLOCK; k < SND_BLOCK; k++, level += l1 - l0)
        out[k] = (int16_t)(level >> 5);
    return l0 | l1;
}

/* Returns the gains at the start of block b, from volume, pan, the gain of music and the listener's volume. */
static struct wave_gains gains_at(const struct note *n, int b)
{
    const struct voices *s = n->s;
    const int i = n->i;
    int32_t pan = 2 * (s->pan0[i] + (s->pan1[i] - s->pan0[i]) * b / SND_FRAME_BLOCKS);
    int32_t vol = s->vol0[i] + (s->vol1[i] - s->vol0[i]) * b / SND_FRAME_BLOCKS;

    if (n->inst.pan_curve) {
        pan += 2 * inst_curve_value(n->bytes + n->inst.pan_curve, n->age + b * SND_BLOCK);
        pan = pan < 0 ? 0 : pan > 256 ? 256 : pan;
    }
    if (i % VOICES < VOICES_MUSIC)
        vol = vol * (s->gain0 + (s->gain1 - s->gain0) * b / SND_FRAME_BLOCKS) / VOICE_FULL_GAIN * n->t->music_volume /
              100;
    else
        vol = vol * n->t->sound_volume / 100;
    return (struct wave_gains){ vol * n->t->pan[256 - pan] >> 15, vol * n->t->pan[pan] >> 15 };
}

static void add_note(struct note *n, const uint8_t *rom, int32_t left[SND_FRAME], int32_t right[SND_FRAME])
{
    const struct voices *s = n->s;
    const int i = n->i;
    int16_t wave[SND_BLOCK], level[SND_BLOCK];

    n->bytes = rom + s->inst[i];
    n->inst = inst_read(n->bytes);
    n->age = s->age[i];
    n->release_age = s->release_age[i];
    n->fade_age = s->fade_age[i];
    n->step_delta = (int64_t)(s->step1[i] - s->step0[i]) / SND_FRAME;
    n->mip0 = snd_mip((uint32_t)(s->step0[i] >> 24));
    n->mip1 = snd_mip((uint32_t)(s->step1[i] >> 24));
    if (n->inst.kind == INST_SAMPLE && s->wave[i] == 0)
        return;
    if (n->inst.kind == INST_SAMPLE)
        read_sample(n, rom);
    if (inst_op_count(n->inst.kind))
        fm_begin(&n->fm, &n->inst, n->bytes);
    const bool has_constant_gains =
        s->pan0[i] == s->pan1[i] && s->vol0[i] == s->vol1[i] && s->gain0 == s->gain1 && !n->inst.pan_curve;
    struct wave_gains from, to = gains_at(n, 0);
    for (int b = 0; b < SND_FRAME_BLOCKS; b++) {
        from = to;
        if (!has_constant_gains)
            to = gains_at(n, b + 1);
        if (!make_levels(n, b, level))
            continue;
        make_block(n, b, wave);
        wave_add_to_mix(wave, level, &from, &to, left + b * SND_BLOCK, right + b * SND_BLOCK);
    }
}

void voices_mix(const struct voices *s, const uint8_t *rom, const struct snd_tables *t, int16_t out[2 * SND_FRAME])
{
    int32_t left[SND_FRAME] = { 0 }, right[SND_FRAME] = { 0 };
    struct note n = { .s = s, .t = t };
    const bool is_music_audible = s->gain0 != 0 || s->gain1 != 0;

    for (n.i = 0; n.i < VOICE_SLOTS; n.i++)
        if (voices_is_busy(s, n.i) && (is_music_audible || n.i % VOICES >= VOICES_MUSIC))
            add_note(&n, rom, left, right);
    for (int k = 0; k < SND_FRAME; k++) {
        out[2 * k] = wave_limit(left[k]);
        out[2 * k + 1] = wave_limit(right[k]);
    }
}

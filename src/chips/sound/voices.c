/*
 * voices.c - see voices.h: notes, and what a frame does to them.
 */
#include "voices.h"

#include "../../base/trig.h"
#include "../../snd/adpcm.h"

static const struct column columns[] = {
    COLUMN(voices, phase),   COLUMN(voices, step0), COLUMN(voices, step1), COLUMN(voices, age),
    COLUMN(voices, off),     COLUMN(voices, kill),  COLUMN(voices, pitch), COLUMN(voices, goal),
    COLUMN(voices, glide),   COLUMN(voices, inst),  COLUMN(voices, wave),  COLUMN(voices, vol0),
    COLUMN(voices, vol1),    COLUMN(voices, pan0),  COLUMN(voices, pan1),  REGISTER(voices, gain0),
    REGISTER(voices, gain1),
};

const struct chip voices_chip = { "voices", columns, sizeof columns / sizeof *columns, true, true };

/* The step of a note at that pitch. A sample's is at most 4, so that a frame reads few of them. */
static uint64_t step_of(const uint8_t *rom, const struct inst *i, uint32_t wave, int32_t pitch)
{
    const uint64_t most = (uint64_t)4 << 32;

    if (i->kind != INST_SAMPLE)
        return pitch_step(pitch);
    if (wave == 0)
        return 0;
    const uint64_t step = pitch_ratio(pitch - i->root) * sample_of(rom + wave).rate / SND_RATE;
    return step < most ? step : most;
}

/* Slot `from` as it is, in slot `to`. */
static void copy(struct voices *s, int to, int from)
{
    s->phase[to] = s->phase[from];
    s->step0[to] = s->step0[from];
    s->step1[to] = s->step1[from];
    s->age[to] = s->age[from];
    s->off[to] = s->off[from];
    s->kill[to] = s->kill[from];
    s->pitch[to] = s->pitch[from];
    s->goal[to] = s->goal[from];
    s->glide[to] = s->glide[from];
    s->inst[to] = s->inst[from];
    s->wave[to] = s->wave[from];
    s->vol0[to] = s->vol0[from];
    s->vol1[to] = s->vol1[from];
    s->pan0[to] = s->pan0[from];
    s->pan1[to] = s->pan1[from];
}

void voices_note(struct voices *s, const uint8_t *rom, int voice, const struct voice_note *n, int at)
{
    const struct inst i = inst_of(rom + n->inst);

    if (voices_busy(s, voice)) {
        copy(s, VOICES + voice, voice);
        voices_cut(s, VOICES + voice, at);
    }
    s->step0[voice] = s->step1[voice] = step_of(rom, &i, n->wave, n->pitch);
    s->phase[voice] = 0 - (uint64_t)at * s->step0[voice];
    s->age[voice] = -at;
    s->off[voice] = s->kill[voice] = NOTE_HELD;
    s->pitch[voice] = s->goal[voice] = n->pitch;
    s->glide[voice] = 0;
    s->inst[voice] = n->inst;
    s->wave[voice] = n->wave;
    s->vol0[voice] = s->vol1[voice] = n->vol;
    s->pan0[voice] = s->pan1[voice] = n->pan;
}

void voices_slur(struct voices *s, const uint8_t *rom, int voice, int32_t pitch)
{
    if (!voices_busy(s, voice))
        return;
    const struct inst i = inst_of(rom + s->inst[voice]);
    s->pitch[voice] = s->goal[voice] = pitch;
    s->glide[voice] = 0;
    s->step1[voice] = step_of(rom, &i, s->wave[voice], pitch);
}

void voices_glide(struct voices *s, int voice, int32_t pitch, int32_t frames)
{
    s->goal[voice] = pitch;
    s->glide[voice] = (pitch - s->pitch[voice]) / (frames > 0 ? frames : 1);
    if (s->glide[voice] == 0)
        s->pitch[voice] = pitch;
}

void voices_off(struct voices *s, int voice, int at)
{
    const int32_t age = s->age[voice] + at;

    if (voices_busy(s, voice) && s->off[voice] == NOTE_HELD)
        s->off[voice] = age > 0 ? age : 0;
}

void voices_cut(struct voices *s, int voice, int at)
{
    const int32_t age = s->age[voice] + at;

    if (voices_busy(s, voice) && age < s->kill[voice])
        s->kill[voice] = age;
}

void voices_set(struct voices *s, int voice, uint16_t vol, uint8_t pan)
{
    s->vol1[voice] = vol;
    s->pan1[voice] = pan;
}

/* ---- a frame ---- */

/* The pitch with its slide, a frame on. */
static void slide(struct voices *s, int i)
{
    const int32_t by = s->glide[i], to = s->goal[i];

    if (by == 0)
        return;
    s->pitch[i] += by;
    if ((by > 0) == (s->pitch[i] >= to)) {
        s->pitch[i] = to;
        s->glide[i] = 0;
    }
}

static int32_t vibrato(const struct inst *inst, int32_t age)
{
    const int32_t t = age - (int32_t)inst->vibrato_delay;

    if (inst->vibrato == 0 || t <= 0)
        return 0;
    return (int32_t)((int64_t)trig_sin30((uint32_t)t * inst->vibrato_step) * inst->vibrato >> 22);
}

static bool ended(const struct voices *s, const uint8_t *rom, const struct inst *inst, int i)
{
    if (s->kill[i] != NOTE_HELD && s->age[i] - s->kill[i] >= VOICE_FADE)
        return true;
    if (wave_over(inst, s->age[i], s->off[i]))
        return true;
    if (inst->kind != INST_SAMPLE || s->wave[i] == 0)
        return false;
    const struct sample sample = sample_of(rom + s->wave[i]);
    return sample.loop == SAMPLE_ENDS && (int64_t)s->phase[i] >> 32 > (int64_t)sample.n + SINC_TAPS;
}

enum { OLDEST = 1 << 30 /* samples: 6 hours. An age stays there */ };

static void step_slot(struct voices *s, const uint8_t *rom, int i)
{
    const struct inst inst = inst_of(rom + s->inst[i]);
    const uint64_t step = s->step0[i];
    const int64_t more = (int64_t)(s->step1[i] - step) / SND_FRAME;

    s->phase[i] += SND_FRAME * step + (uint64_t)(SND_FRAME * (SND_FRAME - 1) / 2 * more);
    s->age[i] += s->age[i] < OLDEST ? SND_FRAME : 0;
    s->vol0[i] = s->vol1[i];
    s->pan0[i] = s->pan1[i];
    slide(s, i);
    s->step0[i] = s->step1[i];
    s->step1[i] = step_of(rom, &inst, s->wave[i], s->pitch[i] + vibrato(&inst, s->age[i]));
    if (ended(s, rom, &inst, i))
        s->inst[i] = 0;
}

void voices_step(struct voices *s, const uint8_t *rom)
{
    const bool stands = s->gain0 == 0 && s->gain1 == 0;

    for (int i = 0; i < VOICE_SLOTS; i++)
        if (voices_busy(s, i) && !(stands && i % VOICES < VOICES_MUSIC))
            step_slot(s, rom, i);
    s->gain0 = s->gain1;
}

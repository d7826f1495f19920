/*
 * inspect_sound.c - the state of voices and music; see inspect.h.
 */
#include "inspect.h"

#include <stdlib.h>
#include <string.h>
#include "../base/int.h"
#include "../machine/machine.h"

static const char *const kind_names[INST_KINDS] = {
    [INST_PULSE] = "pulse", [INST_TRIANGLE] = "tri",  [INST_SAW] = "saw", [INST_SINE] = "sine", [INST_FM] = "fm",
    [INST_NOISE] = "noise", [INST_SAMPLE] = "sample", [INST_FM4] = "fm4", [INST_WAVE] = "wave",
};

/* Returns the name of the sound or music whose data contains an instrument. The data of all sounds, then of all music,
 * is stored in ascending order, so the result is the last sound or music that starts at or before the instrument. */
static const char *inst_source_name(const struct board *b, uint32_t inst)
{
    const struct cart *c = &b->cart;
    const char *name = "";

    for (int i = 0; i < c->count[CART_SOUNDS] && cart_tune_offset(c, CART_SOUNDS, i) <= inst; i++)
        name = cart_name(c, CART_SOUNDS, i);
    for (int i = 0; i < c->count[CART_TUNES] && cart_tune_offset(c, CART_TUNES, i) <= inst; i++)
        name = cart_name(c, CART_TUNES, i);
    return name;
}

static const char *music_name(const struct board *b, uint16_t index)
{
    return index ? cart_name(&b->cart, CART_TUNES, index - 1) : "";
}

void inspect_voice(const struct board *b, int i, struct inspect_voice *out)
{
    const struct voices *v = &b->voices;
    const bool music = i < VOICES_MUSIC;

    *out = (struct inspect_voice){ .is_music = music, .instrument_kind = "", .source = "" };
    if (!board_has_sound(b) || (!voices_is_busy(v, i) && !voices_is_busy(v, VOICES + i)))
        return;
    const int slot = voices_is_busy(v, i) ? i : VOICES + i;
    out->is_busy = true;
    out->is_ending = slot != i || v->release_age[slot] <= v->age[slot];
    out->instrument_kind = kind_names[inst_read(b->cart.tune_data + v->inst[slot]).kind];
    out->source = inst_source_name(b, v->inst[slot]);
    out->pitch = v->pitch[slot];
    out->pan = v->pan1[slot] - TUNE_PAN_CENTRE;
}

/* Mixes the voice and its tail alone and measures the result. */
int inspect_voice_peak(const struct board *b, int i, const void *tables)
{
    int16_t sound[2 * BOARD_SOUND_FRAMES];
    uint32_t inst[VOICE_SLOTS] = { 0 };
    struct voices solo = b->voices;
    int peak = 0;

    if (!board_has_sound(b))
        return 0;
    solo.inst = inst;
    inst[i] = b->voices.inst[i];
    inst[VOICES + i] = b->voices.inst[VOICES + i];
    if (inst[i] == 0 && inst[VOICES + i] == 0)
        return 0;
    voices_mix(&solo, b->cart.tune_data, tables, sound);
    for (int k = 0; k < 2 * BOARD_SOUND_FRAMES; k++)
        peak = int_max(peak, abs(sound[k]));
    return peak;
}

void inspect_music(const struct board *b, struct inspect_music *out)
{
    const struct seq *s = &b->music;

    *out = (struct inspect_music){ .name = "", .title = "", .mark = "", .next = "" };
    if (!board_has_sound(b) || !s->tune)
        return;
    const struct tune t = tune_of(b->cart.tune_data + cart_tune_offset(&b->cart, CART_TUNES, s->tune - 1));
    out->name = music_name(b, s->tune);
    out->title = tune_title(&t);
    out->mark = s->marker ? tune_marker_name(&t, s->marker - 1) : "";
    out->next = music_name(b, s->next_tune);
    out->bar = seq_beats(s) / (uint64_t)t.beats_per_bar;
    out->beat = (int)(seq_beats(s) % (uint64_t)t.beats_per_bar);
    out->beats_per_bar = t.beats_per_bar;
    out->tempo = s->tempo;
    out->gain = b->voices.gain1 * 100 / VOICE_FULL_GAIN;
    out->is_paused = b->core.frozen > 0;
}

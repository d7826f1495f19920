/*
 * voices.h - the voices: the state of each playing note at the start and at the end of a frame.
 *
 * A tick advances every voice by a frame, in closed form, whether or not its sound is output. voices_mix computes the
 * frame's samples from this state and does not change it. Scripts cannot read voices, so voices are outside the
 * combined hash.
 *
 * The first VOICES_MUSIC voices are for music, the others for sounds. Slot v is the note of voice v; slot VOICES + v is
 * its tail: the previous note, which fades out when a new one starts, to avoid a click. The remaining slots are
 * the notes of suspended music; they do not advance.
 *
 * inst and wave are places in the ROM: inst of the note's instrument (tune.h), 0: the slot is silent; wave of the
 * instrument's recording (adpcm.h), 0: none.
 */
#ifndef SOUND_VOICES_H
#define SOUND_VOICES_H

#include "wave.h"
#include "../base/slots.h"

enum {
    VOICES = 24,
    VOICES_MUSIC = 16,
    VOICE_SLOTS = 2 * VOICES,
    VOICE_MAX_SUSPENDED = 3, /* pieces of music that can be suspended (seq.h) */
    VOICE_CAPACITY = VOICE_SLOTS + VOICE_MAX_SUSPENDED * VOICES_MUSIC,
    VOICE_FADE = 96, /* samples in which a tail fades out */
    VOICE_FULL_VOLUME = 32767,
    VOICE_FULL_GAIN = 32767 /* full gain of music */
};

struct voices {
    struct slots s;
    uint64_t *phase; /* at the frame's first sample: 2^-56 turns; noise: 2^-44 turns; recording: sample index, Q32 */
    uint64_t *step0, *step1; /* phase per sample, at the frame's start and end */
    int32_t *age; /* samples since the note's start, at the frame's start; negative: the note starts in this frame */
    int32_t *release_age,
        *fade_age; /* ages at which the note is released, and at which it starts to fade out; AGE_NEVER: never */
    int32_t *pitch, *target_pitch; /* pitch without vibrato, and target of a slide; 65536ths of a semitone */
    int32_t *glide_step;           /* pitch change per frame; 0: no slide */
    uint32_t *inst, *wave;
    uint16_t *vol0, *vol1; /* volume, of VOICE_FULL_VOLUME, at the frame's start and end */
    uint8_t *pan0, *pan1;  /* pan at the frame's start and end; 0: left, 128: right */
    uint16_t gain0, gain1; /* gain of all music, of VOICE_FULL_GAIN, at the frame's start and end */
    uint16_t duck_depth;   /* how much softer music is because of a sound, of VOICE_FULL_GAIN */
    uint8_t music_paused;  /* 1: the music is paused; afterwards the frame in which the pause started plays again */
};

extern const struct chip voices_chip;

struct voice_note {
    uint32_t inst, wave;
    int32_t pitch;
    uint16_t vol;
    uint8_t pan;
};

/* Starts a note at sample `at` of the frame that starts now. */
void voices_start_note(struct voices *s, const uint8_t *rom, int voice, const struct voice_note *n, int at);

/* voices_slur continues a voice's note at another pitch; voices_glide slides the note to that pitch within `frames`
 * frames. voices_release releases the note at sample `at` of the frame; voices_fade_out fades it out from that sample
 * on. voices_set_volume_and_pan sets the note's volume and pan at the frame's end. */
void voices_slur(struct voices *s, const uint8_t *rom, int voice, int32_t pitch);
void voices_glide(struct voices *s, int voice, int32_t pitch, int32_t frames);
void voices_release(struct voices *s, int voice, int at);
void voices_fade_out(struct voices *s, int voice, int at);
void voices_set_volume_and_pan(struct voices *s, int voice, uint16_t vol, uint8_t pan);

/* voices_save_music saves the notes of the music at a place for suspended music, 0 to VOICE_MAX_SUSPENDED - 1;
 * voices_move_saved_music copies saved notes from one place to another; voices_restore_music restores the notes saved
 * at a place, fading in from silence. */
void voices_save_music(struct voices *s, int place);
void voices_move_saved_music(struct voices *s, int to, int from);
void voices_restore_music(struct voices *s, int place);

/* Advances all voices by a frame, except those of the music while it is paused. */
void voices_step(struct voices *s, const uint8_t *rom);

/* Computes the frame's SND_FRAME stereo samples, which depend only on s, rom and t. */
void voices_mix(const struct voices *s, const uint8_t *rom, const struct snd_tables *t, int16_t out[2 * SND_FRAME]);

/* Returns whether a slot holds a note. */
static inline bool voices_is_busy(const struct voices *s, int slot)
{
    return s->inst[slot] != 0;
}

#endif

/*
 * voices.h - the voices: the state of each playing note at the start and at the end of a frame.
 *
 * A tick advances every voice by a frame, in closed form, whether or not anybody listens. voices_mix computes the
 * frame's samples from the state here and changes nothing. No script can read a voice, so voices are outside the
 * combined hash.
 *
 * The first VOICES_MUSIC voices are for music, the others for sounds. Slot v is the note of voice v; slot VOICES + v is
 * its tail: the previous note, which fades out when a new one starts, so that nothing clicks. The remaining slots are
 * the notes of suspended music; they do not advance.
 *
 * inst and wave are places in the ROM: the note's instrument (tune.h), 0: silent; its recording (adpcm.h), 0: none.
 */
#ifndef SOUND_VOICES_H
#define SOUND_VOICES_H

#include "wave.h"
#include "../base/slots.h"

enum {
    VOICES = 24,
    VOICES_MUSIC = 16,
    VOICE_SLOTS = 2 * VOICES,
    VOICE_PLACES = 3, /* pieces of music that can be suspended (seq.h) */
    VOICE_ROOM = VOICE_SLOTS + VOICE_PLACES * VOICES_MUSIC,
    VOICE_FADE = 96, /* samples in which a tail fades out */
    VOICE_LOUD = 32767,
    VOICE_GAIN = 32767 /* full gain of music */
};

struct voices {
    struct slots s;
    uint64_t *phase; /* at the frame's first sample: 2^-56 turns; noise: 2^-44 turns; recording: sample index, Q32 */
    uint64_t *step0, *step1; /* phase per sample, at the frame's start and end */
    int32_t *age;          /* samples since the note started, at the frame's start; negative: it starts in this frame */
    int32_t *off, *kill;   /* ages at which it is released, and at which it starts to fade; NOTE_HELD: never */
    int32_t *pitch, *goal; /* without vibrato, and the target of a slide; 65536ths of a semitone */
    int32_t *glide;        /* pitch change per frame; 0: no slide */
    uint32_t *inst, *wave;
    uint16_t *vol0, *vol1; /* of VOICE_LOUD, at the frame's start and end */
    uint8_t *pan0, *pan1;  /* 0: left, 128: right */
    uint16_t gain0, gain1; /* of all music, of VOICE_GAIN, at the frame's start and end */
    uint16_t ducked;       /* how much softer music is because of a sound, of VOICE_GAIN */
    uint8_t held;          /* 1: a pause holds the music; afterwards the frame in which the pause started plays again */
};

extern const struct chip voices_chip;

struct voice_note {
    uint32_t inst, wave;
    int32_t pitch;
    uint16_t vol;
    uint8_t pan;
};

/* Starts a note at sample `at` of the frame that starts now. */
void voices_note(struct voices *s, const uint8_t *rom, int voice, const struct voice_note *n, int at);

/* voices_slur continues the voice's note at another pitch; voices_glide slides it there in that many frames. voices_off
 * releases it at sample `at` of the frame, voices_cut fades it out from there. voices_set sets its volume and pan at
 * the frame's end. */
void voices_slur(struct voices *s, const uint8_t *rom, int voice, int32_t pitch);
void voices_glide(struct voices *s, int voice, int32_t pitch, int32_t frames);
void voices_off(struct voices *s, int voice, int at);
void voices_cut(struct voices *s, int voice, int at);
void voices_set(struct voices *s, int voice, uint16_t vol, uint8_t pan);

/* voices_keep copies the notes of the music to a place for suspended music; voices_shift copies them from one place to
 * another; voices_bring restores them, fading in from silence. */
void voices_keep(struct voices *s, int place);
void voices_shift(struct voices *s, int to, int from);
void voices_bring(struct voices *s, int place);

/* Advances all voices by a frame, except those of music that is held. */
void voices_step(struct voices *s, const uint8_t *rom);

/* Computes the frame's SND_FRAME stereo samples from s, rom and t only. */
void voices_mix(const struct voices *s, const uint8_t *rom, const struct snd_tables *t, int16_t out[2 * SND_FRAME]);

/* Returns whether a slot has a note. */
static inline bool voices_busy(const struct voices *s, int slot)
{
    return s->inst[slot] != 0;
}

#endif

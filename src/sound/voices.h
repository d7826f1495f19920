/*
 * voices.h - the voices that sound: what each plays, at the beginning and at the end of a frame.
 *
 * A tick moves every voice by a frame, in closed form and whether anybody listens or not; voices_mix makes the frame's
 * samples of what stands here and changes nothing. No script can read a voice, so voices are outside the combined hash.
 *
 * The first VOICES_MUSIC are of music, the others of sounds. Slot v is the note of voice v; slot VOICES + v is its
 * tail: the note before, which fades when a new one begins, so that nothing clicks. Behind all of these are the notes
 * of music that is put aside, in which nothing moves.
 *
 * inst and wave are places in the ROM: of the note's instrument (tune.h), 0: silent; of its sample (adpcm.h), 0: none.
 */
#ifndef SOUND_VOICES_H
#define SOUND_VOICES_H

#include "wave.h"
#include "../base/slots.h"

enum {
    VOICES = 24,
    VOICES_MUSIC = 16,
    VOICE_SLOTS = 2 * VOICES,
    VOICE_PLACES = 3, /* of music that is put aside (seq.h) */
    VOICE_ROOM = VOICE_SLOTS + VOICE_PLACES * VOICES_MUSIC,
    VOICE_FADE = 96, /* samples in which a tail goes */
    VOICE_LOUD = 32767,
    VOICE_GAIN = 32767 /* of music that is not faded */
};

struct voices {
    struct slots s;
    uint64_t *phase;         /* at the frame's first sample: 2^-56 turns; of noise 2^-44; of a sample its place, Q32 */
    uint64_t *step0, *step1; /* of a sample, at the frame's first one and at its end */
    int32_t *age;            /* samples since the note began, at the first one; negative: it begins within */
    int32_t *off, *kill;     /* the age at which it is let go; from which on it fades in VOICE_FADE; or NOTE_HELD */
    int32_t *pitch, *goal;   /* 65536ths of a semitone, without vibrato; where it slides to */
    int32_t *glide;          /* a frame; 0: it does not slide */
    uint32_t *inst, *wave;
    uint16_t *vol0, *vol1; /* of VOICE_LOUD, at the frame's beginning and end */
    uint8_t *pan0, *pan1;  /* 0 left to 128 right */
    uint16_t gain0, gain1; /* of all music */
    uint16_t ducked;       /* of VOICE_GAIN: how much softer it is for a sound */
    uint8_t held;          /* music stands: it did not play the last frame, and plays it anew */
};

extern const struct chip voices_chip;

struct voice_note {
    uint32_t inst, wave;
    int32_t pitch;
    uint16_t vol;
    uint8_t pan;
};

/* A note begins at sample `at` of the frame that begins now. */
void voices_note(struct voices *s, const uint8_t *rom, int voice, const struct voice_note *n, int at);

/* What voice plays goes on at another pitch; slides there in so many frames; is let go; fades at once; is as loud and
 * where it says at the frame's end. */
void voices_slur(struct voices *s, const uint8_t *rom, int voice, int32_t pitch);
void voices_glide(struct voices *s, int voice, int32_t pitch, int32_t frames);
void voices_off(struct voices *s, int voice, int at);
void voices_cut(struct voices *s, int voice, int at);
void voices_set(struct voices *s, int voice, uint16_t vol, uint8_t pan);

/* Puts the notes of all music aside; one place's into another; brings them back as they were, out of silence. */
void voices_keep(struct voices *s, int place);
void voices_shift(struct voices *s, int to, int from);
void voices_bring(struct voices *s, int place);

/* Moves all by a frame, but for music that is held. */
void voices_step(struct voices *s, const uint8_t *rom);

/* The frame's SND_FRAME stereo samples. Reads s and rom alone. */
void voices_mix(const struct voices *s, const uint8_t *rom, const struct snd_tables *t, int16_t out[2 * SND_FRAME]);

/* Does it sound? */
static inline bool voices_busy(const struct voices *s, int slot)
{
    return s->inst[slot] != 0;
}

#endif

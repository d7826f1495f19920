/*
 * sound.h - sounds and music of a board: how a tick moves them, and what scripts and events ask for.
 *
 * All of it is for a game that declares sounds or music; of another the parts have no room, and nothing may be called
 * but sound_cue, which does nothing then.
 */
#ifndef MACHINE_SOUND_H
#define MACHINE_SOUND_H

#include "machine.h"

/* The beginning of a tick: what sounded moves on by a frame. Its end: music and sounds play the frame. */
void sound_begin(struct board *b);
void sound_end(struct board *b);

/* Plays a sound (seq.h). */
void sound_play(struct board *b, const struct cue *cue);

/* Ends the sound at that place in the ROM, 0: all. */
void sound_stop(struct board *b, uint32_t tune);

/* Plays the sound of that name, if the game has one, as if from there; grazes and items not in every frame. x: in the
 * field. */
void sound_cue_at(struct board *b, enum cart_cue cue, fx x);
static inline void sound_cue(struct board *b, enum cart_cue cue, fx x)
{
    if (b->cart.cue[cue])
        sound_cue_at(b, cue, x);
}

/* How far to a side something at x is heard, of TUNE_PAN: from the field's edges two thirds. */
int16_t sound_place(const struct board *b, fx x);

/* ---- music: a piece by its index ---- */

enum music_at { MUSIC_AT_ONCE, MUSIC_AT_BEAT, MUSIC_AT_BAR };
struct music_how {
    int32_t fade;     /* frames in which what plays fades first */
    enum music_at at; /* in place of a fade: on the beat or the bar of what plays */
    bool again;       /* from its beginning, though it plays or was put aside */
    bool back;        /* what plays is put aside, until this one has ended or sound_music_back ends it */
};

/* Begins a piece. What plays already goes on, and what was put aside goes on where it was. One that has ended plays no
 * more. False: nothing changed. */
bool sound_music(struct board *b, int tune, const struct music_how *how);

/* Ends that piece, if it plays, is to begin or was put aside: what was below it goes on, else there is silence. */
void sound_music_back(struct board *b, int tune, int32_t fade);

/* Ends the music in so many frames, and what was put aside. */
void sound_music_stop(struct board *b, int32_t fade);

/* How loud music is, of SEQ_FULL, in so many frames. */
void sound_volume(struct board *b, uint16_t level, int32_t over);

/* Power-on; a new game begins: silence, and nothing was heard. */
void sound_power(struct board *b);
void sound_game(struct board *b);

/* On the way to a mark, which begins and ends with sound_skip, the music goes the way that it would have gone: the
 * stage waits n frames; its clock is put n frames on, waits included; a fight is passed over, in which all fades end.
 * They return work (vm.h). */
void sound_skip(struct board *b, bool on);
uint64_t sound_pass_wait(struct board *b, int64_t n);
uint64_t sound_pass_clock(struct board *b, int64_t n);
uint64_t sound_pass_fight(struct board *b);

#endif

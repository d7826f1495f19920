/*
 * sound.h - sounds and music of a board: how a tick moves them, and what scripts and events ask for.
 * floor: board
 *
 * All of it is for a game that declares sounds or music; of another the parts have no room, and nothing may be called
 * but sound_cue, which does nothing then.
 */
#ifndef BOARD_SOUND_H
#define BOARD_SOUND_H

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

/* Begins a piece of music (its index), after what plays has faded in so many frames. What plays already goes on, and
 * what was put aside goes on where it was, unless it is to begin again. MUSIC_BACK: what plays is put aside until then,
 * or until the piece has ended. One that has ended plays no more. */
enum { MUSIC_AGAIN = 1, MUSIC_BACK = 2 };
void sound_music(struct board *b, int tune, int32_t fade, unsigned how);

/* Ends that piece, if it plays or is to begin: what was put aside goes on, else there is silence. */
void sound_music_back(struct board *b, int tune, int32_t fade);

/* Ends the music in so many frames. */
void sound_music_stop(struct board *b, int32_t fade);

/* On the way to a mark: n frames pass for the music; the way's end, a fade is over. */
void sound_pass(struct board *b, int64_t n);
void sound_arrive(struct board *b);

#endif

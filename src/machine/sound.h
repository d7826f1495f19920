/*
 * sound.h - the sounds and music of a board: playing them tick by tick, and requests by scripts and events.
 *
 * If a game declares neither sounds nor music, the sound parts have no slots, and of these functions only
 * sound_play_cue may be called; it then does nothing.
 */
#ifndef MACHINE_SOUND_H
#define MACHINE_SOUND_H

#include "machine.h"

/* sound_begin_tick, at the start of a tick, advances the voices by a frame; sound_end_tick, at its end, plays a frame
 * of music and sounds. */
void sound_begin_tick(struct board *b);
void sound_end_tick(struct board *b);

/* Plays a sound (seq.h). */
void sound_play(struct board *b, const struct cue *cue);

/* Ends the sound whose tune is at this offset in the ROM's tune data; 0: all sounds. */
void sound_stop(struct board *b, uint32_t tune);

/* Plays the sound that the game has set for this cue, if any, panned for position x in the field. Graze and item sounds
 * do not repeat in every frame. */
void sound_start_cue(struct board *b, enum cart_cue cue, fx x);
static inline void sound_play_cue(struct board *b, enum cart_cue cue, fx x)
{
    if (b->cart.cue_offset[cue])
        sound_start_cue(b, cue, x);
}

/* Returns the pan of a sound at x, -TUNE_PAN_CENTRE to TUNE_PAN_CENTRE; the view's edges are at two thirds of
 * TUNE_PAN_CENTRE. */
int16_t sound_pan_at(const struct board *b, fx x);

/* ---- music; `tune` is the index of a piece ---- */

enum music_start_point { MUSIC_AT_ONCE, MUSIC_AT_BEAT, MUSIC_AT_BAR };
struct music_options {
    int32_t fade;                    /* frames in which the current piece fades out first */
    enum music_start_point start_at; /* instead of a fade, start on a beat or bar of the current piece */
    bool restart;                    /* start the piece from its beginning, even if it is playing or set aside */
    bool suspend_current; /* set the current piece aside until the new piece ends, by itself or by sound_end_music */
};

/* Starts a piece. Unless options->restart is set, a piece that was set aside resumes where it was interrupted. Returns
 * false if the piece is already playing or about to start: then it continues, and a pending change to another piece is
 * cancelled. A piece that has ended no longer counts as playing. */
bool sound_start_music(struct board *b, int tune, const struct music_options *options);

/* Ends a piece if it is playing, about to start or set aside. A piece that is playing fades out in `fade` frames; then
 * the piece set aside last resumes, or there is silence if there is none. */
void sound_end_music(struct board *b, int tune, int32_t fade);

/* Fades out the music in `fade` frames, and ends the pieces set aside. */
void sound_stop_music(struct board *b, int32_t fade);

/* Changes the music volume gradually to `level` (SEQ_FULL_VOLUME: full volume) over `frames` frames. */
void sound_set_volume(struct board *b, uint16_t level, int32_t frames);

/* sound_reset resets the volumes at power-on. sound_start_game, at the start of a game, stops the music and clears the
 * list of pieces heard. */
void sound_reset(struct board *b);
void sound_start_game(struct board *b);

/* sound_set_skipping starts and ends skipping to a mark, in which the music advances as if the stage had been played.
 * Call sound_skip_wait when the stage skips a wait of n frames; sound_skip_clock when the stage's clock moves n frames
 * ahead, including waits already reported by sound_skip_wait; sound_skip_fight when a fight is skipped, which ends all
 * fades. They return the work done (vm.h). */
void sound_set_skipping(struct board *b, bool on);
uint64_t sound_skip_wait(struct board *b, int64_t n);
uint64_t sound_skip_clock(struct board *b, int64_t n);
uint64_t sound_skip_fight(struct board *b);

#endif

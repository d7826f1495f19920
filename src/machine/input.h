/*
 * input.h - the pads as a game sees them: held, pressed, released and repeated buttons, and a buffer of presses.
 *
 * A press is a frame in which a button went down. It can be taken once (input_take) while it is at most MAX_PRESS_AGE
 * frames old. The game and the pause screen have separate presses: a press during a pause does not count for the game,
 * and the game's presses do not age during a pause.
 *
 * A page may show a ship that plays by itself (input_play): its scripts and its movement then read the page's buttons,
 * while presses are still the player's, for the page to take.
 */
#ifndef MACHINE_INPUT_H
#define MACHINE_INPUT_H

#include "../base/pads.h"
#include "../base/slots.h"

enum { REPEAT_AFTER = 20, REPEAT_EVERY = 5, MAX_PRESS_AGE = 60 }; /* frames */

enum press_side { PRESS_GAME, PRESS_PAUSE, PRESS_SIDES, PRESS_NOBODY = PRESS_SIDES };

struct input {
    struct slots s;    /* a list of two entries, one per player */
    uint16_t *held;    /* the player's buttons */
    uint16_t *played;  /* 0, or the buttons of input_play and a mark that it was called */
    uint16_t *pressed; /* down in this frame, up in the previous one */
    uint16_t *released;
    uint16_t *repeated;    /* pressed, and again every few frames while held */
    uint32_t *held_frames; /* PAD_BUTTON_COUNT values per player: frames held */
    uint64_t *presses;     /* PRESS_SIDES * PAD_BUTTON_COUNT per player; bit k: pressed k frames ago, not taken yet */
};

extern const struct chip input_chip;

/* Reads this frame's pads. Opposite directions held together cancel out. The frame's presses are added to the buffer of
 * `side` (PRESS_NOBODY: to none); the other side's presses do not age. carry: buttons pressed, released and repeated in
 * the previous frame also count in this frame, so a run of PRESS_NOBODY frames passes them on to the first frame after
 * the run. */
void input_latch(struct input *in, const uint16_t pads[MAX_PLAYERS], enum press_side side, bool carry);

/* Makes the ship of player p play by these buttons in this frame. Bomb and special also count as pressed. */
void input_play(struct input *in, uint32_t p, unsigned pads);

/* Gives the ship of player p the player's own buttons again. Returns whether input_play was called in this frame. */
bool input_end_play(struct input *in, uint32_t p);

/* Returns the buttons that the ship of player p sees as held. */
unsigned input_held(const struct input *in, uint32_t p);

/* Clears the pressed, released and repeated buttons, so that nothing carries over into the next frame. */
void input_clear_edges(struct input *in);

/* Takes the oldest press of a button among the presses that are at most n frames old (0 to MAX_PRESS_AGE; 0: this
 * frame). Returns whether there was one. */
bool input_take(struct input *in, uint32_t p, uint32_t button, uint32_t n, enum press_side side);

/* Drops all presses of these buttons (PAD_ bits) by player p from the buffer of `side`. */
void input_drop_presses(struct input *in, uint32_t p, enum press_side side, unsigned buttons);

#endif

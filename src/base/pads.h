/*
 * pads.h - one player's pad in one frame, the same in RAM, demos and ports: a bit for each button, and a code.
 *
 * A code is a number that the program sends to the game in a single frame: a choice of the pause menu, or a key of name
 * entry. Bits 10 to 15 store it; 0: none.
 */
#ifndef BASE_PADS_H
#define BASE_PADS_H

#include <stdbool.h>
#include <stdint.h>

enum {
    PAD_UP = 1 << 0,
    PAD_DOWN = 1 << 1,
    PAD_LEFT = 1 << 2,
    PAD_RIGHT = 1 << 3,
    PAD_FIRE = 1 << 4,
    PAD_BOMB = 1 << 5,
    PAD_FOCUS = 1 << 6,
    PAD_SPECIAL = 1 << 7,
    PAD_START = 1 << 8,
    PAD_SELECT = 1 << 9,
    PAD_ALL = (1 << 10) - 1,
    MAX_PLAYERS = 2, /* players */
    PAD_BUTTON_COUNT = 10,
    PAD_CODE_SHIFT = 10
};

enum { PAUSE_ENTRIES = 8 /* most entries that a game adds to the pause menu */ };

/* The characters of name entry, in the order of their codes. */
#define CODE_CHARACTERS "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-!? "

enum pad_code {
    CODE_NONE,
    CODE_RESTART, /* start the same game again */
    CODE_QUIT,    /* return to the title */
    CODE_ENTRY,   /* and the following ones: the game's entries in the pause menu */
    CODE_BACKSPACE = CODE_ENTRY + PAUSE_ENTRIES,
    CODE_ENTER,
    CODE_CHARACTER, /* and the following ones: CODE_CHARACTERS */
    CODE_END = CODE_CHARACTER + sizeof CODE_CHARACTERS - 1
};

static inline unsigned pad_code(uint16_t pad)
{
    return (unsigned)pad >> PAD_CODE_SHIFT;
}

/* Returns whether the code is one of enum pad_code. Any combination of buttons is valid. */
static inline bool pad_is_valid(uint16_t pad)
{
    return pad_code(pad) < CODE_END;
}

/* Button names in bit order, as scripts and key maps spell them. */
#define PAD_BUTTON_NAMES                                                                                               \
    {                                                                                                                  \
        "up", "down", "left", "right", "fire", "bomb", "focus", "special", "start", "select"                           \
    }

#endif

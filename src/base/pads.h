/*
 * pads.h - the button bits of one player's pad, the same in RAM, demos and ports.
 */
#ifndef BASE_PADS_H
#define BASE_PADS_H

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
    PAD_SELECT = 1 << 9, /* bits 10 to 15 are reserved and always 0 in pads */
    PAD_ALL = (1 << 10) - 1,
    MAX_PLAYERS = 2, /* players */
    PAD_BUTTON_COUNT = 10
};

/* Button names in bit order, as scripts and key maps spell them. */
#define PAD_BUTTON_NAMES                                                                                               \
    {                                                                                                                  \
        "up", "down", "left", "right", "fire", "bomb", "focus", "special", "start", "select"                           \
    }

#endif

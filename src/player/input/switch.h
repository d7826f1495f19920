/*
 * switch.h - a key, or a controller's switch, as 16 bits, and its names: as the settings spell it, and as it is
 * printed on a controller. keys.h lists the spellings.
 */
#ifndef PLAYER_SWITCH_H
#define PLAYER_SWITCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../platform/platform.h"

/* A code is a HID usage, with SWITCH_ALT or SWITCH_CTRL if that is held too; or SWITCH_CONTROLLER, which controller in
 * bits 5 to 7 (from 1; 0: the player's own), and enum plat_button below. 0: no switch. */
enum { SWITCH_CONTROLLER = 0x100, SWITCH_ALT = 0x1000, SWITCH_CTRL = 0x2000, SWITCH_NAME = 32 };

/* HID usages of keys with a fixed meaning. */
enum {
    KEY_DIGIT_1 = 30, /* followed by 2 to 9 and 0 */
    KEY_ENTER = 40,
    KEY_ESCAPE = 41,
    KEY_BACKSPACE = 42,
    KEY_HOME = 74,
    KEY_DELETE = 76,
    KEY_END = 77,
    KEY_RIGHT = 79,
    KEY_LEFT = 80,
    KEY_DOWN = 81,
    KEY_UP = 82,
    KEY_KEYPAD_ENTER = 88,
    KEY_KEYPAD_1 = 89,
    KEY_LEFT_CTRL = 224,
    KEY_LEFT_ALT = 226,
    KEY_RIGHT_CTRL = 228,
    KEY_RIGHT_ALT = 230
};

static inline unsigned switch_which(unsigned code)
{
    return code >> 5 & 7;
}

static inline unsigned switch_bit(unsigned code)
{
    return code & 31;
}

static inline bool switch_is_chord(unsigned code)
{
    return code & (SWITCH_ALT | SWITCH_CTRL);
}

/* The code of a spelling like "z", "alt+enter" or "pad2.south"; 0: it is none. */
uint16_t switch_code(const char *name);

/* The spelling that switch_code reads as this code; "none" for 0. SWITCH_NAME bytes hold any. */
void switch_name(unsigned code, char *out, size_t size);

/* What is printed on it: "cross", "RB", "D-pad up"; on a controller of no known kind, where it is: "bottom button". Of
 * which controller is not said. Of a key what its layout has there, if the port knows that and the canvas has it, else
 * the spelling: "w" for "z" on a French keyboard. SWITCH_NAME bytes hold any. */
void switch_label(unsigned code, enum plat_controller_kind kind, char *out, size_t size);

/* "PlayStation 4", "controller": for one that has no name of its own. */
const char *switch_kind_name(enum plat_controller_kind kind);

#endif

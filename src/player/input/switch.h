/*
 * switch.h - a key or a controller's button as a 16-bit code, its name in the settings (see keys.h), and its label,
 * which is printed on the device.
 */
#ifndef PLAYER_SWITCH_H
#define PLAYER_SWITCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../platform/platform.h"

/* A code is a HID usage, with SWITCH_ALT or SWITCH_CTRL for a chord; or SWITCH_CONTROLLER, with the controller in bits
 * 5 to 7 (from 1; 0: the player's own) and enum plat_button in bits 0 to 4. 0: none. */
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

/* Returns the code of a name such as "z", "alt+enter" or "pad2.south"; 0 if the name is unknown. */
uint16_t switch_code(const char *name);

/* Writes the name of a code; "none" for 0. SWITCH_NAME bytes are enough. */
void switch_name(unsigned code, char *out, size_t size);

/* Writes the label of a code. For a button, that is what is printed on it ("cross", "RB", "D-pad up"), or its position
 * for an unknown controller ("bottom button"), without the controller's number. For a key, it is the label in the
 * user's keyboard layout ("w" for "z" on a French keyboard), or the name if the port doesn't know the label or the
 * canvas cannot draw it. SWITCH_NAME bytes are enough. */
void switch_label(unsigned code, enum plat_controller_kind kind, char *out, size_t size);

/* Returns the name of a kind: "PlayStation 4", or "controller" for unknown ones. */
const char *switch_kind_name(enum plat_controller_kind kind);

#endif

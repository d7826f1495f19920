/*
 * input_code.h - input codes: a key or a controller's button as a 16-bit number, with its name in the settings (keys.h)
 * and the label that is printed on the device.
 */
#ifndef PLAYER_INPUT_CODE_H
#define PLAYER_INPUT_CODE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../platform/platform.h"

/* A code is a HID usage, with INPUT_CODE_ALT or INPUT_CODE_CTRL for a chord; or INPUT_CODE_CONTROLLER, with the
 * controller in bits 5 to 7 (from 1; 0: the player's own) and enum plat_button in bits 0 to 4. 0: none. */
enum { INPUT_CODE_CONTROLLER = 0x100, INPUT_CODE_ALT = 0x1000, INPUT_CODE_CTRL = 0x2000, INPUT_CODE_NAME_SIZE = 32 };

/* HID usages of keys with a fixed meaning. */
enum {
    KEY_A = 4,        /* followed by B to Z */
    KEY_DIGIT_1 = 30, /* followed by 2 to 9 and 0 */
    KEY_ENTER = 40,
    KEY_ESCAPE = 41,
    KEY_BACKSPACE = 42,
    KEY_SPACE = 44, /* followed by punctuation, up to KEY_SLASH */
    KEY_SLASH = 56,
    KEY_HOME = 74,
    KEY_DELETE = 76,
    KEY_END = 77,
    KEY_RIGHT = 79,
    KEY_LEFT = 80,
    KEY_DOWN = 81,
    KEY_UP = 82,
    KEY_KEYPAD_DIVIDE = 84, /* up to KEY_KEYPAD_POINT: the keys of the keypad */
    KEY_KEYPAD_ENTER = 88,
    KEY_KEYPAD_1 = 89,
    KEY_KEYPAD_POINT = 99,
    KEY_LEFT_CTRL = 224,
    KEY_LEFT_ALT = 226,
    KEY_RIGHT_CTRL = 228,
    KEY_RIGHT_ALT = 230
};

static inline unsigned input_code_controller(unsigned code)
{
    return code >> 5 & 7;
}

static inline unsigned input_code_button(unsigned code)
{
    return code & 31;
}

static inline bool input_code_is_chord(unsigned code)
{
    return code & (INPUT_CODE_ALT | INPUT_CODE_CTRL);
}

/* Returns the code of a name such as "z", "alt+enter" or "pad2.south"; 0 if the name is unknown. */
uint16_t input_code_parse(const char *name);

/* Writes the name of a code; "none" for 0. INPUT_CODE_NAME_SIZE bytes are enough. */
void input_code_name(unsigned code, char *out, size_t size);

/* Writes the label of a code. For a button, that is what is printed on it ("cross", "RB", "D-pad up"), or its position
 * for an unknown controller ("Bottom button"), without the controller's number. For a key, it is the label in the
 * user's keyboard layout ("w" for "z" on a French keyboard), or the name if the port doesn't know the label or the
 * canvas cannot draw it. INPUT_CODE_NAME_SIZE bytes are enough. */
void input_code_label(unsigned code, enum plat_controller_kind kind, char *out, size_t size);

/* Returns the name of a kind: "PlayStation 4", or "controller" for unknown ones. */
const char *input_code_controller_name(enum plat_controller_kind kind);

#endif

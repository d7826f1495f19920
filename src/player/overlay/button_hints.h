/*
 * button_hints.h - draws which button does what: each button as its picture, with its meaning behind it.
 */
#ifndef PLAYER_BUTTON_HINTS_H
#define PLAYER_BUTTON_HINTS_H

#include "../input/input_code.h"
#include "canvas.h"

/* The picture of a button. kind: of the controller (enum plat_controller_kind), whose buttons have its colours; -1: the
 * keyboard. */
struct button_cap {
    char label[INPUT_CODE_NAME_SIZE]; /* what is printed on it; "": none */
    int kind;
};

enum { BUTTON_HINT_CAPS = 2 /* of two players */ };
struct button_hint {
    struct button_cap cap[BUTTON_HINT_CAPS]; /* none: the meaning is a title */
    const char *meaning;
};

enum { BUTTON_HINTS_HEIGHT = 13 /* px */ };

/* Writes what is printed on a key or button with this label (input_code_label): "Z" for z, "Shift" for lshift, "[" for
 * lbracket. kind: as above; controllers' labels are printed as they are. */
void button_hints_print(const char *label, int kind, char out[INPUT_CODE_NAME_SIZE]);

/* Draws n hints in the middle of a dark band from row y down, which is at least `width` px wide. Hints that don't fit
 * the picture are left out, the last ones first. Replaces the labels by what is printed on the keys. */
void button_hints_draw(const struct canvas *canvas, int y, int width, struct button_hint *hint, int n);

#endif

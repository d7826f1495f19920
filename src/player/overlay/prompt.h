/*
 * prompt.h - the prompt for a frame number. Reads digits, Backspace, Enter and Escape from the keyboard.
 */
#ifndef PLAYER_PROMPT_H
#define PLAYER_PROMPT_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../platform/platform.h"

struct prompt {
    bool open;
    char digits[8]; /* typed so far, NUL-terminated; 7 digits are more than a demo has frames */
    uint8_t held[PLAT_KEYS / 8];
};

void prompt_open(struct prompt *p, const struct plat_input *in);

/* Handles the keys of a poll while the prompt is open. Returns true when Enter is pressed after a number. Escape, and
 * Enter without a number, only close the prompt. */
bool prompt_poll(struct prompt *p, const struct plat_input *in, uint32_t *frame);

#endif

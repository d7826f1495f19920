/*
 * prompt.h - the prompt for a frame number: digits, Backspace, Enter and Escape, read from the keyboard itself.
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

/* The keys of a poll while it is open. True once, when Enter gave a number; Escape and an empty Enter only close. */
bool prompt_poll(struct prompt *p, const struct plat_input *in, uint32_t *frame);

#endif

/*
 * ask.h - asks for a frame: digits, Backspace, Enter, Escape, read from the keyboard itself.
 * floor: cab    used by: cab
 */
#ifndef CAB_ASK_H
#define CAB_ASK_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../platform/platform.h"

struct ask {
    bool open;
    char digits[8]; /* typed so far, ends in NUL: at most 7, more than a demo has frames */
    uint8_t held[PLAT_KEYS / 8];
};

void ask_open(struct ask *a, const struct plat_input *in);

/* The keys of a poll while it is open. True once, when Enter gave a number; Escape and an empty Enter only close. */
bool ask_poll(struct ask *a, const struct plat_input *in, uint32_t *frame);

#endif

/*
 * channel.h - what the program and the game tell each other during a run: the codes of this frame, and the game's
 * entries in the pause menu.
 */
#ifndef MACHINE_CHANNEL_H
#define MACHINE_CHANNEL_H

#include "../base/pads.h"
#include "../base/slots.h"

enum { PAUSE_LABEL_SIZE = 32 /* bytes, with the terminating NUL */ };

struct channel {
    struct slots s;            /* no slots: all state is in registers */
    uint8_t code[MAX_PLAYERS]; /* enum pad_code */
    uint8_t is_listening;      /* a run is in progress, and the game obeys CODE_RESTART, CODE_QUIT and CODE_ENTRY */
    uint8_t entry_count;
    uint8_t labels[PAUSE_ENTRIES * PAUSE_LABEL_SIZE]; /* UTF-8 */
};

extern const struct chip channel_chip;

/* channel_latch stores this frame's codes. channel_end_frame removes them after a frame in which tasks ran, so no code
 * is lost in a hit-stop. */
void channel_latch(struct channel *c, const uint16_t pads[MAX_PLAYERS]);
void channel_end_frame(struct channel *c);

/* Starts listening, with no entries; and stops. */
void channel_open(struct channel *c);
void channel_close(struct channel *c);

/* Adds an entry to the pause menu. A label that is too long is cut after a whole character. Does nothing if there are
 * PAUSE_ENTRIES already. */
void channel_add_entry(struct channel *c, const char *label);

#endif

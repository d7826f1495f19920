/*
 * channel.c - see channel.h.
 */
#include "channel.h"

#include <string.h>

static const struct column columns[] = {
    REGISTERS(channel, code),
    REGISTER(channel, is_listening),
    REGISTER(channel, entry_count),
    REGISTERS(channel, labels),
};

const struct chip channel_chip = { .name = "channel", CHIP_COLUMNS(columns), .is_list = true };

void channel_latch(struct channel *c, const uint16_t pads[MAX_PLAYERS])
{
    for (int p = 0; p < MAX_PLAYERS; p++)
        if (pad_code(pads[p]) && pad_is_valid(pads[p]))
            c->code[p] = (uint8_t)pad_code(pads[p]);
}

void channel_end_frame(struct channel *c)
{
    memset(c->code, 0, sizeof c->code);
}

void channel_open(struct channel *c)
{
    channel_close(c);
    c->is_listening = 1;
}

void channel_close(struct channel *c)
{
    c->is_listening = c->entry_count = 0;
    memset(c->labels, 0, sizeof c->labels);
}

void channel_add_entry(struct channel *c, const char *label)
{
    size_t n = strlen(label);

    if (c->entry_count == PAUSE_ENTRIES)
        return;
    if (n >= PAUSE_LABEL_SIZE)
        for (n = PAUSE_LABEL_SIZE - 1; n > 0 && ((uint8_t)label[n] & 0xc0) == 0x80;) /* inside a character */
            n--;
    memcpy(c->labels + c->entry_count++ * PAUSE_LABEL_SIZE, label, n);
}

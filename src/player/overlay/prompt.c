/*
 * prompt.c - the prompt for a frame number (prompt.h).
 */
#include "prompt.h"

#include <stdlib.h>
#include <string.h>
#include "../input/input_code.h"

void prompt_open(struct prompt *p, const struct plat_input *in)
{
    *p = (struct prompt){ .open = true };
    memcpy(p->held, in->keys, sizeof p->held);
}

static bool pressed(const struct prompt *p, const struct plat_input *in, unsigned usage)
{
    return plat_is_key_held(in, usage) && !(p->held[usage >> 3] >> (usage & 7) & 1);
}

/* In both rows of keys, 0 follows 9. */
static void digits(struct prompt *p, const struct plat_input *in)
{
    for (unsigned i = 0; i < 10; i++) {
        size_t n = strlen(p->digits);
        if (n + 1 < sizeof p->digits && (pressed(p, in, KEY_DIGIT_1 + i) || pressed(p, in, KEY_KEYPAD_1 + i)))
            p->digits[n] = (char)('0' + (i + 1) % 10);
    }
}

bool prompt_poll(struct prompt *p, const struct plat_input *in, uint32_t *frame)
{
    size_t n = strlen(p->digits);
    bool enter = pressed(p, in, KEY_ENTER) || pressed(p, in, KEY_KEYPAD_ENTER);

    digits(p, in);
    if (n > 0 && pressed(p, in, KEY_BACKSPACE))
        p->digits[n - 1] = 0;
    if (enter || pressed(p, in, KEY_ESCAPE))
        p->open = false;
    memcpy(p->held, in->keys, sizeof p->held);
    *frame = (uint32_t)strtoul(p->digits, NULL, 10);
    return enter && p->digits[0];
}

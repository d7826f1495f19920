/*
 * prompt.c - see prompt.h. Usages of the USB HID keyboard page.
 */
#include "prompt.h"

#include <stdlib.h>
#include <string.h>

enum { ENTER = 40, ESCAPE = 41, BACKSPACE = 42, KP_ENTER = 88, DIGIT_1 = 30, KP_1 = 89 };

void prompt_open(struct prompt *p, const struct plat_input *in)
{
    *p = (struct prompt){ .open = true };
    memcpy(p->held, in->keys, sizeof p->held);
}

static bool pressed(const struct prompt *p, const struct plat_input *in, unsigned usage)
{
    return plat_is_key_held(in, usage) && !(p->held[usage >> 3] >> (usage & 7) & 1);
}

/* 1 to 9 lie before 0, in both rows. */
static void digits(struct prompt *p, const struct plat_input *in)
{
    for (unsigned i = 0; i < 10; i++) {
        size_t n = strlen(p->digits);
        if (n + 1 < sizeof p->digits && (pressed(p, in, DIGIT_1 + i) || pressed(p, in, KP_1 + i)))
            p->digits[n] = (char)('0' + (i + 1) % 10);
    }
}

bool prompt_poll(struct prompt *p, const struct plat_input *in, uint32_t *frame)
{
    size_t n = strlen(p->digits);
    bool enter = pressed(p, in, ENTER) || pressed(p, in, KP_ENTER);

    digits(p, in);
    if (n > 0 && pressed(p, in, BACKSPACE))
        p->digits[n - 1] = 0;
    if (enter || pressed(p, in, ESCAPE))
        p->open = false;
    memcpy(p->held, in->keys, sizeof p->held);
    *frame = (uint32_t)strtoul(p->digits, NULL, 10);
    return enter && p->digits[0];
}

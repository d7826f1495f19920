/*
 * ask.c - see ask.h. Usages of the USB HID keyboard page.
 */
#include "ask.h"

#include <stdlib.h>
#include <string.h>

enum { ENTER = 40, ESCAPE = 41, BACKSPACE = 42, KP_ENTER = 88, DIGIT_1 = 30, KP_1 = 89 };

void ask_open(struct ask *a, const struct plat_input *in)
{
    *a = (struct ask){ .open = true };
    memcpy(a->held, in->keys, sizeof a->held);
}

static bool pressed(const struct ask *a, const struct plat_input *in, unsigned usage)
{
    return plat_key(in, usage) && !(a->held[usage >> 3] >> (usage & 7) & 1);
}

/* 1 to 9 lie before 0, in both rows. */
static void digits(struct ask *a, const struct plat_input *in)
{
    for (unsigned i = 0; i < 10; i++) {
        size_t n = strlen(a->digits);
        if (n + 1 < sizeof a->digits && (pressed(a, in, DIGIT_1 + i) || pressed(a, in, KP_1 + i)))
            a->digits[n] = (char)('0' + (i + 1) % 10);
    }
}

bool ask_poll(struct ask *a, const struct plat_input *in, uint32_t *frame)
{
    size_t n = strlen(a->digits);
    bool enter = pressed(a, in, ENTER) || pressed(a, in, KP_ENTER);

    digits(a, in);
    if (n > 0 && pressed(a, in, BACKSPACE))
        a->digits[n - 1] = 0;
    if (enter || pressed(a, in, ESCAPE))
        a->open = false;
    memcpy(a->held, in->keys, sizeof a->held);
    *frame = (uint32_t)strtoul(a->digits, NULL, 10);
    return enter && a->digits[0];
}

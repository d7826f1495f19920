/*
 * clean.c - see clean.h.
 */
#include "clean.h"

#include <stdbool.h>
#include <string.h>

/* Bytes of the UTF-8 character at s, RFC 3629; 0: none is there. */
static int character(const unsigned char *s)
{
    int n = s[0] < 0x80 ? 1 : s[0] >= 0xc2 && s[0] < 0xe0 ? 2 : s[0] >= 0xe0 && s[0] < 0xf0 ? 3 : s[0] >= 0xf0 ? 4 : 0;

    for (int i = 1; i < n; i++)
        if ((s[i] & 0xc0) != 0x80)
            return 0;
    if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] > 0x9f) || (s[0] == 0xf0 && s[1] < 0x90) ||
        (s[0] == 0xf4 && s[1] > 0x8f) || s[0] > 0xf4)
        return 0;
    return n;
}

int clean_character(const char *s, uint32_t *c)
{
    const unsigned char *p = (const unsigned char *)s;
    int n = character(p);

    *c = n == 0 ? 0xfffd : n == 1 ? p[0] : p[0] & (0x7fu >> n);
    for (int i = 1; i < n; i++)
        *c = *c << 6 | (p[i] & 0x3f);
    return n ? n : 1;
}

static void clean(char *text, bool newlines)
{
    for (unsigned char *s = (unsigned char *)text; *s;) {
        int n = character(s);
        if (n == 0)
            *s = '?';
        else if (n == 1 && (*s < 32 || *s == 127) && *s != '\t' && !(newlines && *s == '\n'))
            *s = ' ';
        else if (n == 2 && s[0] == 0xc2 && s[1] < 0xa0)
            memset(s, ' ', 2);
        s += n ? n : 1;
    }
}

void clean_line(char *s)
{
    clean(s, false);
}

void clean_lines(char *s)
{
    clean(s, true);
}

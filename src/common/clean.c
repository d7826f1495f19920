/*
 * clean.c - makes untrusted text safe to display (clean.h).
 */
#include "clean.h"

#include <string.h>
#include "../../fb/utf8.h"

int clean_decode_character(const char *s, uint32_t *c)
{
    const char *p = s;

    if (!utf8_read(&p, s + strlen(s), c))
        *c = 0xfffd;
    return (int)(p - s);
}

void clean_line(char *s)
{
    utf8_replace_hidden(s, false);
}

void clean_lines(char *s)
{
    utf8_replace_hidden(s, true);
}

int clean_escape_character(const char *s, char out[CLEAN_MARKUP_SIZE])
{
    uint32_t c;
    const int n = clean_decode_character(s, &c);

    memcpy(out, s, (size_t)n);
    out[n] = '\0';
    if (c == 0xfffd || !utf8_may_show(c))
        strcpy(out, c == 0xfffd ? "?" : " ");
    else if (c == '<' || c == '>')
        strcpy(out, c == '<' ? "&lt;" : "&gt;");
    else if (c == '&' || c == '"')
        strcpy(out, c == '&' ? "&amp;" : "&quot;");
    return n;
}

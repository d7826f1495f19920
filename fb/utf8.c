/*
 * utf8.c - see utf8.h. What counts as UTF-8 is Unicode's own table: the shortest form alone, no surrogates, nothing
 * over UTF8_MAX.
 */
#include "utf8.h"

/* The bytes of the sequence that begins with b, and what of it is the first's share; 0: none begins so. */
static int sequence(uint8_t b, uint32_t *code)
{
    if (b >= 0xc2 && b <= 0xdf)
        return *code = b & 0x1f, 2;
    if (b >= 0xe0 && b <= 0xef)
        return *code = b & 0x0f, 3;
    if (b >= 0xf0 && b <= 0xf4)
        return *code = b & 0x07, 4;
    return 0;
}

uint32_t utf8_next(const char **s, const char *end)
{
    static const uint32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
    const uint8_t *p = (const uint8_t *)*s;
    uint32_t code = 0;
    int n = sequence(*p, &code);

    (*s)++;
    if (n == 0 || end - *s < n - 1)
        return *p;
    for (int i = 1; i < n; i++) {
        if ((p[i] & 0xc0) != 0x80)
            return *p;
        code = code << 6 | (p[i] & 0x3f);
    }
    if (code < least[n] || code > UTF8_MAX || (code >= 0xd800 && code <= 0xdfff))
        return *p;
    *s += n - 1;
    return code;
}

size_t utf8_count(const char *s, size_t n, size_t most, size_t *bytes)
{
    const char *at = s, *end = s + n;
    size_t count = 0;

    for (; at < end && count < most; count++)
        utf8_next(&at, end);
    if (bytes)
        *bytes = (size_t)(at - s);
    return count;
}

size_t utf8_put(char out[UTF8_BYTES], uint32_t code)
{
    static const uint8_t heads[] = { 0, 0, 0xc0, 0xe0, 0xf0 };
    size_t n = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;

    if (n == 1) {
        out[0] = (char)code;
        return 1;
    }
    for (size_t i = n - 1; i > 0; i--, code >>= 6)
        out[i] = (char)(0x80 | (code & 0x3f));
    out[0] = (char)(heads[n] | code);
    return n;
}

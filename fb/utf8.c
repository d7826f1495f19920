/*
 * utf8.c - see utf8.h. Valid UTF-8 is as in Unicode's table: only the shortest form, no surrogates, nothing over
 * UTF8_MAX_CODE.
 */
#include "utf8.h"

#include <string.h>

/* Returns the length of the multi-byte sequence that starts with b, and stores the bits that b contributes to the code.
 * Returns 0 if no sequence starts with b. */
static int decode_lead_byte(uint8_t b, uint32_t *code)
{
    if (b >= 0xc2 && b <= 0xdf)
        return *code = b & 0x1f, 2;
    if (b >= 0xe0 && b <= 0xef)
        return *code = b & 0x0f, 3;
    if (b >= 0xf0 && b <= 0xf4)
        return *code = b & 0x07, 4;
    return 0;
}

bool utf8_read(const char **s, const char *end, uint32_t *code)
{
    static const uint32_t min_code[] = { 0, 0, 0x80, 0x800, 0x10000 };
    const uint8_t *p = (const uint8_t *)*s;
    uint32_t value = 0;
    int n = decode_lead_byte(*p, &value);

    (*s)++;
    *code = *p;
    if (n == 0 || end - *s < n - 1)
        return *p < 0x80;
    for (int i = 1; i < n; i++) {
        if ((p[i] & 0xc0) != 0x80)
            return false;
        value = value << 6 | (p[i] & 0x3f);
    }
    if (value < min_code[n] || value > UTF8_MAX_CODE || (value >= 0xd800 && value <= 0xdfff))
        return false;
    *s += n - 1;
    *code = value;
    return true;
}

uint32_t utf8_next(const char **s, const char *end)
{
    uint32_t code;

    utf8_read(s, end, &code);
    return code;
}

bool utf8_may_show(uint32_t code)
{
    static const struct {
        uint32_t first, last;
    } hidden[] = {
        { 0, 0x1f },          { 0x7f, 0x9f },     { 0x61c, 0x61c },                       /* Arabic letter mark */
        { 0x200e, 0x200f },   { 0x2028, 0x202e }, { 0x2060, 0x206f }, { 0xd800, 0xdfff }, /* marks, separators */
        { 0xfdd0, 0xfdef },   { 0xfeff, 0xfeff }, { 0xfff9, 0xfffb },                     /* noncharacters, a BOM */
        { 0xe0000, 0xe007f },
    };

    for (size_t i = 0; i < sizeof hidden / sizeof *hidden; i++)
        if (code >= hidden[i].first && code <= hidden[i].last)
            return false;
    return code <= UTF8_MAX_CODE && (code & 0xfffe) != 0xfffe;
}

bool utf8_is_full_width(uint32_t code)
{
    static const struct {
        uint32_t first, last;
    } wide[] = {
        { 0x2e80, 0x303e },   { 0x3041, 0xa4cf },   { 0xa960, 0xa97c },   { 0xac00, 0xd7a3 }, { 0xf900, 0xfaff },
        { 0xfe10, 0xfe19 },   { 0xfe30, 0xfe6b },   { 0xff01, 0xff60 },   { 0xffe0, 0xffe6 }, { 0x16fe0, 0x1b2ff },
        { 0x1f200, 0x1f64f }, { 0x1f900, 0x1f9ff }, { 0x20000, 0x3fffd },
    };

    for (size_t i = 0; i < sizeof wide / sizeof *wide; i++)
        if (code >= wide[i].first && code <= wide[i].last)
            return true;
    return false;
}

void utf8_replace_hidden(char *text, bool allow_newlines)
{
    const char *s = text, *end = text + strlen(text);

    while (s < end) {
        char *at = text + (s - text);
        uint32_t code;
        if (!utf8_read(&s, end, &code))
            *at = '?';
        else if (!utf8_may_show(code) && code != '\t' && !(allow_newlines && code == '\n'))
            memset(at, ' ', (size_t)(s - at));
    }
}

size_t utf8_count(const char *s, size_t n, size_t max_count, size_t *bytes)
{
    const char *at = s, *end = s + n;
    size_t count = 0;

    for (; at < end && count < max_count; count++)
        utf8_next(&at, end);
    if (bytes)
        *bytes = (size_t)(at - s);
    return count;
}

size_t utf8_put(char out[UTF8_MAX_BYTES], uint32_t code)
{
    static const uint8_t lead_bytes[] = { 0, 0, 0xc0, 0xe0, 0xf0 };
    size_t n = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;

    if (n == 1) {
        out[0] = (char)code;
        return 1;
    }
    for (size_t i = n - 1; i > 0; i--, code >>= 6)
        out[i] = (char)(0x80 | (code & 0x3f));
    out[0] = (char)(lead_bytes[n] | code);
    return n;
}

/*
 * line_break.c - see line_break.h.
 */
#include "line_break.h"

#include <stdbool.h>
#include <string.h>
#include "text.h"
#include "utf8.h"

enum {
    UNSPACED = 0x2E80, /* the first code point of the scripts without spaces */
    FEWEST = 3,        /* letters of a last line */
};

/* The particles, and the hiragana before which they belong to a word instead, such as 上がる, できる, 落とす and 増やす. */
static const struct {
    uint32_t particle;
    const char *word;
} particles[] = {
    { 0x306F /* は */, "" },         { 0x304C /* が */, "らりるれろっ" },
    { 0x3092 /* を */, "" },         { 0x306B /* に */, "" },
    { 0x3067 /* で */, "きすしょ" }, { 0x3068 /* と */, "さしすせそ" },
    { 0x3082 /* も */, "" },         { 0x306E /* の */, "" },
    { 0x3078 /* へ */, "" },         { 0x3084 /* や */, "かさしすせ" },
};

static bool is_in(const char *set, uint32_t code)
{
    for (const char *end = set + strlen(set); set < end;)
        if (utf8_next(&set, end) == code)
            return true;
    return false;
}

static bool is_hiragana(uint32_t code)
{
    return code >= 0x3041 && code <= 0x309F;
}

static bool is_kana(uint32_t code)
{
    return code >= 0x3041 && code <= 0x30FF;
}

static bool ends_phrase(uint32_t before, uint32_t last, uint32_t next)
{
    if (!is_hiragana(next))
        return is_hiragana(last) && !is_in("おご", last);                  /* お金 */
    if (before < UNSPACED || is_hiragana(before) || is_in("はもの", next)) /* には */
        return false;
    for (size_t i = 0; i < sizeof particles / sizeof *particles; i++)
        if (particles[i].particle == last)
            return !is_in(particles[i].word, next);
    return false;
}

/* Moves *at before the character there ends. Returns the character, or 0 at the start. */
static uint32_t previous(const char *text, size_t *at)
{
    const size_t end = *at;

    if (end == 0)
        return 0;
    do
        --*at;
    while (*at > 0 && ((unsigned char)text[*at] & 0xc0) == 0x80);
    const char *s = text + *at;
    return utf8_next(&s, text + end);
}

enum line_break line_break_before(const char *text, size_t n, size_t at)
{
    const char *s = text + at;
    size_t start = at;

    if (((unsigned char)*s & 0xc0) == 0x80)
        return LINE_BREAK_NONE;
    const uint32_t next = utf8_next(&s, text + n), last = previous(text, &start), before = previous(text, &start);
    if (next == ' ' || last == ' ' || last == '/')
        return LINE_BREAK_WORD;
    if ((last < UNSPACED && next < UNSPACED) || text_is_closing_punctuation(next) || text_is_opening_punctuation(last))
        return LINE_BREAK_NONE;
    if (text_is_closing_punctuation(last) && !is_kana(last) && last != 0x3005 /* 々 */)
        return LINE_BREAK_WORD;
    return text_is_opening_punctuation(next) || ends_phrase(before, last, next) ? LINE_BREAK_WORD : LINE_BREAK_IN_WORD;
}

size_t line_break_find(const char *text, size_t n, int width, line_advance *advance, const void *font, size_t *fitting)
{
    const char *end = text + n;
    const int room = width > 0 ? width : 1;
    int whole = 0, letters = 0, w = 0;
    size_t last = 0, word = 0, enough = 0;

    for (const char *s = text; s < end; letters++)
        whole += advance(font, utf8_next(&s, end));
    *fitting = n;
    if (whole <= width)
        return n;
    const int least = whole - room * ((whole - 1) / room); /* a shorter line costs a line */
    for (const char *s = text; s < end;) {
        const size_t at = (size_t)(s - text);
        const enum line_break k = at ? line_break_before(text, n, at) : LINE_BREAK_NONE;
        if (k != LINE_BREAK_NONE)
            last = at;
        if (k != LINE_BREAK_NONE && letters >= FEWEST)
            enough = at;
        if (k == LINE_BREAK_WORD && letters >= FEWEST && w >= least && 2 * w >= width)
            word = at;
        w += advance(font, utf8_next(&s, end));
        letters--;
        if (w > width && at)
            break;
        *fitting = (size_t)(s - text);
    }
    return word ? word : enough ? enough : last;
}

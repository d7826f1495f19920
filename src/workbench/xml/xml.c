/*
 * xml.c - see xml.h. Names and values are slices of the copied text: the character after each is replaced by a NUL, and
 * a decoded value is never longer than its source.
 */
#include "xml.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../base/err.h"
#include "../../base/cursor.h"
#include "../../common/result.h"

bool xml_refuse(struct xml *x, struct xml_place place, const char *format, ...)
{
    va_list args;
    int n = x->columns ? snprintf(x->err, x->err_size, "%s:%d:%d: ", x->file, place.line, place.column)
                       : snprintf(x->err, x->err_size, "%s:%d: ", x->file, place.line);

    va_start(args, format);
    if (n > 0 && (size_t)n < x->err_size)
        vsnprintf(x->err + n, x->err_size - (size_t)n, format, args);
    va_end(args);
    return false;
}

static bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

static bool is_character(uint32_t code)
{
    return (code >= ' ' && code < 0xd800) || (code >= 0xe000 && code <= UTF8_MAX_CODE) ||
           (code < 0x80 && is_space((char)code));
}

/* Returns the number of bytes up to whitespace or the end of a tag, at most `most`, for messages of one line. */
static int word_length(const char *s, int most)
{
    const size_t n = strcspn(s, " \t\r\n>/");

    return n < (size_t)most ? (int)n : most;
}

struct xml_place xml_next_place(struct xml_place place, char c)
{
    return c == '\n' ? (struct xml_place){ place.line + 1, 1 }
                     : (struct xml_place){ place.line, place.column + ((c & 0xc0) != 0x80) };
}

static bool starts_with(const struct xml *x, const char *head)
{
    const size_t n = strlen(head);

    return (size_t)(x->end - x->at) >= n && memcmp(x->at, head, n) == 0;
}

static void advance(struct xml *x)
{
    x->place = xml_next_place(x->place, *x->at++);
}

static void skip_space(struct xml *x)
{
    while (x->at < x->end && is_space(*x->at))
        advance(x);
}

/* Moves past `tail`. */
static bool skip_past(struct xml *x, const char *tail, const char *what)
{
    const struct xml_place place = x->place;

    while (x->at < x->end && !starts_with(x, tail))
        advance(x);
    if (x->at == x->end)
        return xml_refuse(x, place, "%s without an end, expected %s", what, tail);
    for (size_t n = strlen(tail); n > 0; n--)
        advance(x);
    return true;
}

/* ---- encodings ---- */

/* All encodings except UTF-8 are read as ISO-8859-1. Shift_JIS and EUC-JP are common in comments of old documents; none
 * of their bytes is a markup character. */
enum encoding { UTF_8, LATIN_1, APPROXIMATE };

static bool equal_ignoring_case(const char *a, const char *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if ((a[i] | 0x20) != (b[i] | 0x20))
            return false;
    return b[n] == '\0';
}

/* Reads the encoding from <?xml version="1.0" encoding="UTF-8"?>. */
static bool find_encoding(struct xml *x, enum encoding *encoding)
{
    static const struct {
        const char *name;
        enum encoding encoding;
    } known[] = { { "UTF-8", UTF_8 },
                  { "US-ASCII", UTF_8 },
                  { "ASCII", UTF_8 },
                  { "ISO-8859-1", LATIN_1 },
                  { "Shift_JIS", APPROXIMATE },
                  { "x-sjis", APPROXIMATE },
                  { "Windows-31J", APPROXIMATE },
                  { "cp932", APPROXIMATE },
                  { "EUC-JP", APPROXIMATE } };
    const char *end = strstr(x->at, "?>"), *name = strstr(x->at, "encoding");

    *encoding = UTF_8;
    if (!starts_with(x, "<?xml") || end == NULL || name == NULL || name > end)
        return true;
    name += strcspn(name, "\"'");
    name += *name != '\0';
    const size_t n = strcspn(name, "\"'");
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (n <= strlen(known[i].name) && equal_ignoring_case(name, known[i].name, n)) {
            *encoding = known[i].encoding;
            return true;
        }
    return xml_refuse(x, x->place, "encoding \"%.*s\" is not supported; save the file as UTF-8", (int)(n < 40 ? n : 40),
                      name);
}

static bool check_text(struct xml *x)
{
    struct xml_place place = x->place;

    for (const char *s = x->at; s < x->end;) {
        const char *from = s;
        const uint32_t code = utf8_next(&s, x->end);
        if ((code >= 0x80 && s == from + 1) || !is_character(code))
            return xml_refuse(x, place, "byte 0x%02x is not valid UTF-8; save the file as UTF-8", *from & 0xff);
        place = xml_next_place(place, *from);
    }
    return true;
}

bool xml_open(struct xml *x, const char *bytes, size_t n, const char *file, bool columns, char *err, size_t err_size)
{
    enum encoding encoding;

    *x = (struct xml){
        .file = file, .place = { 1, 1 }, .start = { 1, 1 }, .columns = columns, .err = err, .err_size = err_size
    };
    if (n >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0)
        bytes += 3, n -= 3;
    x->text = malloc(2 * n + 1);
    if (x->text == NULL)
        return result_set_host_error(err, err_size, "out of memory");
    x->at = x->text + n; /* converted from ISO-8859-1, the text is at most twice as long */
    x->end = x->at + n;
    memcpy(x->at, bytes, n);
    *x->end = '\0';
    if (!find_encoding(x, &encoding))
        return false;
    x->approximate = encoding == APPROXIMATE;
    if (encoding != UTF_8) {
        char *to = x->text;
        for (; x->at < x->end; x->at++)
            to += utf8_put(to, (uint8_t)*x->at);
        *to = '\0';
        x->at = x->text;
        x->end = to;
    }
    return check_text(x);
}

void xml_close(struct xml *x)
{
    free(x->text);
}

/* ---- values ---- */

/* Returns the code point of the reference between & and ;, or 0. */
static uint32_t decode_reference(const char *s, size_t n)
{
    static const struct {
        const char *name;
        char code;
    } named[] = { { "lt", '<' }, { "gt", '>' }, { "amp", '&' }, { "quot", '"' }, { "apos", '\'' } };
    const bool hex = n > 1 && s[1] == 'x';
    uint32_t code = 0;

    for (size_t i = 0; i < sizeof named / sizeof *named; i++)
        if (n == strlen(named[i].name) && memcmp(s, named[i].name, n) == 0)
            return (uint32_t)named[i].code;
    if (n < 2 || s[0] != '#' || n == 1 + (size_t)hex)
        return 0;
    for (size_t i = 1 + (size_t)hex; i < n; i++) {
        const int digit = cursor_hex_value(s[i]);
        if (digit < 0 || (!hex && digit > 9) || code > UTF8_MAX_CODE)
            return 0;
        code = code * (hex ? 16 : 10) + (uint32_t)digit;
    }
    return is_character(code) ? code : 0;
}

/* Decodes a value in place. */
static bool decode_value(struct xml *x, struct xml_place place, char *value)
{
    char *to = value;

    for (const char *from = value; *from != '\0';) {
        const size_t n = *from == '&' ? strcspn(from, ";") : 0;
        const uint32_t code = n > 0 && from[n] == ';' ? decode_reference(from + 1, n - 1) : 0;
        if (*from == '&' && code == 0)
            return xml_refuse(x, place, "\"%.*s\" is not a character reference; write a literal & as &amp;",
                              word_length(from, 20), from);
        if (code == 0) {
            *to++ = is_space(*from) ? ' ' : *from;
            from++;
        } else {
            to += utf8_put(to, code);
            from += n + 1;
        }
    }
    *to = '\0';
    return true;
}

const char *xml_value(const struct xml *x, const char *key)
{
    for (int i = 0; i < x->n; i++)
        if (strcmp(x->attribute[i].key, key) == 0)
            return x->attribute[i].value;
    return NULL;
}

/* ---- tags ---- */

/* Reads a name, or returns NULL. The name ends at x->at; the caller terminates it after it has read this character. */
static char *read_name(struct xml *x)
{
    char *from = x->at;

    while (x->at < x->end && !is_space(*x->at) && strchr("=></\"'", *x->at) == NULL)
        advance(x);
    return x->at > from ? from : NULL;
}

/* Reads key="value" or key='value'. */
static bool read_attribute(struct xml *x)
{
    const struct xml_place place = x->place;
    char *key = read_name(x), *key_end = x->at;

    skip_space(x);
    if (key == NULL || x->at == x->end || *x->at != '=')
        return xml_refuse(x, place, "<%.40s>: expected an attribute, name=\"value\"", x->name);
    advance(x);
    skip_space(x);
    if (x->at == x->end || (*x->at != '"' && *x->at != '\''))
        return xml_refuse(x, place, "<%.40s>: expected a value in quotes", x->name);
    const char quote[2] = { *x->at, 0 };
    advance(x);
    char *value = x->at;
    if (!skip_past(x, quote, "a value"))
        return false;
    *key_end = x->at[-1] = '\0';
    if (strchr(value, '<') != NULL)
        return xml_refuse(x, place, "<%.40s> %.40s: value contains \"<\"; is its closing quote missing?", x->name, key);
    if (xml_value(x, key) != NULL)
        return xml_refuse(x, place, "<%.40s> has %.40s twice", x->name, key);
    if (x->n == XML_MAX_ATTRIBUTES)
        return xml_refuse(x, place, "<%.40s> has more than %d attributes", x->name, (int)XML_MAX_ATTRIBUTES);
    x->attribute[x->n++] = (struct xml_attribute){ key, value };
    return decode_value(x, place, value);
}

/* Reads the rest of </name>. */
static enum xml_event close_tag(struct xml *x, char *name)
{
    char *name_end = x->at;

    skip_space(x);
    if (name == NULL || x->at == x->end || *x->at != '>')
        return xml_refuse(x, x->start, "a tag without a closing >"), XML_BAD;
    advance(x);
    *name_end = '\0';
    if (x->depth == 0 || strcmp(x->open[x->depth - 1], name) != 0)
        return xml_refuse(x, x->start, "</%.40s> has no opening tag, expected %s%.40s%s", name,
                          x->depth > 0 ? "</" : "an element", x->depth > 0 ? x->open[x->depth - 1] : "",
                          x->depth > 0 ? ">" : ""),
               XML_BAD;
    x->name = x->open[--x->depth];
    return XML_CLOSE;
}

/* Reads the attributes up to >. The element's name ends at name_end. */
static bool read_attributes(struct xml *x, char *name_end)
{
    for (;;) {
        const char *from = x->at;
        skip_space(x);
        x->empty = x->at < x->end && *x->at == '/';
        if (x->empty)
            advance(x);
        if (x->at < x->end && *x->at == '>') {
            advance(x);
            *name_end = x->at[-1] = '\0';
            return true;
        }
        if (x->empty || x->at == x->end || from == x->at)
            return xml_refuse(x, x->start, "a tag without a closing >");
        *name_end = '\0';
        if (!read_attribute(x))
            return false;
    }
}

static enum xml_event read_tag(struct xml *x)
{
    const bool closes = starts_with(x, "</");

    x->start = x->place;
    advance(x);
    if (closes)
        advance(x);
    char *name = read_name(x);
    if (closes)
        return close_tag(x, name);
    if (name == NULL)
        return xml_refuse(x, x->place, "expected a name after <"), XML_BAD;
    if (x->depth == 0 && x->started)
        return xml_refuse(x, x->start, "more than one root element"), XML_BAD;
    if (x->depth == XML_MAX_DEPTH)
        return xml_refuse(x, x->start, "<%.*s>: elements nested deeper than %d", word_length(name, 40), name,
                          XML_MAX_DEPTH),
               XML_BAD;
    x->name = name;
    x->n = 0;
    if (!read_attributes(x, x->at))
        return XML_BAD;
    x->open[x->depth++] = name;
    x->started = true;
    return XML_OPEN;
}

/* Skips a document type, which names a grammar that is never read. */
static bool skip_type(struct xml *x)
{
    const struct xml_place place = x->place;

    while (x->at < x->end && *x->at != '>' && *x->at != '[')
        if (*x->at == '"' || *x->at == '\'') {
            const char quote[2] = { *x->at, 0 };
            advance(x);
            if (!skip_past(x, quote, "a <!DOCTYPE"))
                return false;
        } else {
            advance(x);
        }
    if (x->at == x->end || *x->at == '[')
        return xml_refuse(x, place, "<!DOCTYPE> with declarations is not supported; delete the line");
    advance(x);
    return true;
}

bool xml_skip_markup(struct xml *x, bool *skipped)
{
    *skipped = !x->empty && (starts_with(x, "<!") || starts_with(x, "<?"));
    if (!*skipped)
        return true;
    if (starts_with(x, "<!--"))
        return skip_past(x, "-->", "a comment");
    if (starts_with(x, "<?"))
        return skip_past(x, "?>", "a <?");
    if (starts_with(x, "<!DOCTYPE") && !x->started)
        return skip_type(x);
    return xml_refuse(x, x->place, "\"%.*s\" is not supported here", word_length(x->at, 9), x->at);
}

static enum xml_event next_event(struct xml *x, bool skipping)
{
    bool skipped = true;

    if (x->empty) {
        x->empty = false;
        x->name = x->open[--x->depth];
        return XML_CLOSE;
    }
    while (skipped) {
        while (x->at < x->end && *x->at != '<' && (skipping || is_space(*x->at)))
            advance(x);
        if (x->at == x->end && x->depth == 0)
            return XML_END;
        if (x->at == x->end)
            return xml_refuse(x, x->place, "the file ends inside <%.40s>", x->open[x->depth - 1]), XML_BAD;
        if (*x->at != '<')
            return xml_refuse(x, x->place, "expected <, got text"), XML_BAD;
        if (!xml_skip_markup(x, &skipped))
            return XML_BAD;
    }
    return read_tag(x);
}

enum xml_event xml_next(struct xml *x)
{
    return next_event(x, false);
}

bool xml_skip(struct xml *x)
{
    const int depth = x->depth;
    enum xml_event event;

    do
        event = next_event(x, true);
    while (event == XML_OPEN || (event == XML_CLOSE && x->depth >= depth));
    return event != XML_BAD;
}

size_t xml_text(struct xml *x, const char **text)
{
    *text = x->at;
    while (!x->empty && x->at < x->end && *x->at != '<')
        advance(x);
    return (size_t)(x->at - *text);
}

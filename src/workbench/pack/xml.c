/*
 * xml.c - see xml.h. Names and values are pieces of the text itself: each ends in a 0 that replaces the character
 * behind it, and a decoded value is never longer than what was written.
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

bool xml_refuse(struct xml *x, int line, const char *format, ...)
{
    va_list args;
    int n = snprintf(x->err, x->err_size, "%s:%d: ", x->file, line);

    va_start(args, format);
    if (n > 0 && (size_t)n < x->err_size)
        vsnprintf(x->err + n, x->err_size - (size_t)n, format, args);
    va_end(args);
    return false;
}

/* XML has no control characters but these. */
static bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

static bool is_character(uint32_t code)
{
    return (code >= ' ' && code < 0xd800) || (code >= 0xe000 && code <= UTF8_MAX_CODE) || code == '\t' ||
           code == '\n' || code == '\r';
}

static bool check_text(struct xml *x)
{
    int line = 1;

    for (const char *s = x->at; s < x->end;) {
        const char *from = s;
        const uint32_t code = utf8_next(&s, x->end);
        if ((code >= 0x80 && s == from + 1) || !is_character(code))
            return xml_refuse(x, line, "byte 0x%02x is not valid UTF-8; save the file as UTF-8", *from & 0xff);
        line += code == '\n';
    }
    return true;
}

static bool starts(const struct xml *x, const char *head)
{
    const size_t n = strlen(head);

    return (size_t)(x->end - x->at) >= n && memcmp(x->at, head, n) == 0;
}

static void step(struct xml *x)
{
    x->line += *x->at++ == '\n';
}

static void skip_space(struct xml *x)
{
    while (x->at < x->end && is_space(*x->at))
        step(x);
}

/* Moves behind `tail`. */
static bool pass(struct xml *x, const char *tail, const char *what)
{
    const int line = x->line;

    while (x->at < x->end && !starts(x, tail))
        step(x);
    if (x->at == x->end)
        return xml_refuse(x, line, "%s without an end, expected %s", what, tail);
    x->at += strlen(tail);
    return true;
}

/* <?xml version="1.0" encoding="UTF-8"?> */
static bool check_encoding(struct xml *x)
{
    static const char *const known[] = { "UTF-8", "utf-8", "US-ASCII", "us-ascii", "ASCII" };
    const char *end = strstr(x->at, "?>"), *name = strstr(x->at, "encoding");

    if (!starts(x, "<?xml") || end == NULL || name == NULL || name > end)
        return true;
    name += strcspn(name, "\"'");
    const size_t n = *name ? strcspn(name + 1, "\"'") : 0;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (n == strlen(known[i]) && memcmp(name + 1, known[i], n) == 0)
            return true;
    return xml_refuse(x, 1, "encoding \"%.*s\" is not supported; save the file as UTF-8", (int)(n < 40 ? n : 40),
                      name + 1);
}

bool xml_start(struct xml *x, char *text, size_t n, const char *file, char *err, size_t err_size)
{
    *x = (struct xml){ .at = text, .end = text + n, .file = file, .line = 1, .err = err, .err_size = err_size };
    return check_text(x) && check_encoding(x);
}

/* ---- values ---- */

/* The code of what is between & and ;, or 0. */
static uint32_t reference(const char *s, size_t n)
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

/* Decodes a value in place, and ends it with a 0. */
static bool decode(struct xml *x, int line, char *value)
{
    char *to = value;

    for (const char *from = value; *from != '\0';) {
        const size_t n = *from == '&' ? strcspn(from, ";") : 0;
        const uint32_t code = n > 0 && from[n] == ';' ? reference(from + 1, n - 1) : 0;
        if (*from == '&' && code == 0)
            return xml_refuse(x, line, "\"%.20s\" is not a character reference; write a literal & as &amp;", from);
        if (code == 0) {
            *to++ = *from++;
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

/* A name; its end is where x->at is now, and gets its 0 once that character has been read. */
static char *read_name(struct xml *x)
{
    char *from = x->at;

    while (x->at < x->end && !is_space(*x->at) && strchr("=></\"'", *x->at) == NULL)
        x->at++;
    return x->at > from ? from : NULL;
}

/* key="value" or key='value'. */
static bool read_attribute(struct xml *x)
{
    const int line = x->line;
    char *key = read_name(x), *key_end = x->at;

    skip_space(x);
    if (key == NULL || x->at == x->end || *x->at != '=')
        return xml_refuse(x, line, "<%.40s>: expected an attribute, name=\"value\"", x->name);
    x->at++;
    skip_space(x);
    if (x->at == x->end || (*x->at != '"' && *x->at != '\''))
        return xml_refuse(x, line, "<%.40s>: expected a value in quotes", x->name);
    const char quote[2] = { *x->at++, 0 };
    char *value = x->at;
    if (!pass(x, quote, "a value"))
        return false;
    *key_end = x->at[-1] = '\0';
    if (strchr(value, '<') != NULL)
        return xml_refuse(x, line, "<%.40s> %.40s: value contains \"<\"; is its closing quote missing?", x->name, key);
    if (xml_value(x, key) != NULL)
        return xml_refuse(x, line, "<%.40s> has %.40s twice", x->name, key);
    if (x->n == XML_ATTRIBUTES)
        return xml_refuse(x, line, "<%.40s> has more than %d attributes", x->name, (int)XML_ATTRIBUTES);
    x->attribute[x->n++] = (struct xml_attribute){ key, value };
    return decode(x, line, value);
}

/* </name> */
static enum xml_event close_tag(struct xml *x, char *name)
{
    char *name_end = x->at;

    skip_space(x);
    if (name == NULL || x->at == x->end || *x->at != '>')
        return xml_refuse(x, x->name_line, "a tag without a closing >"), XML_BAD;
    x->at++;
    *name_end = '\0';
    if (x->depth == 0 || strcmp(x->open[x->depth - 1], name) != 0)
        return xml_refuse(x, x->name_line, "</%.40s> has no opening tag, expected %s%.40s", name,
                          x->depth > 0 ? "</" : "", x->depth > 0 ? x->open[x->depth - 1] : "an element"),
               XML_BAD;
    x->name = x->open[--x->depth];
    return XML_CLOSE;
}

/* The attributes up to >; name_end is behind the name. */
static bool read_attributes(struct xml *x, char *name_end)
{
    for (;;) {
        const char *from = x->at;
        skip_space(x);
        x->empty = x->at < x->end && *x->at == '/';
        x->at += x->empty;
        if (x->at < x->end && *x->at == '>') {
            *x->at++ = '\0';
            *name_end = '\0';
            return true;
        }
        if (x->empty || x->at == x->end || from == x->at)
            return xml_refuse(x, x->name_line, "a tag without a closing >");
        *name_end = '\0';
        if (!read_attribute(x))
            return false;
    }
}

static enum xml_event read_tag(struct xml *x)
{
    const bool closes = starts(x, "</");

    x->name_line = x->line;
    x->at += 1 + closes;
    char *name = read_name(x);
    if (closes)
        return close_tag(x, name);
    if (name == NULL)
        return xml_refuse(x, x->line, "expected a name after <"), XML_BAD;
    if (x->depth == XML_NEST || (x->depth == 0 && x->started))
        return xml_refuse(x, x->line,
                          x->started && x->depth == 0 ? "more than one root element" : "elements nested too deeply"),
               XML_BAD;
    x->name = name;
    x->n = 0;
    if (!read_attributes(x, x->at))
        return XML_BAD;
    x->open[x->depth++] = name;
    x->started = true;
    return XML_OPEN;
}

/* A document type names a grammar, which nobody needs. */
static bool pass_type(struct xml *x)
{
    const int line = x->line;

    while (x->at < x->end && *x->at != '>' && *x->at != '[')
        if (*x->at == '"' || *x->at == '\'') {
            const char quote[2] = { *x->at++, 0 };
            if (!pass(x, quote, "a <!DOCTYPE"))
                return false;
        } else {
            step(x);
        }
    if (x->at == x->end || *x->at == '[')
        return xml_refuse(x, line, "<!DOCTYPE> with declarations is not supported; delete the line");
    x->at++;
    return true;
}

/* Skips what stands between elements: *passed, or false with a sentence. */
static bool pass_markup(struct xml *x, bool *passed)
{
    *passed = starts(x, "<!") || starts(x, "<?");
    if (!*passed)
        return true;
    if (starts(x, "<!--"))
        return pass(x, "-->", "a comment");
    if (starts(x, "<?"))
        return pass(x, "?>", "a <?");
    if (starts(x, "<!DOCTYPE") && !x->started)
        return pass_type(x);
    return xml_refuse(x, x->line, "\"%.9s\" is not supported here", x->at);
}

static enum xml_event next(struct xml *x, bool skipping)
{
    bool passed = true;

    if (x->empty) {
        x->empty = false;
        x->name = x->open[--x->depth];
        return XML_CLOSE;
    }
    while (passed) {
        while (x->at < x->end && *x->at != '<' && (skipping || is_space(*x->at)))
            step(x);
        if (x->at == x->end && x->depth == 0)
            return XML_END;
        if (x->at == x->end)
            return xml_refuse(x, x->line, "the file ends inside <%.40s>", x->open[x->depth - 1]), XML_BAD;
        if (*x->at != '<')
            return xml_refuse(x, x->line, "expected <, got text"), XML_BAD;
        if (!pass_markup(x, &passed))
            return XML_BAD;
    }
    return read_tag(x);
}

enum xml_event xml_next(struct xml *x)
{
    return next(x, false);
}

bool xml_skip(struct xml *x)
{
    const int depth = x->depth;
    enum xml_event event;

    do
        event = next(x, true);
    while (event == XML_OPEN || (event == XML_CLOSE && x->depth >= depth));
    return event != XML_BAD;
}

size_t xml_text(struct xml *x, const char **text)
{
    *text = x->at;
    while (!x->empty && x->at < x->end && *x->at != '<')
        step(x);
    return (size_t)(x->at - *text);
}

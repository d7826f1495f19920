/*
 * screen_words.c - the screens' text in the language of the game's player (screen.h). A screen fills in its rows in
 * English, and every text is looked up here when it is shown.
 */
#include "screen.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "../../base/cursor.h"

enum { MAX_NUMBERS = 8 };

struct output {
    char *text;
    size_t size, n;
};

/* Appends characters that fit. */
static void put(struct output *o, const char *s, size_t n)
{
    if (n > o->size - 1 - o->n)
        for (n = o->size - 1 - o->n; n > 0 && ((unsigned char)s[n] & 0xc0) == 0x80;)
            n--;
    memcpy(o->text + o->n, s, n);
    o->n += n;
    o->text[o->n] = '\0';
}

/* A text with numbers is looked up with %d in their places: "Player 2" as "Player %d". */
static bool put_with_numbers(struct output *o, const struct words *w, const char *s, size_t n)
{
    const char *number[MAX_NUMBERS];
    char key[SCREEN_TEXT];
    size_t digits[MAX_NUMBERS], at = 0;
    int numbers = 0, used = 0;

    for (size_t i = 0; i < n && at < sizeof key - 2; i++) {
        if (!cursor_is_digit(s[i])) {
            key[at++] = s[i];
            continue;
        }
        if (numbers == MAX_NUMBERS)
            return false;
        number[numbers] = s + i;
        while (i + 1 < n && cursor_is_digit(s[i + 1]))
            i++;
        digits[numbers] = (size_t)(s + i + 1 - number[numbers]);
        numbers++;
        key[at++] = '%';
        key[at++] = 'd';
    }
    const char *t = numbers > 0 ? words_find(w, key, at) : NULL;
    if (t == NULL)
        return false;
    for (const char *next; (next = strstr(t, "%d")) != NULL && used < numbers; t = next + 2, used++) {
        put(o, t, (size_t)(next - t));
        put(o, number[used], digits[used]);
    }
    put(o, t, strlen(t));
    return true;
}

/* Appends the translation of n bytes. Returns false if there is none. */
static bool put_translation(struct output *o, const struct words *w, const char *s, size_t n)
{
    const char *t = words_find(w, s, n);

    if (t == NULL)
        return put_with_numbers(o, w, s, n);
    put(o, t, strlen(t));
    return true;
}

void screen_translate(const struct words *w, const char *text, char *out, size_t size)
{
    struct output o = { out, size, 0 };

    out[0] = '\0';
    if (put_translation(&o, w, text, strlen(text)))
        return;
    while (*text) { /* line by line; spaces indent a line */
        const size_t indent = strspn(text, " "), n = strcspn(text + indent, "\n");
        put(&o, text, indent);
        text += indent;
        if (!put_translation(&o, w, text, n))
            put(&o, text, n);
        text += n;
        put(&o, text, *text == '\n');
        text += *text == '\n';
    }
}

/* Returns the next conversion of a format from *s on: 's', 'd' or '%'; '\0' at the end, and '?' for any other. */
static char next_conversion(const char **s)
{
    *s += strcspn(*s, "%");
    if (**s == '\0')
        return '\0';
    const char c = (*s)[1];
    *s += c ? 2 : 1;
    return c == 's' || c == 'd' || c == '%' ? c : '?';
}

/* Returns whether a translated format takes the arguments of the original. */
static bool takes_same_arguments(const char *format, const char *translated)
{
    char a, b;

    do {
        a = next_conversion(&format);
        b = next_conversion(&translated);
    } while (a == b && a != '\0' && a != '?');
    return a == b && a == '\0';
}

void screens_format_list(const struct screens *s, char *out, size_t size, const char *format, va_list args)
{
    const char *t = words_find(&s->words, format, strlen(format));

    vsnprintf(out, size, t != NULL && takes_same_arguments(format, t) ? t : format, args);
}

void screens_format(const struct screens *s, char *out, size_t size, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    screens_format_list(s, out, size, format, args);
    va_end(args);
}

struct screen_row screen_place_row(const struct screen_place *p, int at)
{
    struct screen_row row = { 0 }, shown;

    p->screen->row(p->context, at, &row);
    shown = row;
    screen_translate(p->words, row.label, shown.label, sizeof shown.label);
    if (!row.verbatim)
        screen_translate(p->words, row.value, shown.value, sizeof shown.value);
    screen_translate(p->words, row.help, shown.help, sizeof shown.help);
    return shown;
}

void screen_place_title(const struct screen_place *p, char *out, size_t size)
{
    screen_translate(p->words, p->screen->title, out, size);
}

void screen_place_text(const struct screen_place *p, char *out, size_t size)
{
    screen_translate(p->words, p->screen->text ? p->screen->text(p->context) : "", out, size);
}

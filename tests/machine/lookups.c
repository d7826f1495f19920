/*
 * lookups.c - linked with the option --wrap=words_find: writes each text that is looked up in a language file to the
 * file lookups: a line a text, after + if it has a translation, otherwise after -.
 */
#include <stdio.h>

struct words;

const char *__real_words_find(const struct words *w, const char *text, size_t n);
const char *__wrap_words_find(const struct words *w, const char *text, size_t n);

const char *__wrap_words_find(const struct words *w, const char *text, size_t n)
{
    static FILE *f;
    const char *found = __real_words_find(w, text, n);

    if (!f)
        f = fopen("lookups", "w");
    fputc(found ? '+' : '-', f);
    for (size_t i = 0; i < n; i++)
        fputc(text[i] == '\n' ? '\r' : text[i], f);
    fputc('\n', f);
    fflush(f);
    return found;
}

/*
 * fuzz_lang.c - libFuzzer: any bytes as a language file, and as a language's lump. What is read is found again in the
 * lump that is made of it; what is refused says file, line and why. In a lump that is taken each text is found.
 */
#include "../../src/rom/words.h"
#include "../../src/workbench/pack/lang.h"
#include "fuzz.h"

static void round_trip(const struct lang *l)
{
    char err[256];
    uint8_t *lump;
    size_t size = lang_make(l, &lump);
    struct words w;

    if (!size)
        return;
    need(words_open(&w, lump, size, err, sizeof err) && w.n == (uint32_t)l->n);
    for (int i = 0; i < l->n; i++) {
        const char *words = words_find(&w, l->list[i].text, strlen(l->list[i].text));
        need(words && strcmp(words, l->list[i].words) == 0 && words[0] && l->list[i].text[0]);
        need(i == 0 || strcmp(l->list[i - 1].text, l->list[i].text) < 0);
    }
    free(lump);
}

static void as_lump(const uint8_t *data, size_t size)
{
    char err[256] = "";
    struct words w;

    if (!words_open(&w, data, size, err, sizeof err)) {
        need(err[0]);
        return;
    }
    for (uint32_t i = 0; i < w.n; i++) {
        const char *words, *text = words_entry(&w, i, &words);
        need(words_find(&w, text, strlen(text)) == words);
    }
    words_find(&w, (const char *)data, size < 40 ? size : 40);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *copy = fuzz_copy(data, size);
    struct lang l;
    char err[256] = "";

    if (lang_read(&l, (const char *)copy, size, "de.txt", err, sizeof err))
        round_trip(&l);
    else
        need(strncmp(err, "de.txt:", 7) == 0 && strlen(err) > 9);
    lang_free(&l);
    as_lump(copy, size);
    free(copy);
    return 0;
}

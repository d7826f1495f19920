/*
 * words.h - a language of a game: texts and what stands for each, as the packer makes it of lang/NAME.txt.
 *
 * The lump "lang/NAME": u32 how many; for each, ascending by text, u32 where its text and u32 where its words begin in
 * the lump; then all these, each ended by a NUL.
 */
#ifndef ROM_WORDS_H
#define ROM_WORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { WORDS_MAX = 16384, WORDS_TEXT = 1024 /* bytes of a text or its words, with the NUL */ };

struct words {
    const uint8_t *data; /* NULL: no language */
    uint32_t n;
};

/* Checks a lump once; it must outlive words. False and one sentence else. */
bool words_open(struct words *w, const uint8_t *data, size_t size, char *err, size_t err_size);

/* Entry i: its text and its words. */
const char *words_entry(const struct words *w, uint32_t i, const char **words);

/* What stands for the n bytes of a text; NULL: nothing does. */
const char *words_find(const struct words *w, const char *text, size_t n);

#endif

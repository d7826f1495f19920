/*
 * words.h - a language of a game: strings and their translations, compiled by the packer from lang/NAME.txt.
 *
 * The lump "lang/NAME": u32 number of entries; for each, ascending by original string, u32 offset of the original and
 * u32 offset of its translation in the lump; then all these strings, each ended by a NUL.
 */
#ifndef ROM_WORDS_H
#define ROM_WORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    WORDS_MAX_ENTRIES = 16384,
    WORDS_MAX_TEXT = 1024 /* maximum bytes of an original or a translation, with the NUL */
};

struct words {
    const uint8_t *data; /* NULL: no language */
    uint32_t n;
};

/* Checks a lump and opens it. The lump must outlive w. Returns false, with one sentence in err, if it is not valid. */
bool words_open(struct words *w, const uint8_t *data, size_t size, char *err, size_t err_size);

/* Opens a lump that words_open has accepted. */
struct words words_of(const uint8_t *data);

/* Returns the original string of entry i, and stores its translation in *translation unless translation is NULL. */
const char *words_entry(const struct words *w, uint32_t i, const char **translation);

/* Returns the translation of a text of n bytes, or NULL if there is none. */
const char *words_find(const struct words *w, const char *text, size_t n);

#endif

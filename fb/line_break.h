/*
 * line_break.h - where lines of text end: between words, and in Japanese, which has no spaces, between phrases.
 */
#ifndef FB_LINE_BREAK_H
#define FB_LINE_BREAK_H

#include <stddef.h>
#include <stdint.h>

/* Whether a line may end at a place; LINE_BREAK_IN_WORD: between two characters of a script without spaces. */
enum line_break { LINE_BREAK_NONE, LINE_BREAK_IN_WORD, LINE_BREAK_WORD };

/* Returns whether a line may end before text[at], 0 < at < n. Japanese words end after punctuation, after a particle
 * that follows kanji or katakana, and where hiragana end. */
enum line_break line_break_before(const char *text, size_t n, size_t at);

/* Returns the width of a character with its spacing. */
typedef int line_advance(const void *font, uint32_t code);

/* Returns how many of the n bytes of a paragraph to put in a line: all that fit in `width`, but at least one character;
 * if that is not all, up to the last place between words in the second half of the line, as long as this costs no
 * additional line and leaves at least three letters; otherwise up to the last place where the line may end. Returns 0
 * if there is none. *fitting: the bytes that fit. */
size_t line_break_find(const char *text, size_t n, int width, line_advance *advance, const void *font, size_t *fitting);

#endif

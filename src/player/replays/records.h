/*
 * records.h - how often each section of a game was attempted in practice, and how often it was captured: the file
 * user:<game id>.practice.
 *
 * The file is plain text, ASCII. Its first line is "practice 1". A line that begins with a digit is a record:
 *
 *     MAX_CAPTURES ATTEMPTS DIFFICULTY MARK        3 12 normal queen/held
 *
 * with one blank between fields; numbers up to 999999999, no more captures than attempts; MARK is a practice start's,
 * up to the line's end. No section has two records of one difficulty. Any other line is kept as it is, where it is. A
 * file that breaks these rules is damaged: nothing of it is used, and it is not written.
 */
#ifndef PLAYER_RECORDS_H
#define PLAYER_RECORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "unsaved.h"

enum { MAX_RECORD_COUNT = 999999999, RECORDS_LINE = 256, RECORDS_BYTES = 1 << 20 };

struct record {
    char section[64], difficulty[16];
    int32_t captures, attempts;
};

/* A record, or (mark empty) a line that is kept. */
struct records_line {
    struct record r;
    char *kept; /* malloc */
};

struct records {
    struct records_line *line; /* without the first; malloc */
    int n;
    bool changed; /* since they were read or saved */
    bool damaged; /* the file is: it is left alone */
    char file[96];
};

/* Reads a whole file's text into *r, which holds nothing yet. False and one sentence without the file's name; r is
 * empty then. */
bool records_read(struct records *r, const char *text, size_t size, char *err, size_t err_size);

/* The file's text, malloc'ed; NULL: no memory. */
char *records_text(const struct records *r, size_t *size);

/* Reads the file of a game; a file that is not there is empty. A damaged one is reported by a line of plat_log. */
void records_load(struct records *r, const char *id);

/* Saves what has changed, unless the file is damaged. False and one sentence: what could not be written waits in the
 * list. */
bool records_save(struct records *r, struct unsaved **unsaved, char *err, size_t err_size);

/* The record of a section; NULL: none. */
const struct record *records_find(const struct records *r, const char *section, const char *difficulty);

/* Counts one attempt, or one capture of an attempt that was counted. Nothing where there is no memory for it, or the
 * number is at its most. */
void records_attempt(struct records *r, const char *section, const char *difficulty);
void records_capture(struct records *r, const char *section, const char *difficulty);

/* Frees the memory. Harmless on zeroed records. */
void records_free(struct records *r);

#endif

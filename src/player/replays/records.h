/*
 * records.h - the practice file user:<game id>.practice: which sections were reached in a game, and the attempts and
 * captures of each section in practice.
 *
 * The file is ASCII text. Its first line is "practice 1". A line that begins with a digit is a record:
 *
 *     CAPTURES ATTEMPTS DIFFICULTY SECTION        3 12 normal queen/held
 *
 * Fields are separated by one blank. Numbers are at most 999999999, and captures at most attempts. SECTION is that of a
 * practice start and extends to the end of the line. A section has at most one record per difficulty. The line "reached
 * SECTION", without a ship, is a section that was reached. Other lines are preserved. A file that breaks these rules is
 * damaged: it is neither used nor changed.
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

/* A record, or if r.section is empty, another line. */
struct records_line {
    struct record r;
    char *other; /* the text of another line; malloc */
};

struct records {
    struct records_line *line; /* all lines except the first; malloc */
    int n;
    bool changed; /* since the last load or save */
    bool damaged; /* the file is damaged and must not be changed */
    char file[96];
};

/* Parses the text of a file into *r, which must be empty. On failure, returns false, sets err to a sentence without the
 * file's name, and leaves *r empty. */
bool records_read(struct records *r, const char *text, size_t size, char *err, size_t err_size);

/* Returns the file's text, from malloc; NULL when out of memory. */
char *records_text(const struct records *r, size_t *size);

/* Loads a game's file; a missing file counts as empty. Reports a damaged file with plat_log. */
void records_load(struct records *r, const char *id);

/* Saves the file if records have changed, unless it is damaged. If it cannot be written, adds it to *unsaved, sets err
 * and returns false. */
bool records_save(struct records *r, struct unsaved **unsaved, char *err, size_t err_size);

/* Returns the record of a section, or NULL. */
const struct record *records_find(const struct records *r, const char *section, const char *difficulty);

/* Count an attempt, or the capture of an attempt that was counted. Do nothing when out of memory or at the maximum. */
void records_attempt(struct records *r, const char *section, const char *difficulty);
void records_capture(struct records *r, const char *section, const char *difficulty);

/* Store that a section was reached, unless the file is damaged; return whether it was. */
void records_reach(struct records *r, const char *section);
bool records_reached(const struct records *r, const char *section);

/* Frees the memory. Does nothing if *r is zeroed. */
void records_free(struct records *r);

#endif

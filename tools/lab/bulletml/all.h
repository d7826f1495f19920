/*
 * all.h - every document of a list compared at every rank, some documents at a time.
 */
#ifndef BULLETML_ALL_H
#define BULLETML_ALL_H

#include "compare.h"
#include "list.h"

enum { ALL_RANKS = 4, ALL_FRAMES = 1500 };
extern const double all_rank[ALL_RANKS];

/* Of a document. */
struct all_result {
    struct compared board[ALL_RANKS];
    bool asked; /* is the next there? */
    struct compared rounding[ALL_RANKS]
                            [SIDE_ROUNDINGS]; /* libbulletml beside itself rounding otherwise; [0] is unused */
};

enum all_what {
    ALL_BOARD,    /* the board; and the roundings, where that is not alike or the document is an exception */
    ALL_ROUNDINGS /* the roundings alone */
};

struct all_setup {
    enum all_what what;
    const struct list *documents, *exceptions;
    const char *only; /* NULL, or what must stand in the path */
    uint32_t seed;
    bool loop;
    int jobs;
};

/* One result a document, of zeroes for those that `only` leaves out; to be given to all_free. NULL: errno says why. */
struct all_result *all_compare(const struct all_setup *setup);
void all_free(struct all_result *r, int n);

/* Does the document do otherwise when doubles are rounded otherwise, at a rank; at any that the board is out at? */
bool all_rounded_otherwise(const struct all_result *r, int rank);
bool all_excused(const struct all_result *r);
bool all_alike(const struct all_result *r);

#endif

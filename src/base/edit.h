/*
 * edit.h - the edit distance between two words.
 */
#ifndef BASE_EDIT_H
#define BASE_EDIT_H

enum { EDIT_TOO_FAR = 99 }; /* the distance between words too different for one to be a typo of the other */

/* Returns the number of edits that turn one word into the other; 0 for equal words. An edit adds, drops or changes a
 * letter, or swaps two neighbouring letters. Returns EDIT_TOO_FAR for a word of more than 32 letters. */
int edit_count(const char *a, const char *b);

/* Returns edit_count if it is at most 1, or 2 if `a` has more than 3 letters, or 3 if `a` has more than 7. Returns
 * EDIT_TOO_FAR beyond that, and for two different words of at most one letter, since any two such words are equally
 * near. */
int edit_distance(const char *a, const char *b);

/* The nearest word found so far, for "did you mean"; starts as { .word = WORD }. */
struct edit_nearest {
    const char *word;
    const char *found; /* NULL: none is near */
    int distance;      /* of `found` */
};

/* Remembers the candidate if it is nearer than all before it. */
void edit_consider(struct edit_nearest *n, const char *candidate);

#endif

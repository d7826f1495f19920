/*
 * edit.h - the edit distance between two words.
 */
#ifndef BASE_EDIT_H
#define BASE_EDIT_H

enum { EDIT_TOO_FAR = 99 }; /* the distance between words too different for one to be a typo of the other */

/* Returns the number of edits that turn one word into the other; 0 for equal words. An edit adds, drops or changes a
 * letter, or swaps two neighbouring letters. The largest distance returned is 1, or 2 if `a` has more than 3 letters,
 * or 3 if `a` has more than 7. Returns EDIT_TOO_FAR beyond that, for a word of more than 32 letters, and for two
 * different words of at most one letter, since any two such words are equally near. */
int edit_distance(const char *a, const char *b);

#endif

/*
 * edit.h - the edit distance between two words.
 */
#ifndef BASE_EDIT_H
#define BASE_EDIT_H

enum { EDIT_FAR = 99 }; /* the distance of words too different for one to be a typo of the other */

/* Returns the number of letters to add, drop, change or swap with a neighbour to turn one word into the other; 0 for
 * equal words. Distances up to 1 count, up to 2 in words of more than 3 letters, up to 3 in words of more than 7.
 * Returns EDIT_FAR beyond that, for a word over 32 letters, and for two different single letters, since any two of
 * those are equally near. */
int edit_distance(const char *a, const char *b);

#endif

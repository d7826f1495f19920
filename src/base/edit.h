/*
 * edit.h - the edit distance of two words: how alike they are.
 */
#ifndef BASE_EDIT_H
#define BASE_EDIT_H

enum { EDIT_FAR = 99 }; /* of two words so different that nobody meant one by the other */

/* Letters to add, drop, change or swap with their neighbour to make one word of the other: 1, in words of more than 3
 * letters up to 2, of more than 7 up to 3; 0 for equal words. EDIT_FAR beyond that, of a word over 32 letters,
 * and of two single letters: all of those are as near. */
int edit_distance(const char *a, const char *b);

#endif

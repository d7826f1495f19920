/*
 * views.h - the words for views, in the settings and on the command line.
 */
#ifndef PLAYER_VIEWS_H
#define PLAYER_VIEWS_H

#include <stddef.h>
#include "../../board/board.h"

/* Lists that end with NULL; the index of a word is the value of the field of struct view. */
extern const char *const views_dim[], *const views_flashes[], *const views_colours[];

/* Returns the index of a word in a list, or -1. */
int views_find(const char *const *words, const char *word);

/* Writes "none, quarter, half or most", truncated to fit. */
void views_list(const char *const *words, char *out, size_t size);

#endif

/*
 * views.h - the words by which a view is chosen, in the settings and on the command line.
 */
#ifndef PLAYER_VIEWS_H
#define PLAYER_VIEWS_H

#include <stddef.h>
#include "../../board/board.h"

/* Lists that end with NULL; the place of a word is the field's value. */
extern const char *const views_dim[], *const views_flashes[], *const views_colours[];

/* The place of a word in a list, or -1. */
int views_find(const char *const *words, const char *word);

/* "none, quarter, half or most"; cut to fit. */
void views_list(const char *const *words, char *out, size_t size);

#endif

/*
 * game_name.h - makes the title and the id of a new game from the name of its folder.
 */
#ifndef WORKBENCH_GAME_NAME_H
#define WORKBENCH_GAME_NAME_H

#include <stdbool.h>

enum { GAME_ID_SIZE = 32, GAME_TITLE_SIZE = 64 }; /* bytes, as in struct manifest */

/* Writes the last name of a path (tree_id), without a truncated character at its end; false: it has none ("", ".",
 * "a/.."). */
bool game_name_of_folder(const char *dir, char name[GAME_TITLE_SIZE]);

/* Writes the id: lower case, with one _ for each run of other characters. If nothing is left, the id is game_ and a
 * checksum of the name. */
void game_name_id(const char *name, char id[GAME_ID_SIZE]);

/* Returns whether the examples' fonts have all characters: ASCII and Latin-1. */
bool game_name_has_glyphs(const char *name);

#endif

/*
 * game_name.h - what a new game is called, by the name of its folder.
 */
#ifndef WORKBENCH_GAME_NAME_H
#define WORKBENCH_GAME_NAME_H

#include <stdbool.h>

enum { CHRISTEN_ID = 32, CHRISTEN_TITLE = 64 }; /* bytes, as the manifest has them, with the 0 */

/* The last name of a path, as tree_id takes it, whole characters alone; false: it has none ("", ".", "a/.."). */
bool game_name_name(const char *dir, char name[CHRISTEN_TITLE]);

/* The id: lower case, one _ for each run of what an id may not hold; a name that leaves nothing over becomes game_ and
 * digits that are other ones for other names. */
void game_name_id(const char *name, char id[CHRISTEN_ID]);

/* Can every character of it be shown in the examples' fonts: ASCII and Latin-1? */
bool game_name_shown(const char *name);

#endif

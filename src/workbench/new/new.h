/*
 * new.h - `curtain new`: a folder with a whole game in it, to be changed.
 *
 * The games are those of examples/ and travel in the program, so nothing has to be installed beside it. What is written
 * besides: the API for editors (.curtain.lua, .luarc.json). Id and title in rom.lua are made from the folder's name.
 */
#ifndef WORKBENCH_NEW_H
#define WORKBENCH_NEW_H

#include "../../common/result.h"
#include "../pack/pack.h"

/* Files of the games, "shooter/art/kite.png"; made by tools/embed.c, in the order of their names. */
extern const struct embedded start_files[];
extern const int start_file_count;

/* Makes the folder dir, of the game `from` (NULL: shooter), and says what to do next; refuses a folder that has files.
 * The game is there whole, or nothing of it. */
enum result new_game(const char *dir, const char *from);

#endif

/*
 * new.h - `curtain new`: creates a folder with a complete game.
 *
 * The games are those of examples/, embedded in the program. The command also writes the API for editors (.curtain.lua,
 * .luarc.json). The id and title in rom.lua are made from the folder's name.
 */
#ifndef WORKBENCH_NEW_H
#define WORKBENCH_NEW_H

#include "../../common/result.h"
#include "../pack/pack.h"

/* Files of the games, such as "shooter/art/kite.png", in alphabetical order; made by tools/embed.c. */
extern const struct embedded start_files[];
extern const int start_file_count;

/* Creates the folder `dir` with the game `from` (NULL: shooter), and prints the next steps. A folder with files is
 * refused. After a failure, everything is removed. */
enum result new_game(const char *dir, const char *from);

#endif

/*
 * export.h - the command `export`: makes a file for one system that contains the game and needs no Curtain, or a zip
 * file for each system.
 *
 * A program or a core is a copy of a player without debug information, followed, at a multiple of ROM_ALIGN, by the
 * ROM. The mark of the copy (mark.h) has the ROM's position and size, so bytes may follow, for example a signature. A
 * page is player.html with the ROM in it (web.h). The table in export.c lists the players. For this system, the player
 * is curtain-player or, with the development keys, this program without its built-in game.
 */
#ifndef WORKBENCH_EXPORT_H
#define WORKBENCH_EXPORT_H

#include "../../common/result.h"
#include "../../player/args/args.h"

/* The command `export`. */
enum result export_command(const struct args *a);

#endif

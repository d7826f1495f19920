/*
 * export.h - the command `export`: a game as a file that needs no Curtain, for a system; or a zip file for each.
 *
 * A program or a core is a copy of a player, without what debuggers read, then, at a multiple of ROM_ALIGN, the ROM.
 * The copy's mark (mark.h) has its place and size, so bytes may follow: a signature. A page is player.html of
 * platform/web with the ROM in it (web.h). The table in export.c lists the players; for this system it is
 * curtain-player, or with the developer keys this program without its built-in game.
 */
#ifndef WORKBENCH_EXPORT_H
#define WORKBENCH_EXPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../common/result.h"
#include "../../player/args/args.h"

struct export_want {
    enum export_kind kind;
    const char *rom, *out; /* a folder or a ROM; the file, of EXPORT_ALL a folder; NULL: named by the game's id */
    bool nearest, keys, desktop;
    const uint8_t *builtin; /* the game that is linked into this program */
    size_t builtin_size;
};

/* Exit code and sentence as everywhere. */
enum result export_run(const struct export_want *want);

/* The command `export`. */
enum result export_command(const struct args *a);

#endif

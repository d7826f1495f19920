/*
 * export.h - the command `export`: a game as one file that runs by itself; as a page for browsers; as a core for
 * RetroArch and its like.
 * floor: cab
 *
 * The file is a copy of this program, without what debuggers read and without the game that is built in, then, at a
 * multiple of ROM_ALIGN, the ROM. The copy's mark (mark.h) says where. A core is the same of curtain_libretro.so
 * (ports/libretro), a page is player.html (ports/web) with the game in it (web.h).
 */
#ifndef CAB_EXPORT_H
#define CAB_EXPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../host/result.h"

enum export_kind { EXPORT_PROGRAM, EXPORT_PAGE, EXPORT_CORE };

struct export_want {
    enum export_kind kind;
    const char *rom, *out; /* a folder or a ROM; the file, NULL: named by the game's id */
    bool nearest, keys, desktop;
    const uint8_t *builtin; /* the game that is linked into this program */
    size_t builtin_size;
};

/* Exit code and sentence as everywhere. */
enum result export_run(const struct export_want *want);

#endif

/*
 * pack.h - a game's folder to a ROM, and a ROM to files again.
 *
 * A ROM contains rom.lua, every .lua, every .txt as text for rom.text, demos/NAME.demo, the art that rom.lua names,
 * bulletml/NAME.xml as programs if rom.lua enables BulletML, and the modules of the standard library that these scripts
 * or modules in the ROM name (std.h). std/NAME.lua of the game replaces the library's NAME. Left out: tests/, names
 * that start with a dot, all other files. The same folder gives the same bytes on every host.
 */
#ifndef WORKBENCH_PACK_H
#define WORKBENCH_PACK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../player/game/rom_image.h"

/* The standard library and the built-in game, made by tools/embed.c when the program is built. */
struct embedded {
    const char *name; /* "pattern" */
    const uint8_t *data;
    size_t size;
};
extern const struct embedded std_scripts[];
extern const int std_script_count;

/* Is std/NAME.lua (path) the name of a library script? */
bool pack_is_std(const char *path);

/* Is it a language's file, lang/NAME.txt? */
bool pack_is_lang(const char *path);

/* Is it a BulletML document, bulletml/NAME.xml? */
bool pack_is_bulletml(const char *path);

/* Gets one sentence for each thing that is allowed but probably a mistake; may be NULL. */
typedef void pack_warning(void *context, const char *sentence);

/* Packs a folder into *image (free it), which cart_open accepts. nearest: a colour that is not in its bank becomes the
 * nearest one there. False and one sentence that names file and place ("art/small.png: pixel 12,40: colour #ff00aa is
 * not in bank 3"). Warnings are about music ("music/tide.mml:12:7: ..."), documents, and pixels that vanish because
 * they are less than half opaque ("art/small.png: pixel 3,4: ..."). */
bool pack_folder(const char *dir, bool nearest, pack_warning *warn, void *context, uint8_t **image, size_t *size,
                 char *err, size_t err_size);

/* Reads a .rom file, or packs a folder. The sentence about a file starts with its path. */
bool pack_load_game(const char *path, bool nearest, struct rom_image *out, char *err, size_t err_size);
bool pack_load_game_warn(const char *path, bool nearest, pack_warning *warn, void *context, struct rom_image *out,
                         char *err, size_t err_size);

/* Calls each with one line a lump, in order: "script/main.lua 1234 0a1b2c3d" (name, bytes, CRC32). */
void pack_list(const struct rom *rom, void (*each)(void *user, const char *line), void *user);

/* Writes every lump into a file below dir: scripts and texts as they were (std/NAME.lua for the library),
 * demos/NAME.demo, the rest as lumps/NAME. Refuses, before anything is written, a name that would leave dir and a file
 * that is already there. */
bool pack_unpack(const struct rom *rom, const char *dir, char *err, size_t err_size);

#endif

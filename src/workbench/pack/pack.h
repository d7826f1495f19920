/*
 * pack.h - packs a game's folder into a ROM, and unpacks a ROM into files.
 *
 * A ROM contains rom.lua, every .lua, every .txt as text for rom.text, demos/NAME.demo, the pictures and sounds that
 * rom.lua names, bulletml/NAME.xml as programs if rom.lua enables BulletML, and the modules of the standard library
 * that scripts in the ROM use (std.h). The game's std/NAME.lua replaces the library's NAME. Ignored: tests/, names that
 * start with a dot, and all other files. The same folder gives the same bytes on every host.
 */
#ifndef WORKBENCH_PACK_H
#define WORKBENCH_PACK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../player/game/rom_image.h"

/* A file of the standard library or of the built-in game, embedded by tools/embed.c. */
struct embedded {
    const char *name; /* "pattern" */
    const uint8_t *data;
    size_t size;
};
extern const struct embedded std_scripts[];
extern const int std_script_count;

/* Returns whether path, std/NAME.lua, is a script of the standard library. */
bool pack_is_std(const char *path);

/* Returns whether path is a language file, lang/NAME.txt. */
bool pack_is_lang(const char *path);

/* Returns whether path is a BulletML document, bulletml/NAME.xml. */
bool pack_is_bulletml(const char *path);

/* Receives a sentence about each probable mistake. */
typedef void pack_warning(void *context, const char *sentence);

/* Packs a folder into *image (malloc), which cart_open accepts. nearest: convert colours that are not in their bank to
 * the nearest colour of the bank. Errors name file and position ("art/small.png: pixel 12,40: colour #ff00aa is not in
 * bank 3"). warn (may be NULL) receives warnings about music ("music/tide.mml:12:7: ..."), documents, and pixels that
 * vanish because they are less than half opaque ("art/small.png: pixel 3,4: ..."). */
bool pack_folder(const char *dir, bool nearest, pack_warning *warn, void *context, uint8_t **image, size_t *size,
                 char *err, size_t err_size);

/* Reads a .rom file, or packs a folder. Errors about a file start with its path. */
bool pack_load_game(const char *path, bool nearest, struct rom_image *out, char *err, size_t err_size);
bool pack_load_game_warn(const char *path, bool nearest, pack_warning *warn, void *context, struct rom_image *out,
                         char *err, size_t err_size);

/* Calls `each` with a line for each lump, in order: "script/main.lua 1234 0a1b2c3d" (name, bytes, CRC32). */
void pack_list(const struct rom *rom, void (*each)(void *user, const char *line), void *user);

/* Writes every lump to a file in dir: scripts and texts under their own names (std/NAME.lua for the library),
 * demos/NAME.demo, and the rest as lumps/NAME. Names outside dir and existing files are errors before anything is
 * written. */
bool pack_unpack(const struct rom *rom, const char *dir, char *err, size_t err_size);

#endif

/*
 * embedded_rom.h - the game at the end of an exported program's file.
 */
#ifndef PLAYER_EMBEDDED_ROM_H
#define PLAYER_EMBEDDED_ROM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/manifest.h"
#include "../../common/result.h"

struct embedded_rom {
    const uint8_t *rom; /* malloc, never freed; NULL: this program has no game */
    size_t size;
    struct manifest m; /* of that ROM */
    bool keys;         /* the program also has the keys and commands for authors */
};

/* Reads the program's game, if its mark (mark.h) refers to one, and renames the program to the game's id. Call it once,
 * at the start. If the file is damaged or cannot be read, sets err and returns RESULT_REFUSED or RESULT_HOST_FAILED. */
enum result embedded_rom_open(char *err, size_t err_size);

/* Returns the program's game; .rom is NULL if there is none. */
const struct embedded_rom *embedded_rom_game(void);

/* Returns whether this build can open a window; curtain-null can't. */
bool embedded_rom_has_window(void);

/* Returns whether the program only plays its own game. */
bool embedded_rom_sealed(void);

/* Prints the program's help without the options, one line per call. */
void embedded_rom_help(void (*line)(const char *));

#endif

/*
 * embedded_rom.h - the game that an exported program carries behind itself, and what such a program does and does not.
 */
#ifndef PLAYER_EMBEDDED_ROM_H
#define PLAYER_EMBEDDED_ROM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/manifest.h"
#include "../../common/result.h"

struct embedded_rom {
    const uint8_t *rom; /* malloc, until the program ends; NULL: this program carries none */
    size_t size;
    struct manifest m; /* of that ROM */
    bool keys;         /* with the keys and commands of those who make games */
};

/* Reads the program's own game, if its mark says that there is one, and takes the game's name. To be called once, at
 * the start. RESULT_REFUSED, RESULT_HOST_FAILED: the file is damaged, or cannot be read: one sentence. */
enum result embedded_rom_open(char *err, size_t err_size);

/* Never NULL. */
const struct embedded_rom *embedded_rom_game(void);

/* Is it built with a window? curtain-null is not. */
bool embedded_rom_has_window(void);

/* Does it play its game, and nothing else? */
bool embedded_rom_sealed(void);

/* The sentences for what such a program does not do: a command, another game. */
const char *embedded_rom_refuses_command(const char *command, char *err, size_t err_size);
const char *embedded_rom_refuses_game(const char *path, char *err, size_t err_size);

/* Its help, a line a call, without the options. */
void embedded_rom_help(void (*line)(const char *));

#endif

/*
 * game.h - a game named on the command line: its ROM, and how its board starts.
 */
#ifndef PLAYER_GAME_H
#define PLAYER_GAME_H

#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../args/args.h"
#include "../../demo/demo.h"
#include "rom_image.h"

/* The game linked into the program; size 0: none. An exported game (embedded_rom.h) takes precedence. */
extern const uint8_t builtin_rom[];
extern const size_t builtin_rom_size;

struct game {
    const char *path;       /* as typed; NULL: the built-in one */
    struct rom_image image; /* empty for the built-in one */
    struct rom rom;
    struct cart cart;
    struct board_start start;
    struct demo demo; /* of --demo: start is its own */
    bool has_demo;
};

/* GAME_BAD_FILES: the folder or file cannot be loaded. GAME_BAD_ARGUMENTS: the arguments don't fit the game. */
enum game_opened { GAME_OPENED, GAME_BAD_FILES, GAME_BAD_ARGUMENTS };

/* Loads the folder or .rom file at path (NULL: the built-in game), and sets its start from the arguments. On failure,
 * returns false, sets err to a sentence that names the file or option, and leaves nothing to close. *g must not be
 * moved, because it contains pointers to itself. */
bool game_open(struct game *g, const char *path, const struct args *a, char *err, size_t err_size);

/* The same, but returns the kind of failure. */
enum game_opened game_try(struct game *g, const char *path, const struct args *a, char *err, size_t err_size);

/* Sets g->start from the arguments (--dip, --difficulty, --stage and its options), for the game in g->cart. On failure,
 * returns false and sets err to a sentence that names the option. */
bool game_start(struct game *g, const struct args *a, char *err, size_t err_size);

/* Frees everything. Does nothing if *g is zeroed. */
void game_close(struct game *g);

#endif

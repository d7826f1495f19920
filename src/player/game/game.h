/*
 * game.h - a ROM taken from the command line: loaded, checked, and how its board is to start.
 */
#ifndef PLAYER_GAME_H
#define PLAYER_GAME_H

#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../args/args.h"
#include "../../demo/demo.h"
#include "rom_image.h"

/* The game linked into the program; size 0: none. An exported one (embedded_rom.h) comes before it. */
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

/* What becomes of game_open: the folder or file is wrong, or what the arguments say of the start. */
enum game_opened { GAME_OPENED, GAME_WRONG, GAME_REFUSED };

/* Loads the folder or .rom file at path (NULL: the built-in game), and reads what the arguments say of its start. False
 * and one sentence that names the file or option; nothing is left to close then. g stays where it is: it points into
 * itself. */
bool game_open(struct game *g, const char *path, const struct args *a, char *err, size_t err_size);

/* The same, and why not. */
enum game_opened game_try(struct game *g, const char *path, const struct args *a, char *err, size_t err_size);

/* What the arguments say of the start (--dip, --difficulty, --stage and what goes with it), for the game in g->cart.
 * False and one sentence that names the option. */
bool game_start(struct game *g, const struct args *a, char *err, size_t err_size);

/* Gives everything back; a zeroed game is fine. */
void game_close(struct game *g);

#endif

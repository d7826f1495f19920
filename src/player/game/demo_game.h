/*
 * demo_game.h - `play FILE` of a demo, which names no game: finds the game that it was recorded with.
 */
#ifndef PLAYER_DEMO_GAME_H
#define PLAYER_DEMO_GAME_H

#include "../../common/files.h"
#include "../args/args.h"

struct demo_game {
    char path[FILES_PATH_SIZE]; /* "": the built-in game */
    char *word;                 /* path, as a list of words */
};

/* If a plays a file that is a demo, turns the file into --demo and the game into the ROM to play; *found must last as
 * long as a. The game is searched for in the program, in the demo's folder, in that folder's parent, and among the ROMs
 * that are stored for replays. Other commands and files are left alone. False and one sentence: the game of exactly
 * this version was not found. */
bool demo_game_find(struct args *a, struct demo_game *found, char *err, size_t err_size);

#endif

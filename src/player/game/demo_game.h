/*
 * demo_game.h - `play FILE` of a demo, which names no game: finds the game that it was recorded with.
 */
#ifndef PLAYER_DEMO_GAME_H
#define PLAYER_DEMO_GAME_H

#include "../../common/files.h"
#include "../args/args.h"

struct demo_game {
    char path[FILES_PATH_SIZE]; /* "": the built-in game */
    char *word;                 /* points to path; args.words points to it */
};

/* If *a plays a demo file, changes *a to play the demo's game with --demo; *found must last as long as *a. Searches for
 * the game in the program, in the demo's folder, in that folder's parent, and among the ROMs stored for replays. Leaves
 * other commands and files unchanged. If the game in exactly this version is not found, returns false and sets err. */
bool demo_game_find(struct args *a, struct demo_game *found, char *err, size_t err_size);

#endif

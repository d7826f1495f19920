/*
 * board.h - a game made of a document, and its board.
 */
#ifndef BULLETML_BOARD_H
#define BULLETML_BOARD_H

#include "../../../src/workbench/pack/pack.h"
#include "side.h"

struct board_game {
    struct rom_image image;
    void *ram;
    struct board *b;
};

/* Packs tools/lab/bulletml/GAME with the document of the setup, to run it so many times over, and powers a board. On
 * failure, returns false and sets err. */
bool board_game_open(struct board_game *g, const char *game, const struct side_setup *setup, int roots, char *err,
                     size_t err_size);
void board_game_close(struct board_game *g);

/* One frame with the player there. False and one sentence: a script stopped it. */
bool board_game_tick(struct board_game *g, int32_t player_x, int32_t player_y, char *err, size_t err_size);

#endif

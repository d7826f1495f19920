/*
 * web.h - makes a web page of a game: the player for browsers (platform/web) with the title and the ROM of the game.
 */
#ifndef WORKBENCH_WEB_H
#define WORKBENCH_WEB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct web_game {
    const char *title;
    const uint8_t *rom; /* compressed or plain */
    size_t size;
};

/* Makes the page, *out (malloc), from player.html. name: its name for messages. False: it is not a player, or has
 * another core version. */
bool web_make(const struct web_game *game, const uint8_t *player, size_t player_size, const char *name, uint8_t **out,
              size_t *size, char *err, size_t err_size);

/* Returns whether the file is a page with a game. */
bool web_is_page(const uint8_t *file, size_t size);

#endif

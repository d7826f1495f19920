/*
 * web.h - a game as a page: the player for browsers (platform/web) with the game's title and ROM in the places of its
 * marks.
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

/* Makes the page, *out (malloc). player: player.html, which messages call name. False and one sentence: it is none, or
 * one of another core version. */
bool web_make(const struct web_game *game, const uint8_t *player, size_t player_size, const char *name, uint8_t **out,
              size_t *size, char *err, size_t err_size);

/* Is it a page with a game in it? */
bool web_is_page(const uint8_t *file, size_t size);

#endif

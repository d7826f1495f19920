/*
 * screen_state.h - what the screens of src/player/play keep while they are open: each its own, all in struct cab.
 */
#ifndef PLAYER_SCREEN_STATE_H
#define PLAYER_SCREEN_STATE_H

#include <stdbool.h>
#include <stdint.h>
#include "../settings/config.h"
#include "../input/keys.h"
#include "screen.h"
#include "../replays/replays.h"
#include "../replays/thumb.h"

enum { SETTINGS_ROWS = 96 };

/* screen_keys.c: the key that is to be pressed. */
struct keys_wait {
    bool listening;
    int action; /* for which */
    struct keys_capture capture;
    bool began; /* capture has seen what was held */
};

/* screen_replays.c. */
struct replays_view {
    struct replays list;
    struct thumb thumb;
    int thumb_of; /* the replay whose picture that is; -1: none */
    char typed[REPLAY_NAME_SIZE];
    bool typing, fresh; /* fresh: a letter takes the place of what is proposed */
    uint8_t held[PLAT_KEYS / 8];
    uint32_t switches;
    char text[SCREEN_HELP];
};

/* screen_resume.c: the run that was left. */
struct resume_left {
    char text[SCREEN_HELP];
    bool can;     /* its ROM is there, and this engine plays it as it was */
    bool changed; /* the game is another since */
};

/* screen_settings.c. */
enum settings_row { SETTINGS_GROUP, SETTINGS_VALUE, SETTINGS_LANGUAGE, SETTINGS_TO_KEYS };

struct settings_list {
    struct {
        enum settings_row kind;
        const struct config_setting *setting; /* of a value, and the first of a group */
    } row[SETTINGS_ROWS];
    int rows;
    char lang[16]; /* as it was when the screen was opened */
};

#endif

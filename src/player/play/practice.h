/*
 * practice.h - the practice menu: a screen with the section to practise, the ship, the difficulty and the loadout, and
 * a list of all sections of the game with their attempts and captures.
 *
 * A section can be locked until it was reached in a game (sections_need_reaching).
 *
 * Counting. An attempt of a section is counted when a practice start of it begins: from the menu, by the retry key, or
 * when the game itself starts the section again. A capture is counted when the section is completed without a death: a
 * phase is beaten, or a stage, from its start or from a mark, reaches its end. Neither is counted with invincibility,
 * nor after the run was rewound (until the next start).
 */
#ifndef PLAYER_PRACTICE_H
#define PLAYER_PRACTICE_H

#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../run/sections.h"
#include "../screens/screen.h"
#include "../replays/records.h"

struct practice_menu {
    const struct cart *cart;
    struct records records;

    struct board_start home;  /* the game from its title */
    struct board_start start; /* of the present run */
    bool counts,
        attempting; /* counts: attempts of this run count. attempting: one is in progress, without a death so far */

    struct screens *screens;
    bool listed;
    bool locks;        /* sections that no game has reached are locked */
    bool start_chosen; /* since it was opened: the caller powers the board on with practice_chosen's start */
    struct sections sections;
    int ship, difficulty, lives, speed; /* ship: in sections; lives 0: the ship's own; speed: percent */
    int32_t value[MAX_SHIP_REGISTERS];  /* of sections.reg */
    bool invincible, hitbox;            /* hitbox: show hit shapes */
    int chosen;                         /* the section to start, in sections */
    char section[64];                   /* the id of the section last started, without its ship; "": none */
};

/* Loads the records of the game. start: that of the present run; is_folder: the game is played from its folder. The
 * cart must outlive the menu, or be replaced with practice_reloaded. */
void practice_init(struct practice_menu *m, const struct cart *cart, const struct board_start *start, bool is_folder);

/* Call it when a live board was powered on with this start. */
void practice_start_run(struct practice_menu *m, const struct board_start *start);

/* Counts attempts and captures. Call it after each tick of the live board, with its output. */
void practice_after_tick(struct practice_menu *m, const struct board_out *out);

/* Unlocks the section that a marker of a game starts. Call it for the markers of games that are not practice. */
void practice_reach(struct practice_menu *m, const struct board_marker *marker);

/* Returns the game's sections and titles, in the language of the present run. Lists them if that wasn't done yet. */
const struct sections *practice_sections(struct practice_menu *m);

/* Stops counting in this run: it was rewound, or the board was changed from outside. */
void practice_stop_counting(struct practice_menu *m);

/* Call it when the game was reloaded: lists its sections again, and stops counting in this run. */
void practice_reloaded(struct practice_menu *m, const struct cart *cart);

extern const struct screen_def practice_screen;

/* Opens the menu above the open screens, and lists the game's sections the first time. speed: the present setting. The
 * menu closes all screens when something is chosen. */
void practice_open(struct practice_menu *m, struct screens *screens, int speed);

/* The chosen start: the present run's with another difficulty and practice settings. The caller sets its nvram. */
void practice_chosen(const struct practice_menu *m, struct board_start *out);

/* Saves the records and frees everything. Harmless on a zeroed menu. */
void practice_close(struct practice_menu *m);

#endif

/*
 * practice.h - the practice menu: every section of the game, its settings, its attempts and captures.
 * floor: cab
 *
 * The menu lies over the picture and the board stands still. Player 1's pad works it: up and down, left and right
 * change a setting (ten steps at a time while focus is held), fire starts a section, bomb goes back to the game.
 *
 * Counting. An attempt of a section is counted when a practice start of it begins: from the menu, by the retry key, or
 * when the game starts the section again by itself. A capture is counted when the section ends well without a death
 * since it began: a phase is beaten, or a stage, from its start or from a mark, reaches its end. Neither is counted
 * with invincible, nor after the run was rewound (until the next start).
 */
#ifndef CAB_PRACTICE_H
#define CAB_PRACTICE_H

#include "../../board/board.h"
#include "../../board/rom/cart.h"
#include "../overlay/canvas.h"
#include "../run/sections.h"
#include "records.h"

/* What the player chose in a frame of the open menu. */
enum practice_choice { PRACTICE_STAYS, PRACTICE_BACK, PRACTICE_START };

struct practice_menu {
    const struct cart *cart;
    struct records records;

    struct board_start home;  /* the game from its title */
    struct board_start start; /* what the present run was started with */
    bool counts, attempting;  /* counts: attempts of this run count. attempting: one is on, without a death so far */

    bool open, listed;
    struct sections sections;
    int difficulty, lives, slow;       /* lives 0: the ship's own; slow: 1, 2, 4 frames a tick */
    int32_t value[PRACTICE_REGISTERS]; /* of sections.reg */
    bool invincible, hitbox;           /* hitbox: show hit shapes over the picture */
    char section[64];                  /* of the section last started; "": none, or the game from its title */
    int row, top;                      /* the chosen row, and the first that is shown */
    int shown;                         /* rows of the last drawing */
    uint16_t held;
    int held_for; /* frames that up, down, left or right is held */
};

/* Reads the records of the game. start: how the run was started. The cart must outlive the menu, or be replaced with
 * practice_reloaded. */
void practice_init(struct practice_menu *m, const struct cart *cart, const struct board_start *start);

/* To be called when a live board was powered with this start. */
void practice_began(struct practice_menu *m, const struct board_start *start);

/* Counts attempts and captures: to be called after each tick of the live board, with its output. */
void practice_after_tick(struct practice_menu *m, const struct board_out *out);

/* Counts nothing more in this run: it was rewound, or the board was changed from outside. */
void practice_stop_counting(struct practice_menu *m);

/* To be called when the game was reloaded: its sections are listed again, and this run does not count any more. */
void practice_reloaded(struct practice_menu *m, const struct cart *cart);

/* Opens the menu, and lists the game's sections the first time. slow: the present setting. */
void practice_open(struct practice_menu *m, int slow);

/* Runs the open menu for a frame, with these buttons held by player 1. */
enum practice_choice practice_poll(struct practice_menu *m, uint16_t pad);

/* Makes the start that was chosen: the present run's with another difficulty and practice settings, or that of the game
 * from its title, which has no practice.section. The caller sets its nvram. */
void practice_chosen(const struct practice_menu *m, struct board_start *out);

/* Draws the open menu over the whole picture. */
void practice_draw(struct practice_menu *m, const struct canvas *canvas);

/* Saves the records and frees everything. Harmless on a zeroed menu. */
void practice_close(struct practice_menu *m);

#endif

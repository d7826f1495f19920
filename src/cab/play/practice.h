/*
 * practice.h - the cabinet's practice menu: every section of the game, how it is to be started, and how often it was
 * tried and captured.
 * floor: cab    used by: cab tests/
 *
 * The menu lies over the picture and the board stands still. Player 1's pad works it: up and down, left and right
 * change a setting (ten steps at a time while focus is held), fire starts a section, bomb goes back to the game.
 *
 * Counting. An attempt of a section is counted when a practice start of it begins: chosen in the menu, again, or anew
 * by itself. A capture, when it ends well without a death since it began: a phase is beaten; a stage, from its start or
 * from a mark, comes to its end. Neither is counted with invincible, nor after time was run backwards (until the next
 * start).
 */
#ifndef CAB_PRACTICE_H
#define CAB_PRACTICE_H

#include "../../board/board.h"
#include "../../board/rom/cart.h"
#include "../overlay/ink.h"
#include "../run/sections.h"
#include "records.h"

/* What comes of a frame with the menu open. */
enum practice_choice { PRACTICE_STAYS, PRACTICE_BACK, PRACTICE_START };

struct practice_menu {
    const struct cart *cart;
    struct records records;

    struct board_start home;  /* the game from its title */
    struct board_start start; /* what the present run was started with */
    bool counts, trying;      /* is it a practice run whose attempts count; one is on, without a death so far */

    bool open, listed;
    struct sections sections;
    int difficulty, lives, slow;       /* lives 0: the ship's own; slow: 1, 2, 4 frames a tick */
    int32_t value[PRACTICE_REGISTERS]; /* of sections.reg */
    bool invincible, hitbox;           /* hitbox: it is to be shown over the picture */
    char section[64];                  /* of the section last started, "": none; "" is also the game from its title */
    int row, top;                      /* the chosen row, and the first that is shown */
    int shown;                         /* rows of the last drawing */
    uint16_t held;
    int held_for; /* frames that up, down, left or right is held */
};

/* Reads the records of the game. start: the first one, whatever it starts. The cart outlives the menu, or
 * practice_reloaded gives another. */
void practice_init(struct practice_menu *m, const struct cart *cart, const struct board_start *start);

/* A live board was just powered with this start, so: an attempt begins soon. */
void practice_began(struct practice_menu *m, const struct board_start *start);

/* Hears what a tick of the live board told. */
void practice_hear(struct practice_menu *m, const struct board_out *out);

/* Nothing more of this run is counted: time went backwards, or the board was changed from outside. */
void practice_void(struct practice_menu *m);

/* The game was reloaded: its sections are listed anew, and this run is not counted any more. */
void practice_reloaded(struct practice_menu *m, const struct cart *cart);

/* Opens the menu, and lists the game's sections the first time. slow: as it is now. */
void practice_open(struct practice_menu *m, int slow);

/* A sixtieth of a second of the open menu with these buttons held by player 1. */
enum practice_choice practice_poll(struct practice_menu *m, uint16_t pad);

/* The start that was chosen: the present run's with another difficulty and practice; or that of the game from its
 * title, which has no practice.section. Its nvram is the caller's business. */
void practice_chosen(const struct practice_menu *m, struct board_start *out);

/* Draws the open menu over a whole picture. */
void practice_draw(struct practice_menu *m, const struct ink *ink);

/* Saves the records; gives everything back. Harmless on one of zeroes. */
void practice_close(struct practice_menu *m);

#endif

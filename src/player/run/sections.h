/*
 * sections.h - the sections of a game that can be practised: its stages with their marks, its bosses with their phases.
 *
 * A second board is asked (PRACTICE_LIST, board.h), so a game built on @std has its list with no work.
 */
#ifndef PLAYER_SECTIONS_H
#define PLAYER_SECTIONS_H

#include "../../board/board.h"

enum { MAX_SECTIONS = 512, MAX_SHIPS = 32 /* what is more is not listed */ };

enum section_kind {
    SECTION_STAGE,
    SECTION_MARK, /* a mark of the stage before it */
    SECTION_BOSS, /* a heading: nothing starts there */
    SECTION_PHASE /* of the boss before it */
};

struct section {
    enum section_kind kind;
    char id[64];    /* of a practice start; of a boss its name */
    char name[32];  /* without its parent's */
    char title[48]; /* of a boss, and the spell of a phase; "": none */
};

struct sections {
    int n;
    struct section section[MAX_SECTIONS];
    int ships;
    char ship[MAX_SHIPS][32]; /* the first is what practice is played with; "": not known */
    int32_t lives;            /* of the first, in all */
    int registers;
    struct {
        char name[32];
        int32_t value;
    } reg[PRACTICE_MAX_REGISTERS];
    char why[512]; /* one sentence when the list ends early, or nothing can be listed; "": it is whole */
};

/* Fills the list with what the game tells when started so (its practice start aside). Takes a few frames' time and a
 * board's memory for as long. log: what the board logs meanwhile goes to plat_log. */
void sections_list(struct sections *p, const struct rom *rom, const struct board_start *start, bool log);

#endif

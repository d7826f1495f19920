/*
 * sections.h - lists the sections of a game for practice: its stages with their marks, its bosses with their phases.
 *
 * The list is made by a second board (PRACTICE_LIST, board.h), so games built on @std don't declare their sections.
 */
#ifndef PLAYER_SECTIONS_H
#define PLAYER_SECTIONS_H

#include "../../board/board.h"

enum { MAX_SECTIONS = 512, MAX_SHIPS = 32 /* more are not listed */ };

enum section_kind {
    SECTION_STAGE,
    SECTION_MARK, /* a mark of the stage before it */
    SECTION_BOSS, /* a heading, not a start */
    SECTION_PHASE /* of the boss before it */
};

struct section {
    enum section_kind kind;
    char id[64];    /* of the practice start; for a boss its name */
    char name[32];  /* without its parent's */
    char title[48]; /* of a boss, and the spell of a phase; "": none */
};

struct sections {
    int n;
    struct section section[MAX_SECTIONS];
    int ships;
    char ship[MAX_SHIPS][32]; /* practice uses the first one; "": unknown */
    int32_t lives;            /* of the first, in all */
    int registers;
    struct {
        char name[32];
        int32_t value;
    } reg[PRACTICE_MAX_REGISTERS];
    char why[512]; /* why the list is incomplete; "": it is complete */
};

/* Lists the sections of a game with this start, ignoring start->practice. Takes the time of a few frames, and meanwhile
 * the memory of a board. log: prints the board's script output with plat_log. */
void sections_list(struct sections *p, const struct rom *rom, const struct board_start *start, bool log);

#endif

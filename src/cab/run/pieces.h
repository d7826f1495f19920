/*
 * pieces.h - the pieces of a game that can be practised: its stages with their marks, its bosses with their phases.
 * floor: cab    used by: practice tests/
 *
 * A second board is asked (PRACTICE_LIST, board.h), so a game built on @std has its list with no work.
 */
#ifndef CAB_PIECES_H
#define CAB_PIECES_H

#include "../../board/board.h"

enum { PIECES = 512 /* what is more is not listed */ };

enum piece_kind {
    PIECE_STAGE,
    PIECE_POINT, /* a mark of the stage before it */
    PIECE_BOSS,  /* a heading: nothing starts there */
    PIECE_PHASE  /* of the boss before it */
};

struct piece {
    enum piece_kind kind;
    char mark[64];  /* of a practice start; of a boss its name */
    char name[32];  /* without its parent's */
    char title[48]; /* of a boss, and the spell of a phase; "": none */
};

struct pieces {
    int n;
    struct piece piece[PIECES];
    char ship[32]; /* what practice is played with; "": not known */
    int32_t lives; /* of it, in all */
    int registers;
    struct {
        char name[32];
        int32_t value;
    } reg[PRACTICE_REGISTERS];
    char why[512]; /* one sentence when the list ends early, or nothing can be listed; "": it is whole */
};

/* Fills the list with what the game tells when started so (its practice start aside). Takes a few frames' time and a
 * board's memory for as long. log: what the board logs meanwhile goes to plat_log. */
void pieces_list(struct pieces *p, const struct rom *rom, const struct board_start *start, bool log);

#endif

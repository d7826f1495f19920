/*
 * bulletml_run.h - BulletML documents on the board.
 */
#ifndef SCRIPT_BULLETML_RUN_H
#define SCRIPT_BULLETML_RUN_H

#include <lua.h>
#include "../machine/machine.h"

/* A frame of all that runs, before bullets move; what they fired appears when
 * the hits are done. */
void bulletml_run(struct board *b);
void bulletml_let_go(struct board *b);

/* What a document is started with. */
struct bulletml_start {
    uint16_t program;      /* of the ROM's */
    int64_t owner, follow; /* handles, 0: the board, none */
    fx x, y, dx, dy;       /* dx, dy: from what it follows */
    uint16_t kind, tag;
    const uint16_t *kinds; /* ML_KINDS */
    uint8_t bank, flags;   /* ROOT_ */
    uint32_t seed;         /* not 0 */
    int64_t rank, pace;    /* Q31.32 */
    ang angle;
    int params;
    const int64_t *param;
};

/* Starts one; returns its slot, or NO_SLOT: there is no room, or it has no action that begins by itself. */
int32_t bulletml_begin(struct board *b, const struct bulletml_start *start);

/* The document in slot i is over: its bullets go on. */
void bulletml_stop(struct board *b, uint32_t i);

/* on_fire of the root in slot i is what is on top of the stack (popped); and calls it, for a bullet and a label + 1. */
void bulletml_set_handler(lua_State *L, uint32_t i);
void bulletml_tell(lua_State *L, struct board *b, int64_t bullet, uint32_t i, uint32_t label);

#endif

/*
 * bulletml_run.h - runs BulletML documents on the board.
 */
#ifndef SCRIPT_BULLETML_RUN_H
#define SCRIPT_BULLETML_RUN_H

#include "../machine/machine.h"

/* bulletml_run runs all documents for one frame; it is called before bullets move. bulletml_spawn_fired_bullets spawns
 * the bullets that the documents fired in the frame; it is called after the frame's hits. */
void bulletml_run(struct board *b);
void bulletml_spawn_fired_bullets(struct board *b);

/* The arguments for starting a document. */
struct bulletml_start {
    uint16_t program;      /* index among the ROM's documents */
    int64_t owner, follow; /* handles; owner 0: the board; follow 0: nothing */
    fx x, y, dx, dy;       /* dx, dy: offset from the followed entity */
    uint16_t kind, tag;
    const uint16_t *kinds;     /* ML_MAX_KINDS entries: bullet kind by label */
    uint8_t bank, flags;       /* flags: ROOT_* */
    uint32_t seed;             /* not 0 */
    int64_t rank, speed_scale; /* Q31.32; speed_scale: px a frame for speed 1 */
    ang angle;
    int param_count;
    const int64_t *param;
};

/* Starts a document. Returns its slot, or NO_SLOT if a pool is full or the document has no top-level action. */
int32_t bulletml_begin(struct board *b, const struct bulletml_start *start);

/* Ends the document in slot i. Its bullets continue. */
void bulletml_stop(struct board *b, uint32_t i);

#endif

/*
 * check_run.h - a run of the game for `curtain check`. All runs are checked for the same problems (check_run.c).
 */
#ifndef WORKBENCH_CHECK_RUN_H
#define WORKBENCH_CHECK_RUN_H

#include "../../board/board.h"
#include "../../demo/demo.h"
#include "../../player/run/guard.h"
#include "../../player/run/sections.h"
#include "../../rom/cart.h"
#include "../../script/force.h"
#include "../pack/pack.h"
#include "check_parts.h"

enum { MAX_LOOKS = 128 /* pairs of a kind and a bank */ };

/* Bullets of a kind in a bank, in the sampled frames of a run. */
struct look {
    char kind[64];
    int bank, seen, faint;
    uint32_t frame; /* of the first faint one */
    int x, y;       /* of it */
    bool reported;  /* in this or an earlier run */
};

/* The state of the contrast check in a run. */
struct contrast {
    struct fb fb;
    void *pixels, *scratch;
    uint32_t frame;
    int samples, n;
    struct look look[MAX_LOOKS];
};

struct run {
    struct check *c;
    const char *what; /* "demos/attract.demo", "600 frames without input" */
    struct rom_image image;
    struct cart cart;
    struct guard guard;
    struct demo demo;
    uint64_t hashes[MAX_PARTS];
    void *hash_cache;             /* of board_hashes_cached */
    size_t lua_peak;              /* bytes of Lua RAM, in all runs so far */
    char lua_peak_run[TREE_PATH]; /* the run with this peak */
    bool memory_fault;
    struct contrast contrast;
    struct check_heard *heard; /* NULL: the sound is not checked */
    bool measured;             /* the shapes of kinds have been compared with their pictures */
    struct sections *sections;
    int runs, planned;        /* played so far; of all */
    bool boots;               /* boot.run was called */
    unsigned faulting_forces; /* 1 << force_kind: caused a fault, and is not forced again */
    bool forced;              /* something was forced in this run, so full pools are not reported */
};

/* Powers the board on; false: it cannot be, which is a finding. `what` is the name of the run. */
bool check_run_power_on(struct run *r, const char *what, const struct board_start *start);

/* Runs a frame. */
const struct board_out *check_run_tick(struct run *r, const uint16_t pads[MAX_PLAYERS]);

/* Shows the progress: frame f of at most n. */
void check_run_show_progress(const struct run *r, uint32_t f, uint32_t n);

/* Ends the run. */
void check_run_finish(struct run *r);

/* Returns a start with the default DIP switches. */
struct board_start check_run_start(const struct run *r);

/* Returns whether the section is played: marks are inside of stages. */
static inline bool check_run_plays(const struct section *s)
{
    return s->kind == SECTION_STAGE || s->kind == SECTION_PHASE;
}

/* Plays the runs of check_forced.c, which force what only players cause: each ship and difficulty, deaths, bombs,
 * continues, pauses, the end of the game. Returns how many; check_forced_count only counts them. */
int check_forced_count(struct run *r);
int check_forced_play(struct run *r);

#endif

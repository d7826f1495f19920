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

enum { MAX_CONTRAST_ENTRIES = 128 /* pairs of a kind and a bank */ };

/* Counts of the bullets of a kind in a bank, in the sampled frames of a run. */
struct contrast_entry {
    char kind[64];
    int bank, total, faint;
    uint32_t frame; /* of the first faint bullet */
    int x, y;       /* of this bullet */
    bool reported;  /* in this or an earlier run */
};

/* The state of the contrast check in a run. */
struct contrast {
    struct fb fb;
    void *pixels, *scratch;
    uint32_t frame;
    int samples, n;
    struct contrast_entry entry[MAX_CONTRAST_ENTRIES];
};

struct run {
    struct check *c;
    const char *name; /* "demos/attract.demo", "600 frames without input" */
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
    struct check_audio *audio; /* NULL: the sound is not checked */
    bool measured;             /* the shapes of kinds have been compared with their pictures */
    struct sections *sections;
    int runs, planned;        /* played so far; in total */
    bool boots;               /* boot.run was called */
    unsigned faulting_forces; /* bits 1 << force_kind: events that caused a fault, and are not forced again */
    bool forced;              /* an event was forced in this run, so full pools are not reported */
};

/* Powers the board on for a run. False: it could not be powered on, which is a finding. `what`: the name of the run. */
bool check_run_power_on(struct run *r, const char *what, const struct board_start *start);

/* Runs a frame. */
const struct board_out *check_run_tick(struct run *r, const uint16_t pads[MAX_PLAYERS]);

/* Shows the progress: frame f of at most n. */
void check_run_show_progress(const struct run *r, uint32_t f, uint32_t n);

/* Ends the run. */
void check_run_finish(struct run *r);

/* Returns a start with the default DIP switches. */
struct board_start check_run_start(const struct run *r);

/* Returns whether the section is played. Marks are skipped, because they are inside stages. */
static inline bool check_run_plays(const struct section *s)
{
    return s->kind == SECTION_STAGE || s->kind == SECTION_PHASE;
}

/* check_forced_play plays the runs of check_forced.c, which force events that otherwise only players cause: each ship
 * and difficulty, deaths, bombs, continues, pauses, the end of the game. Both functions return the number of runs. */
int check_forced_count(struct run *r);
int check_forced_play(struct run *r);

#endif

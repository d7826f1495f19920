/*
 * measure.h - the cost of a game's frames. Each run is played several times, with the tick, picture and sound of each
 * frame timed; then again, with every Lua instruction counted.
 *
 * Counts are the same on every machine. Times are those of the board, without the window and the speaker. The shortest
 * time of a frame in all rounds is used, because the work is the same, and the rest is due to other processes.
 */
#ifndef WORKBENCH_MEASURE_H
#define WORKBENCH_MEASURE_H

#include "../../board/board.h"
#include "../../board/inspect.h"
#include "../../script/profile.h"
#include "../../rom/cart.h"
#include "../../demo/demo.h"
#include "../../common/result.h"
#include "../../player/run/sections.h"

enum {
    MEASURE_ROUNDS = 3,     /* timed rounds of each run */
    MEASURE_SECTIONS = 512, /* frames of further sections count as outside of sections */
    MEASURE_NAME = 72,      /* bytes of "queen/bloom" */
    MEASURE_FRAME = 16667   /* microseconds at 60 frames per second */
};

/* A run of a demo, or with the buttons of sweep.h. */
struct measure_run {
    const char *name; /* "run.demo", "one"; kept, not copied */
    struct board_start start;
    const struct demo *demo; /* NULL: sweeps */
    enum section_kind kind;  /* without a demo: of the section that the run plays */
    uint32_t most;           /* frames at most; 0: the demo's, or SWEEP_FRAMES */
};

/* The frames of a stage or a phase, or those outside of all sections, in all runs. Times are sums in microseconds. */
struct measure_section {
    char name[MEASURE_NAME]; /* "one", "queen/bloom"; "": outside */
    uint32_t frames;
    uint64_t tick, draw, sound;
    uint64_t phase[PHASES]; /* of the ticks; only in `all` */
    uint64_t lua;           /* work of scripts, as profile_work */
    uint32_t *frame;        /* cost of each frame; ascending after measure_end */
    uint32_t worst, at;     /* the most expensive frame: its cost, and its number in its run */
    const char *in;         /* name of that run */
};

struct measure {
    const struct rom *rom;
    const struct cart *cart;
    struct measure_section section[MEASURE_SECTIONS]; /* in the order of their first frames; [0]: outside */
    int n;
    struct measure_section all; /* of all frames */
    struct profile profile;
    struct inspect_gauge most[MAX_PARTS]; /* of each part: the maximum of each number at the end of a frame */
    int parts;
    size_t lua_peak; /* bytes */
    int runs;
    uint64_t done, planned; /* frames, of all rounds: for progress.h */
};

/* Starts; free it with measure_close. */
void measure_open(struct measure *m, const struct cart *cart);

/* Adds the expected frames of a run to m->planned, for progress. */
void measure_plan(struct measure *m, const struct measure_run *run);

/* Measures a run. RESULT_REFUSED: it faulted, or cannot start, which has been reported. */
enum result measure_add(struct measure *m, const struct measure_run *run);

/* Returns whether a run reached the section. */
bool measure_has(const struct measure *m, const char *name);

/* Sums and sorts, after the last run. */
void measure_end(struct measure *m);

/* Returns a percentile of a section's frames in microseconds. */
uint32_t measure_most(const struct measure_section *s, int percent);

/* Returns how many frames take longer than `limit` microseconds. */
uint32_t measure_over(const struct measure_section *s, uint64_t limit);

void measure_close(struct measure *m);

#endif

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
    MEASURE_ROUNDS = 3,         /* timed rounds of each run */
    MEASURE_MAX_SECTIONS = 512, /* frames of further sections are counted outside of all sections */
    MEASURE_NAME = 72,          /* bytes of "queen/bloom" */
    MEASURE_FRAME_USEC = 16667  /* a frame at 60 frames per second */
};

/* A run of a demo, or one with the buttons of sweep.h. */
struct measure_run {
    const char *name; /* "run.demo", "one"; not copied */
    struct board_start start;
    const struct demo *demo; /* NULL: buttons of sweep.h */
    enum section_kind kind;  /* without a demo: of the section that the run plays */
    uint32_t max_frames;     /* 0: the demo's length, or SWEEP_FRAMES */
};

/* The frames of a stage or a phase, or those outside of all sections, in all runs. Times are sums in microseconds. */
struct measure_section {
    char name[MEASURE_NAME]; /* "one", "queen/bloom"; "": outside */
    uint32_t frames;
    uint64_t tick, draw, sound;
    uint64_t phase[PHASES];      /* of the ticks; only in `all` */
    uint64_t lua;                /* work of scripts, as profile_work */
    uint32_t *frame_usec;        /* cost of each frame; ascending after measure_end */
    uint32_t worst, worst_frame; /* the most expensive frame: its cost, and its number in its run */
    const char *worst_run;       /* name of that run */
};

struct measure {
    const struct rom *rom;
    const struct cart *cart;
    struct measure_section section[MEASURE_MAX_SECTIONS]; /* in the order of their first frames; [0]: outside */
    int n;
    struct measure_section all; /* of all frames */
    struct profile profile;
    struct inspect_gauge peak[MAX_PARTS]; /* of each part: the maximum of each number at the end of a frame */
    int parts;
    size_t lua_peak; /* bytes */
    int runs;
    uint64_t done, planned; /* frames of all rounds, for progress */
};

/* Initializes m; free it with measure_close. */
void measure_open(struct measure *m, const struct cart *cart);

/* Adds the expected frames of a run to m->planned, for progress. */
void measure_plan(struct measure *m, const struct measure_run *run);

/* Measures a run. RESULT_REFUSED: the run faulted or could not start, which has been reported. */
enum result measure_add(struct measure *m, const struct measure_run *run);

/* Returns whether a run reached the section. */
bool measure_has(const struct measure *m, const char *name);

/* Sums and sorts, after the last run. */
void measure_end(struct measure *m);

/* Returns a percentile of a section's frames in microseconds. */
uint32_t measure_percentile(const struct measure_section *s, int percent);

/* Returns how many frames take longer than `limit` microseconds. */
uint32_t measure_count_over(const struct measure_section *s, uint64_t limit);

void measure_close(struct measure *m);

#endif

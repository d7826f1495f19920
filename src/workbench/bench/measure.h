/*
 * measure.h - what the frames of a game cost: runs of it are played several times, and each frame's tick, picture and
 * sound timed; then once more, with every instruction of Lua counted.
 *
 * What is counted is the same on every machine. What is timed is this machine's, of the board alone: neither the
 * window's picture nor the speaker is in it. Of a frame's times in the rounds the least is taken, so that what
 * else the machine did in the others does not show: the work is the same every time.
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
    MEASURE_ROUNDS = 3,     /* each run is timed so often */
    MEASURE_SECTIONS = 512, /* what is more is put to the frames outside of sections */
    MEASURE_NAME = 72,      /* bytes of "queen/bloom" */
    MEASURE_FRAME = 16667   /* microseconds that a frame has */
};

/* A run: a demo's, or of a ship that sweeps (sweep.h). */
struct measure_run {
    const char *name; /* "run.demo", "one"; kept, not copied */
    struct board_start start;
    const struct demo *demo; /* NULL: sweeps */
    enum section_kind kind;  /* then: which section it is whose end is the run's */
    uint32_t most;           /* frames at most; 0: as many as the demo has, or SWEEP_FRAMES */
};

/* Frames of a stage or a phase, or those outside of all sections, over all runs. Times in microseconds, of all frames
 * together. */
struct measure_section {
    char name[MEASURE_NAME]; /* "one", "queen/bloom"; "": outside */
    uint32_t frames;
    uint64_t tick, draw, sound;
    uint64_t phase[PHASES]; /* of the ticks: what each phase of them took; of `all` alone */
    uint64_t lua;           /* work of scripts, as profile_work */
    uint32_t *frame;        /* of each frame: all that it cost; ascending after measure_end */
    uint32_t worst, at;     /* the dearest: what it cost, and its number in its run */
    const char *in;         /* that run's name */
};

struct measure {
    const struct rom *rom;
    const struct cart *cart;
    struct measure_section section[MEASURE_SECTIONS]; /* in the order in which they were come to; [0]: outside */
    int n;
    struct measure_section all; /* of all frames */
    struct profile profile;
    struct inspect_gauge most[MAX_PARTS]; /* of each part the largest of each number that a frame ended with */
    int parts;
    size_t lua_peak; /* bytes */
    int runs;
    uint64_t done, planned; /* frames, of all rounds: for progress.h */
};

/* All zero but for the ROM; free it with measure_close. */
void measure_open(struct measure *m, const struct cart *cart);

/* Says how many frames the run has, or may well have, before the first is measured. */
void measure_plan(struct measure *m, const struct measure_run *run);

/* Measures a run. RESULT_REFUSED: it faulted, or cannot begin, and a line says so; RESULT_HOST_FAILED: no memory. */
enum result measure_add(struct measure *m, const struct measure_run *run);

/* Was the section of that name come to? */
bool measure_has(const struct measure *m, const char *name);

/* After the last run: sums and sorts. */
void measure_end(struct measure *m);

/* What `percent` of a section's frames do not exceed, microseconds. */
uint32_t measure_most(const struct measure_section *s, int percent);

/* How many of its frames take longer than so many microseconds. */
uint32_t measure_over(const struct measure_section *s, uint64_t limit);

void measure_close(struct measure *m);

#endif

/*
 * profile.h - counts the cost of each line of a game's scripts: Lua instructions, and the work of API functions. The
 * same run gives the same counts on every machine.
 *
 * The counts are in host memory and never in hashed RAM, so profiling does not change a run. Profiling makes a tick
 * many times slower; when it is off, nothing runs per instruction.
 */
#ifndef SCRIPT_PROFILE_H
#define SCRIPT_PROFILE_H

#include <stdbool.h>
#include <stdint.h>

struct board;

enum {
    PROFILE_CAPACITY = 1 << 14, /* lines, a power of two; further lines are counted in `overflow` */
    PROFILE_LOCATION_SIZE = 72  /* bytes of "stages/one.lua:42" */
};

/* Work is in instructions, counted as for the infinite-loop guard (vm_count.c). */
struct profile_line {
    char location
        [PROFILE_LOCATION_SIZE]; /* the author's line if the call chain has one, otherwise a line of @std; "": unused */
    uint64_t instructions;       /* Lua instructions */
    uint64_t call_work;          /* work of C functions called: 100 per API function, more for costly ones */
    uint64_t allocated_bytes;    /* allocated; approximate, because table growth depends on hash order */
    uint64_t library_instructions; /* the part of `instructions` executed in @std functions that the line called */
};

struct profile {
    struct profile_line line[PROFILE_CAPACITY]; /* in no order */
    struct profile_line overflow;               /* lines that did not fit */
    struct profile_line total;                  /* the sum of all lines */

    /* private to profile.c */
    struct profile_line *current;         /* the last instruction's line; NULL: none yet in this turn */
    const char *source;                   /* chunk of the last instruction; NULL: none, or in @std */
    int source_line;                      /* line of the last instruction in `source` */
    uint64_t counted_work, counted_bytes; /* work and allocated bytes (heap_work) counted so far */
};

/* Starts counting into p, which must be zeroed; NULL stops. Call it after power-on and after a restore. Profiling does
 * not affect the infinite-loop guard. */
void board_set_profile(struct board *b, struct profile *p);

/* Returns a line's total work: instructions and calls. */
uint64_t profile_work(const struct profile_line *line);

#endif

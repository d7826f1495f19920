/*
 * profile.h - what each line of a game's scripts costs, counted: instructions of Lua, and what functions of the API
 * count as. The same run gives the same numbers on every machine.
 *
 * The counts stand in the host's memory, so that a run is the same with them and without: nothing in RAM that is hashed
 * knows of them. While they are taken a tick takes many times as long; while they are not, nothing asks.
 */
#ifndef SCRIPT_PROFILE_H
#define SCRIPT_PROFILE_H

#include <stdbool.h>
#include <stdint.h>

struct board;

enum {
    PROFILE_ROOM = 1 << 14, /* lines, a power of two; what is more is counted in `other` */
    PROFILE_PLACE = 72      /* bytes of "stages/one.lua:42" */
};

/* Work is counted in instructions, as the guard against endless loops counts it (vm_count.c). */
struct profile_line {
    char place[PROFILE_PLACE]; /* "": this entry is free. A line of the author's, if one led there; else @std's */
    uint64_t instructions;     /* of Lua */
    uint64_t calls;            /* work of functions in C that it called: 100 a function of the API, more for many */
    uint64_t bytes;            /* allocated: about, for tables grow as their keys happen to fall */
    uint64_t library;          /* of the instructions: those in functions of @std that the line called */
};

struct profile {
    struct profile_line line[PROFILE_ROOM]; /* in no order */
    struct profile_line other;              /* of lines for which there was no room */
    struct profile_line all;                /* of all lines */

    /* of profile.c */
    struct profile_line *now; /* the last instruction's; NULL: none since scripts had a turn */
    const char *source; /* where the last instruction of an author's function stood, and what it was counted for */
    int at;
    uint64_t seen, allocated;
};

/* Counts from now on into p, zeroes at first; NULL: no more. Call it after power-on and after a restore. An
 * endless loop is found as it is without. */
void board_profile(struct board *b, struct profile *p);

/* A line's work in all: instructions and calls. */
uint64_t profile_work(const struct profile_line *line);

#endif

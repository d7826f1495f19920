/*
 * bench_fx.h - what tools/lab/bench_fx/bench_fx.c measures: the functions both libraries have, as tables of pointers.
 *
 * Each side's table stands in an object of its own, so every call goes through a pointer: nothing is inlined, nothing
 * is hoisted out of a loop, and what is inline in a header is an ordinary function here.
 */
#ifndef TOOLS_BENCH_FX_H
#define TOOLS_BENCH_FX_H

#include <stdbool.h>
#include <stdint.h>

enum { INPUTS = 65536 }; /* arguments a function: too many for a branch predictor to learn */

enum operation {
    OP_ADD,
    OP_ADD_MARK, /* theirs: a mark instead of the nearest value when the result is too large */
    OP_SUB,
    OP_SUB_MARK,
    OP_MUL,
    OP_MUL_MARK,
    OP_DIV,
    OP_DIV_MARK,
    OP_SQRT,
    OP_SIN,
    OP_SIN_CHEAP, /* theirs: a parabola */
    OP_COS,
    OP_ATAN2,
    OP_LERP,
    OP_FROM_INT,
    OP_FROM_DOUBLE,
    OP_TO_DOUBLE,
    OPS
};

/* What a function takes, from which column, and returns. */
enum shape {
    ONE,         /* a */
    TWO,         /* a, b */
    ANGLE,       /* a, b; returns an angle */
    TURN,        /* a, an angle */
    RADIANS,     /* rad: the same angle */
    LERP,        /* a, b, t */
    LERP16,      /* a, b, t as 16 bits */
    FROM_DOUBLE, /* d */
    TO_DOUBLE    /* a */
};

struct call {
    const char *name;
    enum shape shape;
    union {
        int32_t (*one)(int32_t);
        int32_t (*two)(int32_t, int32_t);
        uint32_t (*angle)(int32_t, int32_t);
        int32_t (*turn)(uint32_t);
        int32_t (*lerp)(int32_t, int32_t, int32_t);
        int32_t (*lerp16)(int32_t, int32_t, uint16_t);
        int32_t (*from_double)(double);
        double (*to_double)(int32_t);
    } f;
};

struct args {
    int32_t a[INPUTS], b[INPUTS], rad[INPUTS];
    uint16_t t[INPUTS];
    double d[INPUTS];
};

extern const struct call ours[OPS];
extern const struct call theirs_debian[OPS], theirs_o2[OPS], theirs_uncached[OPS], theirs_lut[OPS];

/* Random bits for every argument of every function. */
void inputs_random(struct args all[OPS]);

/* The arguments a game would have, made from what is in the demo's frames. Ends the program, saying why, when the demo
 * cannot be played. */
void inputs_recorded(const char *rom, const char *demo, struct args all[OPS]);

#endif

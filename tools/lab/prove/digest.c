/*
 * digest.c - what every function of fx.h and trig.h gives for a fixed stream of arguments, as one hexadecimal line:
 * equal in every build. `digest --each` has a line for each function.
 *
 * Portable: no wide integers, no library but the C one. Besides random arguments, those of hard.inc for every function:
 * near ties is where builds could differ.
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "../../../src/base/trig.h"
#include "../numbers.h"

enum { RUNS = 40000 };

static uint64_t fold(uint64_t digest, uint64_t v)
{
    digest = (digest ^ v) * 0x9fb21c651e98df25;
    return digest ^ digest >> 35;
}

static uint64_t bits_of(double v)
{
    uint64_t bits;

    memcpy(&bits, &v, sizeof bits);
    return bits;
}

static const struct {
    const char *name;
    int64_t a, b;
} HARD[] = {
#include "hard.inc"
};

enum what {
    ADD,
    SUB,
    MUL,
    DIV,
    SQRT,
    RSQRT,
    HYPOT,
    ROOT,
    LERP,
    FROM_DOUBLE,
    TO_DOUBLE,
    SIN30,
    COS30,
    SIN,
    COS,
    ATAN2,
    POLAR,
    STRIDE,
    NORMALISE,
    DIFFERENCE,
    FROM_DEGREES,
    TURN_FROM_DEGREES,
    TO_DEGREES,
    FUNCTIONS
};
static const char *const NAMES[FUNCTIONS] = {
    "fx_add",
    "fx_sub",
    "fx_mul",
    "fx_div",
    "fx_sqrt",
    "fx_rsqrt",
    "fx_hypot",
    "fx_root",
    "fx_lerp",
    "fx_from_double",
    "fx_to_double",
    "trig_sin30",
    "trig_cos30",
    "trig_sin",
    "trig_cos",
    "trig_atan2",
    "trig_polar",
    "trig_stride",
    "trig_normalise",
    "trig_difference",
    "trig_from_degrees",
    "trig_turn_from_degrees",
    "trig_to_degrees",
};

/* Two results in one number. */
static uint64_t pair(fx a, fx b)
{
    return (uint64_t)(uint32_t)a << 32 | (uint32_t)b;
}

/* The result of a function for two numbers, of which it uses what it needs. */
static uint64_t result(enum what what, fx a, fx b, uint64_t z)
{
    double v = ldexp((double)(int64_t)z, -(int)(z % 64) - 30);
    int64_t far[2];
    ang turned = 1;
    fx out[2] = { 1, 1 };

    switch (what) {
    case ADD:
        return pair(fx_add(a, b), 0);
    case SUB:
        return pair(fx_sub(a, b), 0);
    case MUL:
        return pair(fx_mul(a, b), 0);
    case DIV:
        return pair(fx_div(a, b), 0);
    case SQRT:
        return pair(fx_sqrt(a), fx_sqrt(b));
    case RSQRT:
        return pair(fx_rsqrt(a), fx_rsqrt(b));
    case HYPOT:
        return pair(fx_hypot(a, b), 0);
    case ROOT:
        return fx_root(z >> 1 >> ((uint32_t)b & 31));
    case LERP:
        return pair(fx_lerp(a, b, (fx)(z >> 40)), fx_lerp(b, a, (fx)z));
    case FROM_DOUBLE:
        return (uint64_t)fx_from_double(v, &out[0]) << 32 | (uint32_t)out[0];
    case TO_DOUBLE:
        return bits_of(fx_to_double(a));
    case SIN30:
        return pair(trig_sin30((ang)a), trig_sin30((ang)b));
    case COS30:
        return pair(trig_cos30((ang)a), trig_cos30((ang)b));
    case SIN:
        return pair(trig_sin((ang)a), trig_sin((ang)b));
    case COS:
        return pair(trig_cos((ang)a), trig_cos((ang)b));
    case ATAN2:
        return trig_atan2(a, b);
    case POLAR:
        trig_polar(a, (ang)b, &out[0], &out[1]);
        return pair(out[0], out[1]);
    case STRIDE:
        trig_stride((int64_t)z >> 16, a, (ang)b, &far[0], &far[1]);
        return fold((uint64_t)far[0], (uint64_t)far[1]);
    case NORMALISE:
        trig_normalise(a, b, &out[0], &out[1]);
        return pair(out[0], out[1]);
    case DIFFERENCE:
        return pair(trig_difference((ang)a, (ang)b), 0);
    case FROM_DEGREES:
        return (uint64_t)trig_from_degrees(v, &turned) << 32 | turned;
    case TURN_FROM_DEGREES:
        return (uint64_t)trig_turn_from_degrees(v, &out[0]) << 32 | (uint32_t)out[0];
    case TO_DEGREES:
        return bits_of(trig_to_degrees((ang)a));
    case FUNCTIONS:
        break;
    }
    return 0;
}

static uint64_t digest_of(enum what what)
{
    uint64_t state = (uint64_t)what, digest = 0;

    for (int i = 0; i < RUNS; i++) {
        uint64_t z = numbers_random(&state), y = numbers_random(&state);
        uint32_t shift = (uint32_t)(z & 31), other = (uint32_t)(z >> 5 & 31);

        digest = fold(digest, result(what, (fx)((int64_t)z >> 32 >> shift), (fx)((int64_t)y >> 32 >> other), y));
    }
    for (size_t i = 0; i < sizeof HARD / sizeof HARD[0]; i++)
        digest = fold(digest, result(what, (fx)(uint32_t)HARD[i].a, (fx)(uint32_t)HARD[i].b, (uint64_t)HARD[i].a));
    return digest;
}

int main(int argc, char **argv)
{
    bool each = argc == 2 && !strcmp(argv[1], "--each");
    uint64_t all = 0;

    if (argc > 1 && !each) {
        fprintf(stderr, "usage: %s [--each]\n", argv[0]);
        return 2;
    }
    for (int i = 0; i < FUNCTIONS; i++) {
        uint64_t digest = digest_of((enum what)i);

        all = fold(all, digest);
        if (each)
            printf("%-24s %016" PRIx64 "\n", NAMES[i], digest);
    }
    if (!each)
        printf("%016" PRIx64 "\n", all);
    return 0;
}

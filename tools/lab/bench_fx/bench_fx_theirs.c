/*
 * bench_fx_theirs.c - libfixmath's side of bench_fx.c. Compiled once for each build of the library, with
 * SIDE naming the table; the script links each with its library and hides everything but the table. With ABSENT the
 * table is empty.
 */
#include <libfixmath/fix16.h>
#include "bench_fx.h"

#ifdef ABSENT
const struct call SIDE[OPS] = { { 0 } };
#else
const struct call SIDE[OPS] = {
    [OP_ADD] = { "fix16_sadd", TWO, { .two = fix16_sadd } },
    [OP_ADD_MARK] = { "fix16_add", TWO, { .two = fix16_add } },
    [OP_SUB] = { "fix16_ssub", TWO, { .two = fix16_ssub } },
    [OP_SUB_MARK] = { "fix16_sub", TWO, { .two = fix16_sub } },
    [OP_MUL] = { "fix16_smul", TWO, { .two = fix16_smul } },
    [OP_MUL_MARK] = { "fix16_mul", TWO, { .two = fix16_mul } },
    [OP_DIV] = { "fix16_sdiv", TWO, { .two = fix16_sdiv } },
    [OP_DIV_MARK] = { "fix16_div", TWO, { .two = fix16_div } },
    [OP_SQRT] = { "fix16_sqrt", ONE, { .one = fix16_sqrt } },
    [OP_SIN] = { "fix16_sin", RADIANS, { .one = fix16_sin } },
    [OP_SIN_CHEAP] = { "fix16_sin_parabola", RADIANS, { .one = fix16_sin_parabola } },
    [OP_COS] = { "fix16_cos", RADIANS, { .one = fix16_cos } },
    [OP_ATAN2] = { "fix16_atan2", TWO, { .two = fix16_atan2 } },
    [OP_LERP] = { "fix16_lerp16", LERP16, { .lerp16 = fix16_lerp16 } },
    [OP_FROM_INT] = { "fix16_from_int", ONE, { .one = fix16_from_int } },
    [OP_FROM_DOUBLE] = { "fix16_from_dbl", FROM_DOUBLE, { .from_double = fix16_from_dbl } },
    [OP_TO_DOUBLE] = { "fix16_to_dbl", TO_DOUBLE, { .to_double = fix16_to_dbl } },
};
#endif

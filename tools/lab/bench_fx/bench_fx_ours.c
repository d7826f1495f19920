/*
 * bench_fx_ours.c - Curtain's side of tools/lab/bench_fx/bench_fx.c.
 */
#include "../../../src/base/fx.h"
#include "../../../src/base/trig.h"
#include "bench_fx.h"

/* Only the value, as theirs. */
static fx from_double(double v)
{
    fx r = 0;

    fx_from_double(v, &r);
    return r;
}

const struct call ours[OPS] = {
    [OP_ADD] = { "fx_add", TWO, { .two = fx_add } },
    [OP_ADD_MARK] = { "fx_add", TWO, { .two = fx_add } },
    [OP_SUB] = { "fx_sub", TWO, { .two = fx_sub } },
    [OP_SUB_MARK] = { "fx_sub", TWO, { .two = fx_sub } },
    [OP_MUL] = { "fx_mul", TWO, { .two = fx_mul } },
    [OP_MUL_MARK] = { "fx_mul", TWO, { .two = fx_mul } },
    [OP_DIV] = { "fx_div", TWO, { .two = fx_div } },
    [OP_DIV_MARK] = { "fx_div", TWO, { .two = fx_div } },
    [OP_SQRT] = { "fx_sqrt", ONE, { .one = fx_sqrt } },
    [OP_SIN] = { "trig_sin", TURN, { .turn = trig_sin } },
    [OP_SIN_CHEAP] = { "trig_sin", TURN, { .turn = trig_sin } },
    [OP_COS] = { "trig_cos", TURN, { .turn = trig_cos } },
    [OP_ATAN2] = { "trig_atan2", ANGLE, { .angle = trig_atan2 } },
    [OP_LERP] = { "fx_lerp", LERP, { .lerp = fx_lerp } },
    [OP_FROM_INT] = { "fx_int", ONE, { .one = fx_int } },
    [OP_FROM_DOUBLE] = { "fx_from_double", FROM_DOUBLE, { .from_double = from_double } },
    [OP_TO_DOUBLE] = { "fx_to_double", TO_DOUBLE, { .to_double = fx_to_double } },
};

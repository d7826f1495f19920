/*
 * twin.c - the engine's integer twins (fx.h), compiled beside the code that takes steps in doubles.
 */
#define FX_INTEGER
#define trig_sin30             twin_sin30
#define trig_cos30             twin_cos30
#define trig_sin               twin_sin
#define trig_cos               twin_cos
#define trig_atan2             twin_atan2
#define trig_polar             twin_polar
#define trig_atan2s            twin_atan2s
#define trig_polars            twin_polars
#define trig_strides           twin_strides
#define trig_normalise         twin_normalise
#define trig_stride            twin_stride
#define trig_from_degrees      twin_from_degrees
#define trig_turn_from_degrees twin_turn_from_degrees
#define trig_to_degrees        twin_to_degrees
#define trig_cos_sin40         twin_direction
#include "../../../src/base/trig.c"
#include "rivals.h"

fx twin_div(fx a, fx b)
{
    return fx_div(a, b);
}

fx twin_sqrt(fx x)
{
    return fx_sqrt(x);
}

fx twin_rsqrt(fx x)
{
    return fx_rsqrt(x);
}

fx twin_hypot(fx x, fx y)
{
    return fx_hypot(x, y);
}

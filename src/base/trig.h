/*
 * trig.h - angles, their sines, and directions of vectors.
 *
 * An ang is a whole number of 2^-32 turns, so it wraps around by itself: 0 points along +x and, as y grows downwards,
 * ANG_DOWN points down. Sine and cosine use the same axes: direction a is (cos a, sin a) on the screen.
 *
 * Results are correctly rounded (fx.h) for every input unless noted. Mirrored inputs give exactly mirrored results.
 */
#ifndef BASE_TRIG_H
#define BASE_TRIG_H

#include "fx.h"

#define ANG_QUARTER ((ang)0x40000000) /* of a turn */
#define ANG_HALF    ((ang)0x80000000)
#define ANG_DOWN    ANG_QUARTER
#define ANG_UP      ((ang)0xc0000000)

/* Return sine and cosine in Q30: 2^30 is one. */
int32_t trig_sin30(ang a);
int32_t trig_cos30(ang a);

/* Stores cosine and sine in Q40, off by less than 2^-26, in a fraction of the time of trig_cos30 and trig_sin30. For
 * values that are rounded to fx afterwards. */
void trig_cos_sin40(ang a, int64_t *cosine, int64_t *sine);

fx trig_sin(ang a);
fx trig_cos(ang a);

/* Returns the direction of (x, y), correct to all 32 bits; 0 for (0, 0). FX_MIN is allowed. Note the argument order: y
 * first. */
ang trig_atan2(fx y, fx x);

/*
 * Stores *vx = speed * cos(dir), *vy = speed * sin(dir), each rounded once. A negative speed points backwards. A
 * component that would be one unit beyond FX_MAX (speed FX_MIN) is FX_MAX.
 */
void trig_polar(fx speed, ang dir, fx *vx, fx *vy);

/*
 * Stores the vector from the point at distance `from` along dir to the point at distance `to`, each point rounded once,
 * so that strides in one direction add up without error. Any unit; |from|, |to| <= 2^48. Each coordinate is correctly
 * rounded unless its exact value is within 2^-70 of halfway.
 */
void trig_stride(int64_t from, int64_t to, ang dir, int64_t *dx, int64_t *dy);

/* Apply trig_atan2, trig_polar and trig_stride to n elements, with the same results bit for bit. Output arrays must not
 * overlap input arrays. */
void trig_atan2s(const fx *y, const fx *x, ang *a, int n);
void trig_polars(const fx *speed, const ang *dir, fx *vx, fx *vy, int n);
void trig_strides(const int64_t *from, const int64_t *to, const ang *dir, int64_t *dx, int64_t *dy, int n);

/* Stores (x, y) scaled to length 1, each component correctly rounded; (0, 0) for (0, 0). FX_MIN is allowed. */
void trig_normalise(fx x, fx y, fx *ux, fx *uy);

/* Returns the shorter turn from one direction to the other, clockwise positive; INT32_MIN when they are opposite. */
static inline int32_t trig_difference(ang from, ang to)
{
    return (int32_t)(to - from);
}

/* Stores the ang nearest to deg, modulo whole turns. Returns false, leaving *out untouched, for NaN and the
 * infinities. */
bool trig_from_degrees(double deg, ang *out);

/* Like trig_from_degrees, but stores a signed turn: deg is first reduced, by whole turns, to -180 <= deg < 180. */
bool trig_turn_from_degrees(double deg, int32_t *out);

/* Returns degrees in [0, 360). The result is exact: trig_from_degrees converts it back to the same ang. */
double trig_to_degrees(ang a);

#endif

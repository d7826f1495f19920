/*
 * trig_guess.h - the first guess of trig_polar: cosine and sine of a direction in doubles. It is in a separate file so
 * that the proof (`make prove`) can test it in all directions.
 */
#ifndef BASE_TRIG_GUESS_H
#define BASE_TRIG_GUESS_H

#ifndef FX_INTEGER
#include "fx.h"
#include "trig_tables.h"

/*
 * Stores a guess of cosine and sine of dir. dir is h / 2^40 turns from the nearest of 256 rays, |h| <= 2^31. With c and
 * s the cosine and sine of the ray, the results are c cos h - s sin h and s cos h + c sin h. Using polynomials for sin
 * h and 1 - cos h, the error is below 2.551 / 2^44. Roundings add less than 2^-52 to each result: 2^-54 for the table's
 * entry, 2^-54 for the last sum, and 2^-57 for each rounding within the correction, which is below 2^-6.3. The total is
 * below 2.56 / 2^44 (`make prove` checks every direction).
 */
static inline void trig_cos_sin_guess(ang dir, double *cosine, double *sine)
{
    const double *ray = RAY[(ang)(dir + 0x800000) >> 24];
    double c = ray[0], s = ray[1], h = (int32_t)(dir << 8), hh = h * h;
    double sin_h = (RAY_STEP.a + RAY_STEP.b * hh) * h, versin_h = (RAY_STEP.c + RAY_STEP.d * hh) * hh;

    *cosine = c - (c * versin_h + s * sin_h);
    *sine = s + (c * sin_h - s * versin_h);
}
#endif

#endif

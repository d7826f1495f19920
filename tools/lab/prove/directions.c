/*
 * directions.c - proves trig_atan2 and trig_normalise.
 *
 * trig_atan2 is right by its error bound unless the vector is next to a ray halfway between two angs, and then it asks
 * on which side, with 120 bits; what has to be shown is that these suffice for the nearest vector there is. An eighth
 * of a turn has 2^29 rays, of slope t. Where |dt - n| < 1/(2d), the vector (d, n) is a convergent of the continued
 * fraction of t, or a multiple of one (Legendre): so is all that lies within 2^-64 radians of a ray, and the nearest of
 * all. The fractions of all rays are walked as far as d <= 2^31, and convergents nearer than 2^-60 radians tried, with
 * their largest multiples.
 *
 * Oracle: the vector's side of the rays half an ang away from the result, from sines and cosines to 124 bits; what is
 * within 2^-88 of a ray, by MPFR.
 *
 * trig_normalise: a part rounds up or down at (2r + 1) / 2^17, r < 2^16: 65536 rays. The oracle is exact:
 * (2u - 1)^2 (xx + yy) < 2^34 xx < (2u + 1)^2 (xx + yy); there are no ties.
 */
#include "../../../src/base/trig.h"
#include "oracle.h"

enum { TURN, UNIT, CHUNK = 1 << 10 };
static const int64_t LONGEST = (int64_t)1 << 31;
static const double ANG = 1.4629180792671596e-9; /* radians */

/* a * b modulo 2^128 */
static u128 times(u128 a, int64_t b)
{
    return b < 0 ? -(a * (uint64_t)-b) : a * (uint64_t)b;
}

/* How far (x, y) lies clockwise of the ray at h half angs, as y cos h - x sin h; only the sign is sure. */
static double beside_ray(uint64_t h, int64_t x, int64_t y, uint64_t *by_mpfr)
{
    u128 s, c;
    i128 side;

    for (uint64_t q = h >> 31 & 3; q; q--) { /* a quarter turn back, with its vector */
        int64_t old = x;

        x = y;
        y = -old;
    }
    oracle_circle(h & (ORACLE_QUARTER - 1), &s, &c);
    side = (i128)(c >> 34) * y - (i128)(s >> 34) * x;
    if (side > (i128)1 << 48 || side < -((i128)1 << 48))
        return (double)side * 0x1p-94;
    side = (i128)(times(c, y) - times(s, x)); /* modulo one */
    if (side > (i128)1 << 40 || side < -((i128)1 << 40))
        return side > 0 ? oracle_double((u128)side) : -oracle_double((u128)-side);
    ++*by_mpfr;
    return oracle_ray_side(h & (ORACLE_QUARTER - 1), x, y) * 0x1p-88;
}

/* (x, y) is not (0, 0). The result has to lie within half an ang, on either side, and not behind. */
static void check_turn(struct tally *t, int64_t y, int64_t x)
{
    ang a = trig_atan2((fx)y, (fx)x);
    double length = sqrt((double)x * (double)x + (double)y * (double)y) * ANG;
    double low = beside_ray((uint64_t)a * 2 - 1, x, y, &t->by_mpfr) / length;
    double high = -beside_ray((uint64_t)a * 2 + 1, x, y, &t->by_mpfr) / length;

    if (low > 0 && high > 0 && low + high < 1.5)
        tally_right(t, low < high ? low : high, y, x);
    else
        tally_wrong(t, 0.5 + (low < 0 ? -low : -high), y, x, a, (int64_t)(ang)oracle_atan2(y, x));
}

/* In the eight positions, or one of them. */
static void check_turn_in(struct tally *t, int64_t y, int64_t x, uint32_t position)
{
    int64_t a = position & 1 ? x : y, b = position & 1 ? y : x;

    a = position & 2 ? -a : a;
    b = position & 4 ? -b : b;
    if (a <= FX_MAX && b <= FX_MAX && a >= FX_MIN && b >= FX_MIN)
        check_turn(t, a, b);
}

static void check_turn_mirrored(struct tally *t, int64_t y, int64_t x)
{
    for (uint32_t i = 0; i < 8; i++)
        check_turn_in(t, y, x, i);
}

/* Of the ray at h half angs, h odd and below an eighth of a turn. */
static void check_ray(struct tally *t, uint32_t h, uint64_t *random)
{
    u128 s, c;

    oracle_circle(h, &s, &c);
    s >>= 34;
    c >>= 34;
    for (struct walk w = walk_from(s, c); walk_next(&w, (uint64_t)LONGEST);) {
        double angle = (double)(int64_t)(w.rest >> 32) * 0x1p-62 / (double)w.d; /* less than twice that, to be exact */
        int64_t most = LONGEST / (int64_t)w.d;

        if (angle > 0x1p-60)
            continue;
        if (angle < 0x1p-82)
            check_turn_mirrored(t, (int64_t)w.n, (int64_t)w.d);
        else
            check_turn_in(t, (int64_t)w.n, (int64_t)w.d, (uint32_t)(numbers_random(random) >> 61));
        if (most > 1)
            check_turn_in(t, most * (int64_t)w.n, most * (int64_t)w.d, 6);
    }
}

static void rays(uint64_t chunk, struct tally *t, uint64_t *random)
{
    for (uint32_t i = 0; i < CHUNK; i++)
        check_ray(&t[TURN], ((uint32_t)chunk * CHUNK + i) * 2 + 1, random);
}

/* Vectors made of two neighbouring convergents: of every distance from their ray. */
static void beside_rays(uint64_t chunk, struct tally *t, uint64_t *random)
{
    u128 s, c;

    (void)chunk;
    oracle_circle((uint32_t)(numbers_random(random) >> 34 >> numbers_random(random) % 20) | 1, &s, &c);
    for (struct walk w = walk_from(s >> 34, c >> 34); walk_next(&w, (uint64_t)LONGEST);)
        for (int i = 0; i < 8; i++) {
            uint64_t z = numbers_random(random), f = z % 256 + 1, g = z >> 8 & 255 >> (z >> 16) % 8;

            if (f * w.d + g * w.d0 <= (uint64_t)LONGEST)
                check_turn_in(&t[TURN], (int64_t)(f * w.n + g * w.n0), (int64_t)(f * w.d + g * w.d0),
                              (uint32_t)(z >> 61));
        }
}

static void dense_turns(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (int64_t y = 0; y <= (int64_t)chunk + 1; y++)
        check_turn_mirrored(&t[TURN], y, (int64_t)chunk + 1);
}

static void any_turn(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        int32_t x = prove_scaled(random) | 1;

        check_turn(&t[TURN], prove_scaled(random), x);
        check_turn(&t[TURN], (int32_t)numbers_random(random) | 1, (int32_t)numbers_random(random));
        check_turn(&t[TURN], x, (int32_t)numbers_random(random));
    }
}

static const int64_t EDGES[] = { FX_MIN, FX_MIN + 1, -FX_ONE, -2, -1, 0, 1, 2, FX_ONE, FX_MAX - 1, FX_MAX };

static void turn_edges(uint64_t chunk, struct tally *t, uint64_t *random)
{
    ang a = trig_atan2(0, 0);

    (void)random;
    for (uint64_t i = 0; i < COUNT(EDGES); i++)
        if (EDGES[i] || EDGES[chunk])
            check_turn(&t[TURN], EDGES[chunk], EDGES[i]);
        else if (a == 0)
            tally_right(&t[TURN], 0.5, 0, 0);
        else
            tally_wrong(&t[TURN], 0, 0, 0, a, 0);
}

static void turns_by_mpfr(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t x = prove_scaled(random) | 1, y = prove_scaled(random);
    ang r = trig_atan2((fx)y, (fx)x), want = (ang)oracle_atan2(y, x);

    (void)chunk;
    t[TURN].by_mpfr++;
    if (r == want)
        tally_right(&t[TURN], 0.5, y, x);
    else
        tally_wrong(&t[TURN], fabs((double)(int32_t)(r - want)), y, x, r, want);
}

static void prove_turns(void)
{
    oracle_open();
    prove_hard(TURN, "trig_atan2", check_turn_mirrored);
    prove_phase(turn_edges, COUNT(EDGES), COUNT(EDGES));
    prove_phase(rays, (uint64_t)1 << 29 >> 10, 40);
    prove_phase(beside_rays, 1 << 20, 1000);
    prove_phase(dense_turns, 1 << 12, 4);
    prove_phase(any_turn, 1 << 17, 40);
    prove_phase(turns_by_mpfr, 20000, 200);
    prove_line(TURN, "trig_atan2",
               "hard: the vectors nearest to each of the 2^29 rays between two results, found with continued "
               "fractions; vectors next to rays, dense, random; a sample with MPFR");
}

/* Is u the nearest to 2^16 |x| / sqrt(n), and how far is that from halfway? */
static bool is_unit(uint64_t u, int64_t x, uint64_t n, double *off)
{
    u128 part = (u128)(uint64_t)(x * x) << 34, low = 2 * (u128)u - (u > 0), high = 2 * (u128)u + 1;
    u128 under = low * low * n, over = high * high * n;
    double twice = 0x1p17 * fabs((double)x) / sqrt((double)n), above, below;

    if (u > FX_ONE || (u > 0 && part <= under) || part >= over)
        return false;
    above = (double)(over - part) / (double)n / ((double)(uint64_t)high + twice) / 2;
    below = u > 0 ? (double)(part - under) / (double)n / ((double)(uint64_t)low + twice) / 2 : 1;
    *off = above < below ? above : below;
    return true;
}

static void check_part(struct tally *t, int64_t got, int64_t x, int64_t y, bool first)
{
    int64_t of = first ? x : y, size = got < 0 ? -got : got;
    uint64_t n = (uint64_t)(x * x) + (uint64_t)(y * y);
    double off;

    if (!(got > 0 && of <= 0) && !(got < 0 && of >= 0) && is_unit((uint64_t)size, of, n, &off))
        tally_right(t, off, x, y);
    else
        tally_wrong(t, fabs((double)got - 0x1p16 * (double)of / sqrt((double)n)), x, y, got,
                    oracle_unit(of, first ? y : x));
}

static void check_unit(struct tally *t, int64_t x, int64_t y)
{
    fx ux, uy;

    trig_normalise((fx)x, (fx)y, &ux, &uy);
    check_part(t, ux, x, y, true);
    check_part(t, uy, x, y, false);
}

static void check_unit_in(struct tally *t, int64_t x, int64_t y, uint32_t position)
{
    int64_t a = position & 1 ? y : x, b = position & 1 ? x : y;

    a = position & 2 ? -a : a;
    b = position & 4 ? -b : b;
    if (a <= FX_MAX && b <= FX_MAX && a >= FX_MIN && b >= FX_MIN)
        check_unit(t, a, b);
}

static void check_unit_mirrored(struct tally *t, int64_t x, int64_t y)
{
    for (uint32_t i = 0; i < 8; i++)
        check_unit_in(t, x, y, i);
}

/* The ray with a part of odd / 2^17: all convergents, their largest multiples, and sums of two with small factors. */
static void unit_ray(uint64_t chunk, struct tally *t, uint64_t *random)
{
    uint32_t odd = 2 * (uint32_t)chunk + 1;
    u128 side = (u128)odd << 77, other = oracle_other_side(odd);

    for (struct walk w = side < other ? walk_from(side, other) : walk_from(other, side);
         walk_next(&w, (uint64_t)LONGEST);) {
        int64_t most = LONGEST / (int64_t)w.d;

        check_unit_mirrored(t + UNIT, (int64_t)w.n, (int64_t)w.d);
        check_unit_in(t + UNIT, most * (int64_t)w.n, most * (int64_t)w.d, 6);
        for (int i = 0; i < 16; i++) {
            uint64_t z = numbers_random(random), f = z % 256 + 1, g = z >> 8 & 255 >> (z >> 16) % 8;

            if (f * w.d + g * w.d0 <= (uint64_t)LONGEST)
                check_unit_in(t + UNIT, (int64_t)(f * w.n + g * w.n0), (int64_t)(f * w.d + g * w.d0),
                              (uint32_t)(z >> 61));
        }
    }
}

static void dense_units(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (int64_t y = 0; y <= (int64_t)chunk + 1; y++)
        check_unit_mirrored(&t[UNIT], y, (int64_t)chunk + 1);
}

static void any_unit(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        int32_t x = prove_scaled(random) | 1;

        check_unit(&t[UNIT], prove_scaled(random), x);
        check_unit(&t[UNIT], (int32_t)numbers_random(random) | 1, (int32_t)numbers_random(random));
        check_unit(&t[UNIT], x, (int32_t)numbers_random(random));
    }
}

static void unit_edges(uint64_t chunk, struct tally *t, uint64_t *random)
{
    fx zero[2] = { 5, 5 };

    (void)random;
    trig_normalise(0, 0, &zero[0], &zero[1]);
    for (uint64_t i = 0; i < COUNT(EDGES); i++)
        if (EDGES[i] || EDGES[chunk])
            check_unit(&t[UNIT], EDGES[chunk], EDGES[i]);
        else if (zero[0] == 0 && zero[1] == 0)
            tally_right(&t[UNIT], 0.5, 0, 0);
        else
            tally_wrong(&t[UNIT], 0, 0, 0, zero[0], 0);
}

static void units_by_mpfr(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t x = prove_scaled(random) | 1, y = prove_scaled(random), want = oracle_unit(x, y);
    fx ux, uy;

    (void)chunk;
    trig_normalise((fx)x, (fx)y, &ux, &uy);
    t[UNIT].by_mpfr++;
    if (ux == want)
        tally_right(&t[UNIT], 0.5, x, y);
    else
        tally_wrong(&t[UNIT], fabs((double)(ux - want)), x, y, ux, want);
}

static void prove_units(void)
{
    prove_hard(UNIT, "trig_normalise", check_unit_mirrored);
    prove_phase(unit_edges, COUNT(EDGES), COUNT(EDGES));
    prove_phase(unit_ray, 1 << 16, 400);
    prove_phase(dense_units, 1 << 12, 4);
    prove_phase(any_unit, 1 << 18, 40);
    prove_phase(units_by_mpfr, 100000, 1000);
    prove_line(UNIT, "trig_normalise",
               "hard: the vectors nearest to the 65536 rays where a component is halfway, found with continued "
               "fractions, and sums of two of them; dense, random, extremes; a sample with MPFR");
}

int main(int argc, char **argv)
{
    static const struct proof PROOFS[] = {
        { "trig_atan2", prove_turns },
        { "trig_normalise", prove_units },
    };

    return prove_main(argc, argv, PROOFS, COUNT(PROOFS));
}

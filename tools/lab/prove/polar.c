/*
 * polar.c - proves trig_polar, and looks at trig_stride: both parts correctly rounded for every speed and direction.
 *
 * A part is +-m c, where m <= 2^31 is the speed's magnitude and c the cosine of u angs, u in a quarter turn: 2^30 + 1
 * values c. trig_polar is right by its error bounds unless m c is near halfway between two whole numbers, and then it
 * decides with 128 bits. That of the guess in doubles is checked in every direction. What then has to be shown is that
 * the 128 bits suffice for the nearest there is. m c near halfway means 2mc near an odd number. Wherever
 * |2mc - odd| < 1/(4m), which is 2^-33 at most, odd/2m is a convergent of the continued fraction of c, or an odd
 * multiple of one (Legendre). So all of them are found by walking the continued fractions of all c as far as
 * denominators of 2^32; each m found within 2^-33 of halfway is tried.
 *
 * Oracle: c to 124 bits, so m c to 2^-93; what is nearer to halfway than 2^-90 is decided by MPFR.
 *
 * trig_stride, the same for lengths to 2^48, is held to what its header says, for random arguments.
 */
#include "../../../src/base/trig.h"
#include "../../../src/base/trig_guess.h"
#include "oracle.h"

enum { POLAR, STRIDE, GUESS, CHUNK = 1 << 10 };
static const uint64_t SPEED_MOST = (uint64_t)1 << 31;
static const ang QUARTER = 0x40000000;

/* m c, c in units of 2^-128, rounded; `off` is its distance from halfway. c is the cosine of u angs. */
static int64_t rounded_product(uint64_t m, u128 c, uint32_t u, double *off, uint64_t *by_mpfr)
{
    u128 product = (u128)m * (uint64_t)(c >> 64) + ((u128)m * (uint64_t)c >> 64); /* in units of 2^-64 */
    uint64_t whole = (uint64_t)(product >> 64), rest = (uint64_t)product;
    i128 over;

    *off = fabs((double)(int64_t)(rest ^ (uint64_t)1 << 63)) * 0x1p-64;
    if (*off > 0x1p-48)
        return (int64_t)(whole + (rest >> 63));
    over = (i128)(2 * (u128)m * c); /* modulo one: 2mc less 2 whole + 1 */
    *off = oracle_double((u128)(over < 0 ? -over : over)) / 2;
    if (*off > (double)m * 0x1p-121)
        return (int64_t)whole + (over > 0);
    ++*by_mpfr;
    return (int64_t)whole + (oracle_sine_side(2 * u, true, m, 2 * whole + 1) > 0);
}

static int64_t clamped(int64_t v)
{
    return v > FX_MAX ? FX_MAX : v < FX_MIN ? FX_MIN : v;
}

/* One part: got, from the magnitude m and c, the cosine of u, with a sign. */
static void check_part(struct tally *t, uint64_t m, u128 c, uint32_t u, bool minus, int64_t got, int64_t speed, ang dir)
{
    double off;
    int64_t r = rounded_product(m, c, u, &off, &t->by_mpfr), want = clamped(minus ? -r : r);

    if (got == want)
        tally_right(t, off, speed, dir);
    else
        tally_wrong(t, want == r || want == -r ? 0.5 + off : fabs((double)(got - want)), speed, dir, got, want);
}

static void check_polar(struct tally *t, int64_t speed, int64_t b)
{
    ang dir = (ang)b;
    uint32_t u = dir & (QUARTER - 1), q = dir >> 30;
    uint64_t m = (uint64_t)(speed < 0 ? -speed : speed);
    u128 s, c;
    fx vx, vy;

    oracle_circle(2 * u, &s, &c);
    trig_polar((fx)speed, dir, &vx, &vy);
    if (q & 1) { /* the vector of u, turned by a quarter: cosine -s, sine c */
        check_part(t, m, s, QUARTER - u, (q == 1) != (speed < 0), vx, speed, dir);
        check_part(t, m, c, u, (q == 3) != (speed < 0), vy, speed, dir);
    } else {
        check_part(t, m, c, u, (q == 2) != (speed < 0), vx, speed, dir);
        check_part(t, m, s, QUARTER - u, (q == 2) != (speed < 0), vy, speed, dir);
    }
}

/* In one of sixteen positions, or all: u to either side of an axis, forwards or backwards. */
static void check_position(struct tally *t, uint64_t m, uint32_t u, uint32_t i)
{
    int64_t speed = i & 8 ? (int64_t)m : -(int64_t)m;

    if (speed <= FX_MAX)
        check_polar(t, speed, (int64_t)(ang)((i & 3) * QUARTER + (i & 4 ? u : 0 - u)));
}

static void check_positions(struct tally *t, int64_t speed, int64_t dir)
{
    for (uint32_t i = 0; i < 16; i++)
        check_position(t, (uint64_t)(speed < 0 ? -speed : speed), (uint32_t)dir & (QUARTER - 1), i);
}

/* The speeds m for which 2mc is within 2^-32 of an odd number, c being the cosine of u. */
static void check_convergents(struct tally *t, uint32_t u, uint64_t *random)
{
    const u128 one = (u128)1 << 94, near = one >> 32;
    u128 s, c;

    oracle_circle(2 * u, &s, &c);
    for (struct walk w = walk_from((c >> 34) + (c >> 33 & 1), one); walk_next(&w, 2 * SPEED_MOST);) {
        if (w.d % 2 || w.rest > near)
            continue;
        for (uint64_t odd = 1; odd * w.d <= 2 * SPEED_MOST && odd * w.rest <= near; odd += 2)
            if (odd * w.rest < one >> 60)
                check_positions(t, (int64_t)(odd * w.d / 2), u);
            else
                check_position(t, odd * w.d / 2, u, (uint32_t)(numbers_random(random) >> 60));
    }
}

static void convergents(uint64_t chunk, struct tally *t, uint64_t *random)
{
    for (uint32_t i = 0; i < CHUNK; i++)
        check_convergents(&t[POLAR], (uint32_t)chunk * CHUNK + i, random);
}

static void any(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        int32_t speed = prove_scaled(random);

        check_polar(&t[POLAR], speed, (int64_t)(numbers_random(random) >> 32));
        check_polar(&t[POLAR], (int32_t)numbers_random(random), (int64_t)((numbers_random(random) & 0x1ff) << 23));
    }
}

/* The greatest magnitude, which is clamped along an axis. */
static void fastest(uint64_t chunk, struct tally *t, uint64_t *random)
{
    for (uint32_t i = 0; i < CHUNK; i++)
        check_position(&t[POLAR], SPEED_MOST - (i & 1), (uint32_t)chunk * CHUNK + i,
                       (uint32_t)(numbers_random(random) >> 60));
}

static void axes(uint64_t chunk, struct tally *t, uint64_t *random)
{
    static const int64_t SPEED[] = { FX_MIN, FX_MIN + 1, -FX_ONE, -1, 0, 1, FX_ONE, FX_MAX };

    (void)random;
    for (uint32_t i = 0; i < COUNT(SPEED); i++)
        for (uint32_t k = 0; k < 256; k++)
            check_polar(&t[POLAR], SPEED[i], (int64_t)(ang)((uint32_t)chunk * (QUARTER / 2) + k - 128));
}

static void by_mpfr(uint64_t chunk, struct tally *t, uint64_t *random)
{
    ang dir = (ang)numbers_random(random);
    int64_t speed = prove_scaled(random), want[2];
    fx got[2];

    (void)chunk;
    trig_polar((fx)speed, dir, &got[0], &got[1]);
    for (int i = 0; i < 2; i++) {
        want[i] = clamped(oracle_sine(dir, i == 0, speed));
        t[POLAR].by_mpfr++;
        if (got[i] == want[i])
            tally_right(&t[POLAR], 0.5, speed, dir);
        else
            tally_wrong(&t[POLAR], fabs((double)(got[i] - want[i])), speed, dir, got[i], want[i]);
    }
}

static void prove_polar(void)
{
    oracle_open();
    prove_hard(POLAR, "trig_polar", check_positions);
    prove_phase(axes, 8, 8);
    prove_phase(convergents, QUARTER / CHUNK, 40);
    prove_phase(any, 1 << 17, 40);
    prove_phase(fastest, QUARTER / CHUNK, 20);
    prove_phase(by_mpfr, 100000, 1000);
    prove_line(POLAR, "trig_polar",
               "hard: every speed and each of 2^30 cosines whose product is within 2^-33 of halfway, found with "
               "continued fractions; the axes, random, the greatest speed at all angles; a sample with MPFR");
}

/* The part along one axis of the point at a distance, both of them signed by q. */
static int64_t point(int64_t length, bool minus, u128 c, uint32_t u, double *least, uint64_t *by_mpfr)
{
    double off;
    int64_t r = rounded_product((uint64_t)(length < 0 ? -length : length), c, u, &off, by_mpfr);

    *least = off < *least ? off : *least;
    return minus != (length < 0) ? -r : r;
}

static void check_stride(struct tally *t, int64_t from, int64_t to, ang dir)
{
    uint32_t u = dir & (QUARTER - 1), q = dir >> 30;
    u128 part[2];
    int64_t got[2];

    oracle_circle(2 * u, &part[1], &part[0]);
    trig_stride(from, to, dir, &got[0], &got[1]);
    for (uint32_t i = 0; i < 2; i++) { /* x, y */
        uint32_t which = i ^ (q & 1);
        bool minus = i ? q >= 2 : q == 1 || q == 2;
        double off = 0.5;
        int64_t want = point(to, minus, part[which], which ? QUARTER - u : u, &off, &t->by_mpfr) -
                       point(from, minus, part[which], which ? QUARTER - u : u, &off, &t->by_mpfr);

        if (got[i] == want || off < 0x1p-70)
            tally_right(t, off, to, dir);
        else
            tally_wrong(t, fabs((double)(got[i] - want)), to, dir, got[i], want);
    }
}

static void any_stride(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        uint64_t z = numbers_random(random);
        int64_t from = (int64_t)numbers_random(random) >> 15 >> (z & 31);
        int64_t to = z & 32 ? from + prove_scaled(random) : (int64_t)numbers_random(random) >> 15 >> (z >> 6 & 31);

        check_stride(&t[STRIDE], from >> 1, to >> 1, (ang)(z >> 32));
    }
}

static void prove_stride(void)
{
    oracle_open();
    prove_phase(any_stride, 1 << 16, 40);
    prove_line(STRIDE, "trig_stride", "random lengths up to 2^48; positions within 2^-70 of halfway are not checked");
}

#ifndef FX_INTEGER
/* |guess - exact| in steps of 2^-41: of the greatest speed's velocity, that is 2^-10 units. */
static double guess_error(double guess, u128 exact, bool minus)
{
    int64_t q = (int64_t)(exact >> 66), off = (int64_t)(guess * 0x1p62) - (minus ? -q : q);

    return fabs((double)off) * 0x1p-21;
}

/* Both parts must be within a third of a step, the rounding of the product, 2^-13 of it, included. */
static void check_guess(struct tally *t, ang dir, u128 cosine, u128 sine)
{
    uint32_t q = dir >> 30;
    double c, s, off;

    trig_cos_sin_guess(dir, &c, &s);
    off = fmax(guess_error(c, q & 1 ? sine : cosine, q == 1 || q == 2), guess_error(s, q & 1 ? cosine : sine, q >= 2));
    if (off + 0x1p-13 < 1.0 / 3)
        tally_right(t, 0.5 - off, dir, 0);
    else
        tally_wrong(t, off, dir, 0, (int64_t)(off * 1000), 333);
}

static void guesses(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (uint32_t i = 0; i < CHUNK; i++) {
        uint32_t u = (uint32_t)chunk * CHUNK + i;
        u128 s, c;

        oracle_circle(2 * u, &s, &c);
        for (uint32_t q = 0; q < 4; q++)
            check_guess(&t[GUESS], q * QUARTER + u, c, s);
    }
}

static void prove_guess(void)
{
    oracle_open();
    prove_phase(guesses, QUARTER / CHUNK, 4000);
    prove_line(GUESS, "trig_guess",
               "all directions; an ulp is 2^-41 and the error must be below 1/3; compared with sums of two angles of "
               "128-bit tables");
}
#endif

int main(int argc, char **argv)
{
    static const struct proof PROOFS[] = {
        { "trig_polar", prove_polar },
        { "trig_stride", prove_stride },
#ifndef FX_INTEGER
        { "trig_guess", prove_guess },
#endif
    };

    return prove_main(argc, argv, PROOFS, COUNT(PROOFS));
}

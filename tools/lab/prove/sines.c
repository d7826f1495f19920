/*
 * sines.c - proves trig_sin, trig_cos, trig_sin30 and trig_cos30, for all 2^32 angles.
 *
 * Oracle: sine and cosine of the angle's part within a quarter turn, off by less than 2^-124; the other three quarters
 * have the same two up to sign and order. That decides unless a value is within 2^-88 of halfway; then MPFR does.
 */
#include "../../../src/base/trig.h"
#include "oracle.h"

enum { SIN, COS, SIN30, COS30, CHUNK = 1 << 12 };
static const char *const NAMES[] = { "trig_sin", "trig_cos", "trig_sin30", "trig_cos30" };

/* What a value rounds to. */
struct nearest {
    int64_t r;
    double off; /* how far the value is from halfway, ulp */
    u128 value; /* exact to 2^-124 */
    int bits;
    bool by_mpfr;
};

/* v, the sine or cosine of u angs, rounded to so many bits. */
static struct nearest nearest_of(u128 v, int bits, uint32_t u, bool cosine)
{
    const u128 unit = (u128)1 << (128 - bits), half = unit >> 1;
    u128 rest = v & (unit - 1), off = rest < half ? half - rest : rest - half;
    uint64_t whole = (uint64_t)(v >> (128 - bits));
    struct nearest n = { 0, ldexp(oracle_double(off), bits), v, bits, off < (u128)1 << 40 };
    bool up = n.by_mpfr ? oracle_sine_side(2 * u, cosine, (uint64_t)1 << bits, 2 * whole + 1) > 0 : rest >= half;

    n.r = (int64_t)(whole + up);
    return n;
}

/* An angle whose sine or cosine is n, or -n if `back`. */
static inline void check(struct tally *t, int64_t r, const struct nearest *n, bool back, ang a)
{
    t->by_mpfr += n->by_mpfr;
    if (r == (back ? -n->r : n->r))
        tally_right(t, n->off, a, 0);
    else
        tally_wrong(t, fabs((double)(back ? -r : r) - ldexp(oracle_double(n->value), n->bits)), a, 0, r,
                    back ? -n->r : n->r);
}

/* The angles u, u + a quarter, u + a half, u + three quarters: sines s, c, -s, -c. */
static void check_four(struct tally *t, uint32_t u)
{
    static const uint32_t QUARTER = 0x40000000;
    u128 s, c;

    oracle_circle(2 * u, &s, &c);

    struct nearest low[2] = { nearest_of(s, 16, u, false), nearest_of(c, 16, u, true) };
    struct nearest high[2] = { nearest_of(s, 30, u, false), nearest_of(c, 30, u, true) };

    for (uint32_t q = 0; q < 4; q++) {
        ang a = u + q * QUARTER;
        bool back = q >= 2, swap = q & 1, cos_back = q == 1 || q == 2;

        check(&t[SIN], trig_sin(a), &low[swap], back, a);
        check(&t[COS], trig_cos(a), &low[!swap], cos_back, a);
        check(&t[SIN30], trig_sin30(a), &high[swap], back, a);
        check(&t[COS30], trig_cos30(a), &high[!swap], cos_back, a);
    }
}

static void all(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (uint32_t i = 0; i < CHUNK; i++)
        check_four(t, (uint32_t)chunk * CHUNK + i);
}

/* Angles near the axes and the middles of the quarters, for the sampled form. */
static void edges(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (uint32_t i = 0; i < 64; i++)
        check_four(t, ((uint32_t)chunk * 0x20000000 + i - 32) & 0x3fffffff);
}

/* Some angles from each 512th of a quarter turn, for tables have cells. */
static void everywhere(uint64_t chunk, struct tally *t, uint64_t *random)
{
    for (int i = 0; i < 64; i++)
        check_four(t, (uint32_t)chunk << 21 | (uint32_t)(numbers_random(random) >> 43));
}

static void by_mpfr(uint64_t chunk, struct tally *t, uint64_t *random)
{
    ang a = (ang)numbers_random(random);
    int64_t r[4] = { trig_sin(a), trig_cos(a), trig_sin30(a), trig_cos30(a) };

    (void)chunk;
    for (int i = 0; i < 4; i++) {
        int64_t want = oracle_sine(a, i & 1, i < 2 ? 1 << 16 : 1 << 30);

        t[i].by_mpfr++;
        if (r[i] == want)
            tally_right(&t[i], 0.5, a, 0);
        else
            tally_wrong(&t[i], fabs((double)(r[i] - want)), a, 0, r[i], want);
    }
}

static void hard(struct tally *t, int64_t a, int64_t unused)
{
    (void)unused;
    check_four(t, (uint32_t)a & 0x3fffffff);
}

static void prove_sines(void)
{
    oracle_open();
    for (int i = 0; i < 4; i++)
        prove_hard(SIN, NAMES[i], hard);
    prove_phase(edges, 2, 2);
    prove_phase(everywhere, 512, 512);
    prove_phase(all, 1 << 18, 40);
    prove_phase(by_mpfr, 100000, 1000);
    for (int i = 0; i < 4; i++)
        prove_line(i, NAMES[i], "all angles, compared with sums of two angles of 128-bit tables; a sample with MPFR");
}

int main(int argc, char **argv)
{
    static const struct proof PROOFS[] = { { "sines", prove_sines } };

    return prove_main(argc, argv, PROOFS, COUNT(PROOFS));
}

/*
 * oracle.c - the oracle's tables and slow decisions, by MPFR.
 *
 * Each table is made of two small ones, whose entries are products in 256 bits: sin and cos of some hundred angles by
 * mpfr_sin_cos, the rest by sin(a+b) and cos(a+b).
 */
#include <gmp.h>
#include <mpfr.h>
#include "oracle.h"

enum { BITS = 256, SLOW_BITS = 512, STEP = 8 };

struct oracle_high oracle_high[ORACLE_HIGH];
struct oracle_low oracle_low[1 << ORACLE_LOW];

/* sin and cos of h * 2^-33 turns. */
static void sin_cos(mpfr_t s, mpfr_t c, uint64_t h)
{
    mpfr_t x;

    mpfr_init2(x, mpfr_get_prec(s) + 64);
    mpfr_const_pi(x, MPFR_RNDN);
    mpfr_mul_ui(x, x, (unsigned long)h, MPFR_RNDN);
    mpfr_div_2ui(x, x, 32, MPFR_RNDN);
    mpfr_sin_cos(s, c, x, MPFR_RNDN);
    mpfr_clear(x);
}

static u128 whole(mpz_t z)
{
    u128 v = 0;

    for (int i = 1; i >= 0; i--) {
        mpz_t part;

        mpz_init(part);
        mpz_fdiv_q_2exp(part, z, (unsigned long)(64 * i));
        mpz_fdiv_r_2exp(part, part, 64);
        v = v << 64 | mpz_get_ui(part);
        mpz_clear(part);
    }
    return v;
}

/* 0 <= v <= 1 as a fraction of 128 bits. */
static u128 fraction(mpfr_t v, mpz_t z)
{
    mpfr_mul_2ui(v, v, 128, MPFR_RNDN);
    mpfr_get_z(z, v, MPFR_RNDN);
    return mpz_sizeinbase(z, 2) > 128 ? ~(u128)0 : whole(z);
}

/* Puts sin and cos of i << shift half angs, i < n, where `put` says. */
static void fill(int n, int shift, void (*put)(int, mpfr_t, mpfr_t, mpz_t))
{
    mpfr_t fine[1 << STEP][2], s, c, sine, cosine, t;
    mpz_t z;

    mpz_init(z);
    mpfr_inits2(BITS, s, c, sine, cosine, t, (mpfr_ptr)0);
    for (int i = 0; i < 1 << STEP; i++) {
        mpfr_inits2(BITS, fine[i][0], fine[i][1], (mpfr_ptr)0);
        sin_cos(fine[i][0], fine[i][1], (uint64_t)i << shift);
    }
    for (int i = 0; i < n; i++) {
        mpfr_t *f = fine[i & ((1 << STEP) - 1)];

        if (f == fine[0])
            sin_cos(s, c, (uint64_t)i << shift);
        mpfr_mul(sine, s, f[1], MPFR_RNDN);
        mpfr_mul(t, c, f[0], MPFR_RNDN);
        mpfr_add(sine, sine, t, MPFR_RNDN);
        mpfr_mul(cosine, c, f[1], MPFR_RNDN);
        mpfr_mul(t, s, f[0], MPFR_RNDN);
        mpfr_sub(cosine, cosine, t, MPFR_RNDN);
        put(i, sine, cosine, z);
    }
    for (int i = 0; i < 1 << STEP; i++)
        mpfr_clears(fine[i][0], fine[i][1], (mpfr_ptr)0);
    mpfr_clears(s, c, sine, cosine, t, (mpfr_ptr)0);
    mpz_clear(z);
}

static void put_high(int i, mpfr_t s, mpfr_t c, mpz_t z)
{
    if (mpfr_sgn(c) < 0) /* at the quarter's end, by 2^-256 */
        mpfr_set_zero(c, 1);
    oracle_high[i] = (struct oracle_high){ fraction(s, z), fraction(c, z) };
}

static void put_low(int i, mpfr_t s, mpfr_t c, mpz_t z)
{
    mpfr_ui_sub(c, 1, c, MPFR_RNDN);
    oracle_low[i] = (struct oracle_low){ fraction(s, z), fraction(c, z) };
}

void oracle_open(void)
{
    fill(ORACLE_HIGH, ORACLE_LOW, put_high);
    fill(1 << ORACLE_LOW, 0, put_low);
}

void oracle_thread_ends(void)
{
    mpfr_free_cache();
}

int oracle_sine_side(uint32_t h, bool cosine, uint64_t m, uint64_t n)
{
    mpfr_t s, c;
    int side;

    mpfr_inits2(SLOW_BITS, s, c, (mpfr_ptr)0);
    sin_cos(s, c, h);
    mpfr_mul_ui(s, cosine ? c : s, 2 * m, MPFR_RNDN);
    side = mpfr_cmp_ui(s, n);
    mpfr_clears(s, c, (mpfr_ptr)0);
    return side;
}

int oracle_ray_side(uint64_t h, int64_t x, int64_t y)
{
    mpfr_t s, c;
    int side;

    mpfr_inits2(SLOW_BITS, s, c, (mpfr_ptr)0);
    sin_cos(s, c, h);
    mpfr_mul_si(c, c, y, MPFR_RNDN);
    mpfr_mul_si(s, s, x, MPFR_RNDN);
    side = mpfr_cmp(c, s);
    mpfr_clears(s, c, (mpfr_ptr)0);
    return side;
}

/* v, which goes away, rounded to a whole number. */
static int64_t rounded(mpfr_t v)
{
    int64_t r;

    mpfr_rint(v, v, MPFR_RNDN);
    r = mpfr_get_si(v, MPFR_RNDN);
    mpfr_clear(v);
    return r;
}

int64_t oracle_sqrt(int64_t n)
{
    mpfr_t v;

    mpfr_init2(v, BITS);
    mpfr_set_si_2exp(v, n, 16, MPFR_RNDN);
    mpfr_sqrt(v, v, MPFR_RNDN);
    return rounded(v);
}

int64_t oracle_rsqrt(int64_t n)
{
    mpfr_t v;

    mpfr_init2(v, BITS);
    mpfr_set_si(v, n, MPFR_RNDN);
    mpfr_rec_sqrt(v, v, MPFR_RNDN);
    mpfr_mul_2ui(v, v, 24, MPFR_RNDN);
    return rounded(v);
}

static void set_pair(mpfr_t a, mpfr_t b, int64_t x, int64_t y)
{
    mpfr_inits2(BITS, a, b, (mpfr_ptr)0);
    mpfr_set_si(a, x, MPFR_RNDN);
    mpfr_set_si(b, y, MPFR_RNDN);
}

int64_t oracle_hypot(int64_t x, int64_t y)
{
    mpfr_t a, b;

    set_pair(a, b, x, y);
    mpfr_hypot(a, a, b, MPFR_RNDN);
    mpfr_clear(b);
    return rounded(a);
}

int64_t oracle_sine(uint32_t ang, bool cosine, int64_t scale)
{
    mpfr_t s, c;

    mpfr_inits2(BITS, s, c, (mpfr_ptr)0);
    sin_cos(s, c, (uint64_t)ang * 2);
    if (cosine)
        mpfr_swap(s, c);
    mpfr_clear(c);
    if (ang << 2 == 0) /* exact: 0 or 1 either way */
        mpfr_rint(s, s, MPFR_RNDN);
    mpfr_mul_si(s, s, scale, MPFR_RNDN);
    return rounded(s);
}

int64_t oracle_atan2(int64_t y, int64_t x)
{
    mpfr_t a, b;

    set_pair(a, b, y, x);
    mpfr_atan2(a, a, b, MPFR_RNDN);
    mpfr_const_pi(b, MPFR_RNDN);
    mpfr_div(a, a, b, MPFR_RNDN);
    mpfr_clear(b);
    mpfr_mul_2ui(a, a, 31, MPFR_RNDN);
    return rounded(a);
}

int64_t oracle_unit(int64_t x, int64_t y)
{
    mpfr_t a, b;

    set_pair(a, b, x, y);
    mpfr_hypot(b, a, b, MPFR_RNDN);
    mpfr_div(a, a, b, MPFR_RNDN);
    mpfr_clear(b);
    mpfr_mul_2ui(a, a, 16, MPFR_RNDN);
    return rounded(a);
}

int64_t oracle_ratio(int64_t a, int64_t b, int64_t c, int64_t d)
{
    mpfr_t v;

    mpfr_init2(v, BITS);
    mpfr_set_si(v, a, MPFR_RNDN);
    mpfr_mul_si(v, v, b, MPFR_RNDN);
    mpfr_add_si(v, v, c, MPFR_RNDN);
    mpfr_div_si(v, v, d, MPFR_RNDN);
    return rounded(v);
}

u128 oracle_other_side(uint32_t odd)
{
    mpz_t z;
    u128 v;

    mpz_init_set_ui(z, ((unsigned long)1 << 34) - (unsigned long)odd * odd);
    mpz_mul_2exp(z, z, 2 * 77);
    mpz_sqrt(z, z);
    v = whole(z);
    mpz_clear(z);
    return v;
}

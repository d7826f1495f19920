/*
 * truth.c - see truth.h. A number is the sum of two doubles, the lower one less than half the last bit of the higher
 * (Dekker, "A floating-point technique for extending the available precision", 1971), which makes 106 bits.
 */
#include "truth.h"
#include <math.h>
#include <stdbool.h>

struct pair {
    double hi, lo;
};

static const struct pair EIGHTH = { 0.7853981633974483, 3.061616997868383e-17 };      /* pi / 4 */
static const struct pair PER_RADIAN = { 683565275.5764316, -4.2259636374233396e-08 }; /* 2^32 / (2 pi) */

/* a + b exactly. */
static struct pair sum(double a, double b)
{
    double s = a + b, t = s - a;

    return (struct pair){ s, (a - (s - t)) + (b - t) };
}

/* a * b exactly. */
static struct pair product(double a, double b)
{
    const double half = 134217729; /* 2^27 + 1 cuts 53 bits in two */
    double p = a * b, ca = half * a, cb = half * b, ah = ca - (ca - a), bh = cb - (cb - b), al = a - ah, bl = b - bh;

    return (struct pair){ p, ((ah * bh - p) + ah * bl + al * bh) + al * bl };
}

static struct pair add(struct pair a, struct pair b)
{
    struct pair h = sum(a.hi, b.hi), l = sum(a.lo, b.lo);

    h = sum(h.hi, h.lo + l.hi);
    return sum(h.hi, h.lo + l.lo);
}

static struct pair negative(struct pair a)
{
    return (struct pair){ -a.hi, -a.lo };
}

static struct pair mul(struct pair a, struct pair b)
{
    struct pair p = product(a.hi, b.hi);

    return sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

static struct pair quotient(struct pair a, struct pair b)
{
    double q = a.hi / b.hi;
    struct pair rest = add(a, negative(mul(b, (struct pair){ q, 0 })));
    double more = rest.hi / b.hi;

    rest = add(rest, negative(mul(b, (struct pair){ more, 0 })));
    return add(sum(q, more), (struct pair){ rest.hi / b.hi, 0 });
}

static struct pair whole(int64_t v)
{
    return sum((double)(v >> 32) * 4294967296.0, (double)(v & 0xffffffff));
}

static struct pair root(struct pair a)
{
    double r = sqrt(a.hi);

    if (r == 0)
        return (struct pair){ 0, 0 };
    struct pair rest = add(a, negative(product(r, r)));
    return sum(r, rest.hi / (2 * r));
}

static struct truth truth(struct pair v)
{
    double n = floor(v.hi + 0.5), rest = (v.hi - n) + v.lo;

    if (rest > 0.5 || (rest == 0.5 && fmod(n, 2) != 0))
        n += 1, rest -= 1;
    if (rest < -0.5 || (rest == -0.5 && fmod(n, 2) != 0))
        n -= 1, rest += 1;
    return (struct truth){ (int64_t)n, rest };
}

static struct pair scaled(struct pair v, double power_of_2)
{
    return (struct pair){ v.hi * power_of_2, v.lo * power_of_2 };
}

/* Taylor's series, |x| <= 1. */
static void circle(struct pair x, struct pair *cosine, struct pair *sine)
{
    struct pair term = { 1, 0 }, parts[2] = { { 1, 0 }, { 0, 0 } };

    for (int i = 1; fabs(term.hi) > 1e-34; i++) {
        term = quotient(mul(term, x), (struct pair){ i, 0 });
        parts[i & 1] = add(parts[i & 1], i & 2 ? negative(term) : term);
    }
    *cosine = parts[0];
    *sine = parts[1];
}

static struct pair square(int32_t x, int32_t y)
{
    return add(product(x, x), product(y, y));
}

struct truth truth_mul(int32_t a, int32_t b)
{
    return truth(scaled(product(a, b), 1 / 65536.0));
}

struct truth truth_div(int32_t a, int32_t b)
{
    return truth(quotient((struct pair){ a * 65536.0, 0 }, (struct pair){ b, 0 }));
}

struct truth truth_sqrt(int32_t x)
{
    return truth(root((struct pair){ x * 65536.0, 0 }));
}

struct truth truth_rsqrt(int32_t x)
{
    return truth(quotient((struct pair){ 16777216, 0 }, root((struct pair){ x, 0 })));
}

struct truth truth_hypot(int32_t x, int32_t y)
{
    return truth(root(square(x, y)));
}

struct truth truth_lerp(int32_t a, int32_t b, int32_t t)
{
    return truth(add((struct pair){ a, 0 }, scaled(product((double)b - a, t), 1 / 65536.0)));
}

struct truth truth_sin(int64_t size, uint32_t a)
{
    uint32_t u = a & 0x7fffffff;
    struct pair c, s;

    u = u > 0x40000000 ? 0x80000000 - u : u;
    bool far = u > 0x20000000; /* from the end of the quarter, by the cosine */
    circle(mul(EIGHTH, (struct pair){ (far ? 0x40000000 - u : u) / 536870912.0, 0 }), &c, &s);
    s = mul(far ? c : s, scaled(whole(size), 1 / 65536.0));
    return truth(a >> 31 ? negative(s) : s);
}

/* atan(t) for 0 <= t <= 1, to 50 bits. */
static double arc(double t)
{
    double q = t > 0.41421356 ? (t - 1) / (t + 1) : t, z = -q * q, series = 0;

    for (int k = 47; k > 0; k -= 2)
        series = series * z + 1.0 / k;
    return q * series + (t > 0.41421356 ? EIGHTH.hi : 0);
}

struct truth truth_atan2(int32_t y, int32_t x)
{
    double ax = fabs((double)x), ay = fabs((double)y), low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;
    double guess = arc(low / high);
    struct pair c, s, n = { low, 0 }, d = { high, 0 };

    /* the sine of what the guess lacks, over its cosine: about what it lacks, cubed, off that */
    circle((struct pair){ guess, 0 }, &c, &s);
    struct pair lacks = quotient(add(mul(n, c), negative(mul(d, s))), add(mul(d, c), mul(n, s)));
    struct pair a = mul(add((struct pair){ guess, 0 }, lacks), PER_RADIAN);
    if (ax < ay)
        a = add((struct pair){ 1073741824, 0 }, negative(a));
    if (x < 0)
        a = add((struct pair){ 2147483648, 0 }, negative(a));
    if (y < 0)
        a = add((struct pair){ 4294967296, 0 }, negative(a));
    return truth(a);
}

struct truth truth_unit(int32_t x, int32_t y)
{
    return truth(quotient((struct pair){ x * 65536.0, 0 }, root(square(x, y))));
}

struct truth truth_degrees(double deg)
{
    return truth(quotient((struct pair){ deg * 536870912.0, 0 }, (struct pair){ 45, 0 }));
}

/*
 * trig.c - computes a first guess by polynomials and, if the guess is in doubt, decides exactly.
 *
 * Sines in Q15.16 come from table-driven quadratics (trig_tables.h). The doubtful ones, and all sines in Q30, come from
 * a series: fold the angle to an eighth of a turn, u in [0, 2^29], and evaluate in 64-bit fractions; the error is below
 * 2^-62 of one. The polynomials in t = (u / 2^29)^2 interpolate sin(x)/x and (1 - cos x)/x^2 at the Chebyshev nodes,
 * within 2^-69 and 2^-73. Rounded to 30 or 16 bits, the result is correct for all 2^32 angles: only few are so near to
 * a tie that the error matters, and each of them was checked.
 *
 * Directions of vectors are guessed in doubles to about 2^-12 of an ang. The guess decides unless it is near halfway
 * between two angs; then 128-bit arithmetic computes on which side of the halfway ray the vector lies. The rays' slopes
 * are irrational, so no vector lies on one. Polar coordinates are guessed to 2^-11 of a unit (trig_guess.h); doubtful
 * ones are computed to 2^-29 from tables and short series (cos_sin_q64), and if that leaves doubt, 128-bit arithmetic
 * decides. Strides start from cos_sin_q64.
 */
#include "trig.h"
#include "trig_guess.h"
#include "trig_tables.h"

/* Returns term - t * sum, one step of Horner's rule. Terms are in units of 2^-(64 + n), to use all 64 bits; n falls by
 * `shift` per step. */
static inline uint64_t horner_step(uint64_t term, uint64_t t, uint64_t sum, int shift)
{
    return term - (fx_mul_high(t, sum) >> shift);
}

/* Returns t = (u / 2^29)^2 in Q64; one is 2^64 - 1. */
static inline uint64_t squared(uint32_t u)
{
    return ((uint64_t)u * u << 6) - (u >> 29);
}

/* Returns the sine of u < 2^29, an eighth of a turn, in Q64. */
static uint64_t eighth_sine(uint32_t u)
{
    uint64_t t = squared(u), sum;

    sum = horner_step(0xf477689770051973, t, 0xb62dc3aea739c886, 8);
    sum = horner_step(0xf183a5a7f982be39, t, sum, 8);
    sum = horner_step(0xa83c1a42e5ec1adc, t, sum, 8);
    sum = horner_step(0x996966731561123c, t, sum, 7);
    sum = horner_step(0xa335e33bad56c907, t, sum, 6);
    sum = horner_step(0xa55de7312df295db, t, sum, 5);
    sum = horner_step(0xc90fdaa22168c235, t, sum, 3);
    return fx_mul_high((uint64_t)u << 35, sum);
}

/* Returns the cosine of u <= 2^29 in Q64; one is 2^64 - 1. */
static uint64_t eighth_cosine(uint32_t u)
{
    uint64_t t = squared(u), sum;

    sum = horner_step(0xdb6f45c74dd0407c, t, 0x8f3a2f2f04fb6540, 8);
    sum = horner_step(0xfce9c384388ca3fc, t, sum, 8);
    sum = horner_step(0xd368f95043648007, t, sum, 8);
    sum = horner_step(0xf0fa83448d74a895, t, sum, 7);
    sum = horner_step(0xaae9e3f1e5ffb798, t, sum, 7);
    sum = horner_step(0x81e0f840dad61d96, t, sum, 6);
    sum = horner_step(0x9de9e64df22ef2d2, t, sum, 4);
    return ~(fx_mul_high(t, sum) >> 1);
}

/* Returns |sin a| in Q64. */
static uint64_t sine(ang a)
{
    uint32_t u = a & 0x7fffffff;

    u = u > ANG_QUARTER ? ANG_HALF - u : u;
    return u < 0x20000000 ? eighth_sine(u) : eighth_cosine(ANG_QUARTER - u);
}

/* Returns -v if `condition`, otherwise v, without a branch, because signs of angles are hard to predict. */
static inline int64_t negate_if(bool condition, int64_t v)
{
    return (v ^ -(int64_t)condition) + condition;
}

/* Returns the magnitude q, in Q64, rounded to `bits` bits, with the sign of sin a. */
static int32_t round_to_bits(uint64_t q, int bits, ang a)
{
    return (int32_t)negate_if(a >> 31, (int64_t)((q >> (64 - bits)) + (q >> (63 - bits) & 1)));
}

/* Returns |v|, without a branch. */
static inline uint32_t magnitude(fx v)
{
    const uint32_t sign = (uint32_t)(v >> 31);

    return ((uint32_t)v ^ sign) - sign;
}

int32_t trig_sin30(ang a)
{
    return round_to_bits(sine(a), 30, a);
}

int32_t trig_cos30(ang a)
{
    return trig_sin30(a + ANG_QUARTER);
}

/* Returns the sine in Q56 by a quadratic, off by less than 2^29.4, plus half a unit of fx, so that truncating the
 * result to an fx rounds the sine. */
static inline int64_t sine_guess(ang a)
{
    const uint32_t i = a >> 23;
    const int64_t f = a & 0x7fffff;

    return SINE.base[i] + SINE.slope[i] * f + SINE.bend[i] * (f * f >> 23);
}

void trig_cos_sin40(ang a, int64_t *cosine, int64_t *sine)
{
    const int64_t half = (int64_t)1 << 39;

    *cosine = (sine_guess(a + ANG_QUARTER) - half + (1 << 15)) >> 16;
    *sine = (sine_guess(a) - half + (1 << 15)) >> 16;
}

FX_COLD static fx sine_by_series(ang a)
{
    return round_to_bits(sine(a), 16, a);
}

/* The quadratics are off by less than 2^29.4 / 2^40 of a unit; one case in 700 is in doubt, and the series
 * decides it. */
fx trig_sin(ang a)
{
    const uint64_t margin = 800000000;
    const int64_t v = sine_guess(a);

    if (!FX_LIKELY(((uint64_t)v + margin) << 24 > margin << 25))
        return sine_by_series(a);
    return (fx)(v >> 40);
}

fx trig_cos(ang a)
{
    return trig_sin(a + ANG_QUARTER);
}

/* A fraction of 128 bits. */
struct wide {
    uint64_t hi, lo;
};

static struct wide wide_add(struct wide a, struct wide b)
{
    uint64_t lo = a.lo + b.lo;

    return (struct wide){ a.hi + b.hi + (lo < a.lo), lo };
}

static struct wide wide_sub(struct wide a, struct wide b)
{
    return (struct wide){ a.hi - b.hi - (a.lo < b.lo), a.lo - b.lo };
}

/* Returns a * m / 2^64, too low by at most 2^-128. */
static struct wide wide_scale(struct wide a, uint64_t m)
{
    return wide_add((struct wide){ fx_mul_high(a.hi, m), a.hi * m }, (struct wide){ 0, fx_mul_high(a.lo, m) });
}

/* Returns a * b, too low by at most 3 * 2^-128. */
static struct wide wide_mul(struct wide a, struct wide b)
{
    return wide_add(wide_scale(a, b.hi), (struct wide){ 0, fx_mul_high(a.hi, b.lo) });
}

/* Returns a / n, rounded down, n < 2^32. */
static struct wide wide_div(struct wide a, uint32_t n)
{
    uint64_t high = a.hi % n << 32 | a.lo >> 32, low = high % n << 32 | (a.lo & 0xffffffffu);

    return (struct wide){ a.hi / n, (high / n << 32) + low / n };
}

/* Stores cosine and sine of an angle of u half angs, 0 < u <= 2^30 (an eighth of a turn), to 2^-120. Uses Taylor
 * series. */
static void wide_cos_sin(uint32_t u, struct wide *cosine, struct wide *sine)
{
    static const struct wide EIGHTH_TURN = { 0xc90fdaa22168c234, 0xc4c6628b80dc1cd1 }; /* pi / 4 */
    struct wide x = u >> 30 ? EIGHTH_TURN : wide_scale(EIGHTH_TURN, (uint64_t)u << 34);
    struct wide sum[2] = { { 0, 0 }, x }, term = x;

    for (uint32_t i = 2; term.hi | term.lo; i++) {
        term = wide_div(wide_mul(term, x), i);
        sum[i & 1] = i & 2 ? wide_sub(sum[i & 1], term) : wide_add(sum[i & 1], term);
    }
    *cosine = sum[0];
    *sine = sum[1];
}

/*
 * Stores, in Q64, cosine and sine of an angle of u half angs, u <= 2^30 (an eighth of a turn). Takes the last of 513
 * directions (trig_tables.h) that is not beyond u, and rotates it by the rest, r < 2^-9.3. The sine of r is r (1 - r^2
 * (1 - r^2 / 20) / 6), and 1 minus its cosine is r^2 / 2 (1 - r^2 / 12); the omitted terms are below 2^-65. Each result
 * is off by less than 2^3; `scale_rounded` requires less than 2^4. Using only a series would take twice the time.
 */
static inline void cos_sin_q64(uint32_t u, uint64_t *cosine, uint64_t *sine)
{
    const uint64_t *entry = WAY[u >> 21];
    const uint64_t r = fx_mul_high((uint64_t)(u & 0x1fffff) << 43, 0x6487ed5110b461);           /* 2 pi 2^52 */
    const uint64_t square = fx_mul_high(r << 9, r << 9);                                        /* r^2, times 2^18 */
    const uint64_t sixth = 0x2aaaaaaaaaaaaaaa - (fx_mul_high(square, 0x222222222222222) >> 18); /* 1 / 6 - r^2 / 120 */
    const uint64_t sin_r = r - (fx_mul_high(r, fx_mul_high(square, sixth)) >> 18);
    const uint64_t versin_r =
        square - (fx_mul_high(square, fx_mul_high(square, 0x1555555555555555)) >> 18); /* times 2^19 */

    *cosine = entry[0] - fx_mul_high(entry[1], sin_r) - (fx_mul_high(entry[0], versin_r) >> 19);
    *sine = entry[1] + fx_mul_high(entry[0], sin_r) - (fx_mul_high(entry[1], versin_r) >> 19);
}

/*
 * Returns whether n/d is above the tangent of k + 1/2 angs, k < 2^29. No vector with 32-bit coordinates is nearer to
 * such a ray than 2^-90 of its length (make prove), so 120 bits suffice.
 */
FX_COLD static bool is_above_ray_exact(uint32_t n, uint32_t d, uint32_t k)
{
    struct wide c, s;

    wide_cos_sin(2 * k + 1, &c, &s);
    c = wide_scale(c, (uint64_t)n << 32);
    s = wide_scale(s, (uint64_t)d << 32);
    return c.hi > s.hi || (c.hi == s.hi && c.lo > s.lo);
}

/* Like is_above_ray_exact, but first tries the ray from the tables. Each component of that ray is off by less than 2^3,
 * so it decides unless the vector is very close to the ray. */
FX_COLD static bool is_above_ray(uint32_t n, uint32_t d, uint32_t k)
{
    uint64_t c, s;
    int64_t above;

    cos_sin_q64(2 * k + 1, &c, &s);
    above = (int64_t)(fx_mul_high((uint64_t)n << 32, c) - fx_mul_high((uint64_t)d << 32, s));
    return above > 32 || above < -32 ? above > 0 : is_above_ray_exact(n, d, k);
}

#ifdef FX_INTEGER
/* atan(i / 32) in 2^-64 turns. */
static const uint64_t ATAN[33] = {
    0x0000000000000000, 0x0145d7e159046278, 0x028b0d430e589aed, 0x03ceff89ac340906, 0x051111d41ddd9a1b,
    0x0650acb69b4fe3ae, 0x078d3fce842e72ec, 0x08c64325576561a1, 0x09fb385b5ee39e8e, 0x0b2bab954758b68a,
    0x0c57342a84c77619, 0x0d7d7514ea1efdba, 0x0e9e1d24179d5a77, 0x0fb8e6f93f4ca68f, 0x10cd98d1293ee442,
    0x11dc042355a3c0dd, 0x12e4051d9df30866, 0x13e58203d3c358a8, 0x14e06a7aa3c7ddee, 0x15d4b6c4888c7725,
    0x16c266f6edfc1e3e, 0x17a9822cde870c11, 0x188a15bbbca863e4, 0x1964346db496e206, 0x1a37f5c4c419ef33,
    0x1b05754878e5b08c, 0x1bccd1dfdd02723f, 0x1c8e2d3876e8e159, 0x1d49ab3ac8b1bb50, 0x1dff718c563e1741,
    0x1eafa71eebf23a7b, 0x1f5a73cca450a08d, 0x2000000000000000,
};

/*
 * Returns atan(n / d) in units of 2^-64 turns, off by less than 20 units; n <= d <= 2^31, d > 0. atan(n/d) = atan(i/32)
 * + atan(q), q = (32n - id) / (32d + in), |q| <= 1/64: five terms of the series suffice.
 */
static uint64_t atan_guess(uint32_t n, uint32_t d)
{
    uint64_t i = ((uint64_t)n * 64 + d) / ((uint64_t)d * 2), low = i * d, high = (uint64_t)n * 32;
    uint64_t numerator = high < low ? low - high : high - low, denominator = (uint64_t)d * 32 + i * n, q = 0;

    for (int k = 0; k < 4; k++) { /* numerator < 2^31, denominator < 2^38: 16 bits of the quotient at a time */
        numerator <<= 16;
        q = q << 16 | numerator / denominator;
        numerator %= denominator;
    }

    uint64_t z = fx_mul_high(q, q), series;

    series = 0x2492492492492492 - fx_mul_high(z, 0x1c71c71c71c71c72); /* 1/7, 1/9 */
    series = 0x3333333333333333 - fx_mul_high(z, series);
    series = 0x5555555555555555 - fx_mul_high(z, series);
    q -= fx_mul_high(q, fx_mul_high(z, series));
    q = fx_mul_high(q, 0x28be60db9391054a); /* 1 / (2 pi) */
    return high < low ? ATAN[i] - q : ATAN[i] + q;
}

/* Returns atan(n / d), correctly rounded; n <= d <= 2^31, d > 0. */
static ang atan_eighth(uint32_t n, uint32_t d)
{
    const uint32_t margin = 64;
    uint64_t guess = atan_guess(n, d);
    uint32_t k = (uint32_t)(guess >> 32), fraction = (uint32_t)guess;

    if (fraction - (0x80000000 - margin) < 2 * margin)
        return k + is_above_ray(n, d, k);
    return k + (fraction >> 31);
}
#else
/*
 * Returns atan(n / d), correctly rounded; n <= d <= 2^31, d > 0. The quotient is added to 1.5 * 2^46, whose last bit is
 * worth 1/64. The low bits of the sum select the cell of the table; subtracting 1.5 * 2^46 from the sum gives the
 * cell's centre, and so h without error. The polynomials are off by less than 4173 / 2^24 of an ang; the quotient and
 * the evaluation add less than 8 / 2^24, because no term is above 2^53.
 */
static ang atan_eighth(uint32_t n, uint32_t d)
{
    const double cell_bias = 105553116266496.0;
    const uint32_t margin = 5000;
    double t = (double)n / d, sum = t + cell_bias, h = t - (sum - cell_bias), hh = h * h;
    uint64_t bits;

    memcpy(&bits, &sum, sizeof bits);

    const double *c = ARC[bits & 127];
    uint64_t guess = (uint64_t)(int64_t)((c[0] + c[1] * h) + hh * ((c[2] + c[3] * h) + hh * c[4]));
    uint32_t fraction = (uint32_t)guess << 8;

    if (!FX_LIKELY(fraction + (margin << 8) > margin << 9)) {
        uint32_t k = (uint32_t)((guess - (1 << 23)) >> 24);

        return k + is_above_ray(n, d, k);
    }
    return (uint32_t)(guess >> 24);
}
#endif

/* If `condition`, returns the mirror image of a about the direction axis/2, otherwise a. */
static inline ang mirror_if(bool condition, ang axis, ang a)
{
    return (ang)negate_if(condition, a) + (axis & (0 - (ang)condition));
}

ang trig_atan2(fx y, fx x)
{
    uint32_t ax = magnitude(x), ay = magnitude(y), low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;

    if (high == 0)
        return 0;

    ang a = mirror_if(ax < ay, ANG_QUARTER, atan_eighth(low, high));

    return mirror_if(y < 0, 0, mirror_if(x < 0, ANG_HALF, a));
}

/*
 * Returns whether the fractional part of m * sin v, or of m * cos v if `cosine`, is above one half; v <= 2^29. Called
 * if the values from the tables cannot decide. For m <= 2^31 no such fraction is within 2^-66 of a half (make prove),
 * and the series is off by at most 2^-89.
 */
FX_COLD static bool is_above_half(uint32_t v, bool cosine, uint64_t m)
{
    struct wide c, s;

    wide_cos_sin(2 * v, &c, &s);
    if (!cosine)
        c = s;
    return (c.hi * m + fx_mul_high(c.lo, m)) >> 63;
}

/* A direction: cosine and sine as magnitudes in Q64, their signs, and v, the angle to the nearer axis, at most 2^29. */
struct heading {
    uint64_t c, s;
    uint32_t v;
    bool is_swapped, left, up; /* is_swapped: c is the sine of v, s the cosine */
};

static inline struct heading heading_of(ang dir)
{
    uint32_t u = dir & 0x3fffffff;
    bool is_past_middle =
        u >= 0x20000000; /* past the middle of the quarter: v counts from its end, and sine and cosine swap */
    uint32_t v = is_past_middle ? ANG_QUARTER - u : u;
    bool is_swapped = is_past_middle != (dir >> 30 & 1);
    uint64_t c, s;

    cos_sin_q64(2 * v, &c, &s);

    uint64_t swapped_bits = (s ^ c) & (0 - (uint64_t)is_swapped);

    return (struct heading){ c ^ swapped_bits, s ^ swapped_bits, v, is_swapped, (dir + 0x40000000) >> 31, dir >> 31 };
}

/* Returns length times the cosine of v if `cosine`, otherwise times the sine of v, rounded; negated if `is_negated`. q
 * is an approximation of that cosine or sine. */
static inline int64_t scale_rounded(int64_t length, uint64_t q, uint32_t v, bool cosine, bool is_negated)
{
    const uint64_t half = (uint64_t)1 << 63;
    uint64_t m = (uint64_t)negate_if(length < 0, length), margin = m << 4; /* q is off by less than 2^4 */
    uint64_t whole = fx_mul_high(q, m), fraction = q * m;

    whole += fraction - (half - margin) < 2 * margin ? is_above_half(v, cosine, m) : fraction >= half;
    return negate_if(is_negated != (length < 0), (int64_t)whole);
}

static inline int64_t along_x(const struct heading *h, int64_t length)
{
    return scale_rounded(length, h->c, h->v, !h->is_swapped, h->left);
}

static inline int64_t along_y(const struct heading *h, int64_t length)
{
    return scale_rounded(length, h->s, h->v, h->is_swapped, h->up);
}

FX_COLD static void polar_by_series(fx speed, ang dir, fx *vx, fx *vy)
{
    struct heading h = heading_of(dir);

    *vx = fx_sat(along_x(&h, speed));
    *vy = fx_sat(along_y(&h, speed));
}

#ifdef FX_INTEGER
void trig_polar(fx speed, ang dir, fx *vx, fx *vy)
{
    polar_by_series(speed, dir, vx, vy);
}
#else
/* Returns, in the low bits, the whole number nearest to (v + 1/2) * 2^10; |v| <= 2^31. A double near 1.5 * 2^42 has no
 * bits below 2^-10. */
static inline uint64_t round_to_steps(double v)
{
    double sum = v + 6597069766656.5;
    uint64_t bits;

    memcpy(&bits, &sum, sizeof bits);
    return bits;
}

/*
 * The guess is off by less than 2.56 / 2^44. So the product, including its rounding, is off by less than a third of a
 * step of 2^-10, and the product rounded to steps is off by less than one step. Unless the rounded product is a whole
 * number of units, no whole number lies between it and the exact value, and truncating it to units is correct. In one
 * of 512 cases it is a whole number, and polar_by_series decides. Only a speed of FX_MIN can give a result outside the
 * range of fx.
 */
void trig_polar(fx speed, ang dir, fx *vx, fx *vy)
{
    double cosine, sine;

    trig_cos_sin_guess(dir, &cosine, &sine);

    uint64_t x = round_to_steps(speed * cosine), y = round_to_steps(speed * sine);

    if (!FX_LIKELY(x & 1023 && y & 1023 && speed != FX_MIN)) {
        polar_by_series(speed, dir, vx, vy);
        return;
    }
    *vx = (fx)(x >> 10);
    *vy = (fx)(y >> 10);
}

#endif

void trig_stride(int64_t from, int64_t to, ang dir, int64_t *dx, int64_t *dy)
{
    struct heading h = heading_of(dir);

    *dx = along_x(&h, to) - along_x(&h, from);
    *dy = along_y(&h, to) - along_y(&h, from);
}

#ifdef FX_INTEGER
/* Returns x / sqrt(square), rounded. Finds the greatest t with t^2 <= 2^34 x^2 / square, which is twice the magnitude
 * of the result, truncated. */
static fx unit_component(fx x, uint64_t square)
{
    uint64_t xx = (uint64_t)((int64_t)x * x), high = xx >> 30, low = xx << 34, t = 0;

    for (uint64_t bit = square ? FX_ONE * 2 : 0; bit; bit >>= 1) {
        uint64_t tt = (t + bit) * (t + bit), product_high = fx_mul_high(tt, square);

        if (product_high < high || (product_high == high && tt * square <= low))
            t += bit;
    }
    return (fx)negate_if(x < 0, (int64_t)(t + 1) >> 1);
}

void trig_normalise(fx x, fx y, fx *ux, fx *uy)
{
    uint64_t square = fx_length_squared(x, y);

    *ux = unit_component(x, square);
    *uy = unit_component(y, square);
}
#else
/*
 * Returns whether |x| / sqrt(square), which is within 2^-20 units of r + 1/2, is above r + 1/2. That is the case if
 * 2^34 x^2 > (2r + 1)^2 * square. As the two values are so close, the two sides differ by less than square * (2r + 1) *
 * 2^-18 < 2^62, so 64 bits of the difference suffice. There are no ties: a tie would need two odd squares that add up
 * to 2^34 squares.
 */
static bool is_above_middle(int32_t r, fx x, uint64_t square)
{
    uint64_t xx = (uint64_t)((int64_t)x * x), odd = (uint64_t)(2 * r + 1);

    return (int64_t)((xx << 34) - odd * odd * square) > 0;
}

/* Returns x / sqrt(square), rounded. scale is 2^16 / sqrt(square) to 50 bits, which gives the product to 2^-30 of a
 * unit. */
static fx unit_component(fx x, uint64_t square, double scale)
{
    double guess = x * scale;
    int64_t r = fx_nearest(guess);

    if (!FX_LIKELY(fabs(guess - (double)r) < 0.4999995)) {
        int32_t low = (int32_t)fabs(guess);

        return (fx)negate_if(x < 0, low + is_above_middle(low, x, square));
    }
    return (fx)r;
}

void trig_normalise(fx x, fx y, fx *ux, fx *uy)
{
    uint64_t square = fx_length_squared(x, y);
    double scale = square ? FX_ONE / fx_root_guess(square) : 0;

    *ux = unit_component(x, square, scale);
    *uy = unit_component(y, square, scale);
}
#endif

/*
 * The quotient by 45 is rounded to 53 bits before it is rounded to a whole number. That is harmless: a numerator whose
 * last bit is worth u gives a quotient that is a tie or at least u/45 away from one, and the first rounding moves it by
 * u/64 at most.
 */
bool trig_from_degrees(double deg, ang *out)
{
    if (!isfinite(deg))
        return false;
    if (fabs(deg) >= 360)
        deg = fmod(deg, 360);                       /* exact */
    *out = (ang)fx_nearest(deg * 536870912.0 / 45); /* 2^32 / 360 = 2^29 / 45 */
    return true;
}

bool trig_turn_from_degrees(double deg, int32_t *out)
{
    ang a;

    if (!trig_from_degrees(deg, &a))
        return false;
    *out = (int32_t)a;
    return true;
}

double trig_to_degrees(ang a)
{
    return a * 45.0 / 536870912.0;
}

/* ---- arrays ---- */

#ifdef FX_INTEGER
void trig_atan2s(const fx *y, const fx *x, ang *a, int n)
{
    for (int i = 0; i < n; i++)
        a[i] = trig_atan2(y[i], x[i]);
}

void trig_polars(const fx *speed, const ang *dir, fx *vx, fx *vy, int n)
{
    for (int i = 0; i < n; i++)
        trig_polar(speed[i], dir[i], &vx[i], &vy[i]);
}

void trig_strides(const int64_t *from, const int64_t *to, const ang *dir, int64_t *dx, int64_t *dy, int n)
{
    for (int i = 0; i < n; i++)
        trig_stride(from[i], to[i], dir[i], &dx[i], &dy[i]);
}
#else
/*
 * Computes the same guesses as the scalar functions, but in loops that gcc and clang vectorise at -O2 without further
 * flags: restrict parameters, a constant trip count, no branch; table lookups are in separate loops. The scalar
 * functions compute the elements whose guess is in doubt. Elements that remain after whole groups of LANES are computed
 * in a last group that repeats some of the preceding elements, or one by one if they are few.
 */
enum { LANES = 16 };

static inline uint64_t bits_of(double v)
{
    uint64_t bits;

    memcpy(&bits, &v, sizeof bits);
    return bits;
}

static inline double double_of(uint64_t bits)
{
    double v;

    memcpy(&v, &bits, sizeof v);
    return v;
}

/* ---- directions ---- */

/* Returns |v|, but 0 for FX_MIN. */
static inline int32_t lane_magnitude(fx v)
{
    const uint32_t sign = (uint32_t)(v >> 31);

    return (int32_t)((((uint32_t)v ^ sign) - sign) & FX_MAX);
}

/* Stores in t[i] the shorter component of vector i divided by the longer. Returns 0 if some vector is (0, 0) or has a
 * component of FX_MIN. */
static int32_t compute_slopes(const fx *restrict y, const fx *restrict x, double *restrict t)
{
    int32_t special_mask = 0;

    for (int i = 0; i < LANES; i++) {
        const int32_t ax = lane_magnitude(x[i]), ay = lane_magnitude(y[i]), low = ax < ay ? ax : ay,
                      high = ax < ay ? ay : ax;
        special_mask |= -(high == 0) | -(x[i] == FX_MIN) | -(y[i] == FX_MIN);
        t[i] = (double)low / (double)(high | -(high == 0));
    }
    return ~special_mask;
}

/* Replaces a[i], the arctangent of compute_slopes' t[i], with the direction of (x[i], y[i]). */
static void restore_quadrants(const fx *restrict y, const fx *restrict x, ang *restrict a)
{
    for (int i = 0; i < LANES; i++) {
        const uint32_t steep = (uint32_t) - (lane_magnitude(x[i]) < lane_magnitude(y[i]));
        const uint32_t left = (uint32_t)(x[i] >> 31), up = (uint32_t)(y[i] >> 31);
        const uint32_t first = (a[i] ^ steep) - steep + (steep & 0x40000000);
        const uint32_t half = (first ^ left) - left + (left & 0x80000000);
        a[i] = (half ^ up) - up;
    }
}

/*
 * Rounds guesses, in units of 2^-24 of an ang, to whole angs. A guess is doubtful if it is within 5008 units of the
 * point where the result changes: 5000 as in atan_eighth, plus 8 because guesses are examined in steps of 4 units.
 * Returns 0 if none is doubtful.
 */
static int32_t round_guesses(const double *restrict guess, ang *restrict a, int32_t *restrict doubtful)
{
    const uint32_t margin = 1252;
    int32_t any_doubtful = 0;

    for (int i = 0; i < LANES; i++) {
        const uint64_t steps = bits_of(guess[i] + 27021597764222976.0); /* 1.5 * 2^54: its last bit is 4 */
        const uint32_t fraction = ((uint32_t)steps << 10) + (margin << 10);
        a[i] = (ang)(steps >> 22) - 0x60000000; /* 1.5 * 2^54 in these bits */
        doubtful[i] = -((int32_t)(fraction ^ 0x80000000) <= (int32_t)(margin << 11 ^ 0x80000000));
        any_doubtful |= doubtful[i];
    }
    return any_doubtful;
}

static void atan2_lanes(const fx *y, const fx *x, ang *a)
{
    const double cell_bias = 105553116266496.0;
    double t[LANES], guess[LANES];
    int32_t doubtful[LANES];

    if (!compute_slopes(y, x, t)) {
        for (int i = 0; i < LANES; i++)
            a[i] = trig_atan2(y[i], x[i]);
        return;
    }
    for (int i = 0; i < LANES; i++) {
        const double sum = t[i] + cell_bias, h = t[i] - (sum - cell_bias), hh = h * h;
        const double *c = ARC[bits_of(sum) & 127];
        guess[i] = (c[0] + c[1] * h) + hh * ((c[2] + c[3] * h) + hh * c[4]);
    }
    const int32_t any_doubtful = round_guesses(guess, a, doubtful);
    restore_quadrants(y, x, a);
    for (int i = 0; any_doubtful && i < LANES; i++)
        if (doubtful[i])
            a[i] = trig_atan2(y[i], x[i]);
}

void trig_atan2s(const fx *y, const fx *x, ang *a, int n)
{
    int i = 0;

    for (; i + LANES <= n; i += LANES)
        atan2_lanes(y + i, x + i, a + i);
    if (i && n - i >= LANES / 2) { /* recomputes some elements */
        atan2_lanes(y + n - LANES, x + n - LANES, a + n - LANES);
        return;
    }
    for (; i < n; i++)
        a[i] = trig_atan2(y[i], x[i]);
}

/* ---- polar coordinates ---- */

/* Stores the sine of the angle between dir and the nearest ray (trig_guess.h), and 1 minus the cosine of that angle. */
static void compute_ray_offsets(const ang *restrict dir, double *restrict sine, double *restrict versine)
{
    for (int i = 0; i < LANES; i++) {
        const double h = (int32_t)(dir[i] << 8), hh = h * h;
        sine[i] = (RAY_STEP.a + RAY_STEP.b * hh) * h;
        versine[i] = (RAY_STEP.c + RAY_STEP.d * hh) * hh;
    }
}

/* Multiplies speed by x and y in steps of 2^-10, like trig_polar, and marks the doubtful products. Returns 0 if none is
 * doubtful. */
static int32_t multiply_lanes(const fx *restrict speed, const double *restrict x, const double *restrict y,
                              fx *restrict vx, fx *restrict vy, int32_t *restrict doubtful)
{
    int32_t any_doubtful = 0;

    for (int i = 0; i < LANES; i++) {
        const double v = speed[i];
        const uint64_t steps_x = bits_of(v * x[i] + 6597069766656.5), steps_y = bits_of(v * y[i] + 6597069766656.5);
        vx[i] = (fx)(steps_x >> 10);
        vy[i] = (fx)(steps_y >> 10);
        doubtful[i] = -(((uint32_t)steps_x & 1023) == 0) | -(((uint32_t)steps_y & 1023) == 0) | -(speed[i] == FX_MIN);
        any_doubtful |= doubtful[i];
    }
    return any_doubtful;
}

static void polar_lanes(const fx *speed, const ang *dir, fx *vx, fx *vy)
{
    double sine[LANES], versine[LANES], x[LANES], y[LANES];
    int32_t doubtful[LANES];

    compute_ray_offsets(dir, sine, versine);
    for (int i = 0; i < LANES; i++) {
        const double *ray = RAY[(ang)(dir[i] + 0x800000) >> 24];
        const double c = ray[0], s = ray[1];
        x[i] = c - (c * versine[i] + s * sine[i]);
        y[i] = s + (c * sine[i] - s * versine[i]);
    }
    const int32_t any_doubtful = multiply_lanes(speed, x, y, vx, vy, doubtful);
    for (int i = 0; any_doubtful && i < LANES; i++)
        if (doubtful[i])
            trig_polar(speed[i], dir[i], &vx[i], &vy[i]);
}

void trig_polars(const fx *speed, const ang *dir, fx *vx, fx *vy, int n)
{
    int i = 0;

    for (; i + LANES <= n; i += LANES)
        polar_lanes(speed + i, dir + i, vx + i, vy + i);
    if (i && n - i >= LANES / 2) {
        i = n - LANES;
        polar_lanes(speed + i, dir + i, vx + i, vy + i);
        return;
    }
    for (; i < n; i++)
        trig_polar(speed[i], dir[i], &vx[i], &vy[i]);
}

/* ---- strides ---- */

/* Returns the angle between dir and the nearer axis, at most an eighth of a turn, as heading_of does. */
static inline uint32_t fold_to_eighth(ang dir)
{
    const uint32_t u = dir & 0x3fffffff, past_mask = 0 - (u >> 29);

    return (u ^ past_mask) - past_mask + (past_mask & 0x40000000);
}

/* Stores the sine of r and 1 minus the cosine of r. r < 2^-9.3 is the angle by which fold_to_eighth(dir) exceeds the
 * last of the 513 directions (cos_sin_q64) that is not beyond it. */
static void compute_remainders(const ang *restrict dir, double *restrict sine, double *restrict versine)
{
    for (int i = 0; i < LANES; i++) {
        const double r = (double)(int32_t)(fold_to_eighth(dir[i]) & 0xfffff) * 0x1.921fb54442d18p-30, rr = r * r;
        sine[i] = r - r * (rr * (1.0 / 6 - rr * (1.0 / 120)));
        versine[i] = rr * (0.5 - rr * (1.0 / 24 - rr * (1.0 / 720)));
    }
}

/* Replaces the cosine and sine of fold_to_eighth(dir) with the cosine and sine of dir. */
static void unfold(const ang *restrict dir, double *restrict cosine, double *restrict sine)
{
    for (int i = 0; i < LANES; i++) {
        const uint64_t c = bits_of(cosine[i]), s = bits_of(sine[i]);
        const uint64_t swap_mask = 0 - (uint64_t)((dir[i] ^ dir[i] << 1) >> 30 & 1), swapped_bits = (c ^ s) & swap_mask;
        cosine[i] = double_of(c ^ swapped_bits ^ (uint64_t)((dir[i] + 0x40000000) >> 31) << 63);
        sine[i] = double_of(s ^ swapped_bits ^ (uint64_t)(dir[i] >> 31) << 63);
    }
}

/* Stores the cosine and sine of dir within 2^-52.4: the table's directions are truncated to 53 bits, the last sum is
 * rounded to 53 bits, and all other errors are below 2^-60. */
static void cos_sin_lanes(const ang *dir, double *cosine, double *sine)
{
    double sin_r[LANES], versin_r[LANES];

    compute_remainders(dir, sin_r, versin_r);
    for (int i = 0; i < LANES; i++) {
        const uint64_t *entry = WAY[fold_to_eighth(dir[i]) >> 20];
        const double c = (double)(int64_t)(entry[0] >> 11) * 0x1p-53, s = (double)(int64_t)(entry[1] >> 11) * 0x1p-53;
        cosine[i] = c - (c * versin_r[i] + s * sin_r[i]);
        sine[i] = s + (c * sin_r[i] - s * versin_r[i]);
    }
    unfold(dir, cosine, sine);
}

/* Returns a length as a double, exactly: |v| <= 2^48. */
static inline double length_to_double(int64_t v)
{
    return double_of((uint64_t)v + 0x4338000000000000) - 6755399441055744.0; /* 1.5 * 2^52 has no bits below one */
}

/*
 * Stores d = round(to * f) - round(from * f), where f is the exact value that `factor` approximates. The error of a
 * product, relative to its length (|from| or |to|), is below 2^-52.4 from `factor`, plus 2^-53 from rounding the
 * product to a double. Sets doubtful[i] if a product of lane i is nearer to a rounding tie than 2^-51 of its length.
 * Returns 0 if no lane is doubtful.
 */
static uint64_t compute_spans(const int64_t *restrict from, const int64_t *restrict to, const double *restrict factor,
                              int64_t *restrict d, uint64_t *restrict doubtful)
{
    uint64_t any_doubtful = 0;

    for (int i = 0; i < LANES; i++) {
        const double a = length_to_double(from[i]), b = length_to_double(to[i]), x = a * factor[i], y = b * factor[i];
        const double whole_x = x + 6755399441055744.0, whole_y = y + 6755399441055744.0;
        const double slack_x = 0.5 - fabs(x - (whole_x - 6755399441055744.0)) - fabs(a) * 0x1p-51;
        const double slack_y = 0.5 - fabs(y - (whole_y - 6755399441055744.0)) - fabs(b) * 0x1p-51;
        d[i] = (int64_t)(bits_of(whole_y) - bits_of(whole_x));
        doubtful[i] = (bits_of(slack_x) | bits_of(slack_y)) >> 63;
        any_doubtful |= doubtful[i];
    }
    return any_doubtful;
}

static void stride_lanes(const int64_t *from, const int64_t *to, const ang *dir, int64_t *dx, int64_t *dy)
{
    double cosine[LANES], sine[LANES];
    uint64_t doubtful[2][LANES];

    cos_sin_lanes(dir, cosine, sine);
    const uint64_t any_doubtful =
        compute_spans(from, to, cosine, dx, doubtful[0]) | compute_spans(from, to, sine, dy, doubtful[1]);
    for (int i = 0; any_doubtful && i < LANES; i++)
        if (doubtful[0][i] | doubtful[1][i])
            trig_stride(from[i], to[i], dir[i], &dx[i], &dy[i]);
}

void trig_strides(const int64_t *from, const int64_t *to, const ang *dir, int64_t *dx, int64_t *dy, int n)
{
    int i = 0;

    for (; i + LANES <= n; i += LANES)
        stride_lanes(from + i, to + i, dir + i, dx + i, dy + i);
    if (i && n - i >= LANES / 2) {
        i = n - LANES;
        stride_lanes(from + i, to + i, dir + i, dx + i, dy + i);
        return;
    }
    for (; i < n; i++)
        trig_stride(from[i], to[i], dir[i], &dx[i], &dy[i]);
}
#endif

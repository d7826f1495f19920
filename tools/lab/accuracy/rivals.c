/*
 * rivals.c - see rivals.h. The cheap ones are what games commonly do; none saturates unless it says so, and sums that
 * may leave 32 bits wrap. All but the C library's give the same bits on every host.
 */
#include "rivals.h"
#include <libfixmath/fix16.h>
#include <math.h>
#include <string.h>
#include "../../../src/base/trig.h"
#include "lab.h"
#include "truth.h"

/* A rival of one result, VALUE computed from *s; IN_BITS is the same in the last bits of the engine's result. */
#define RIVAL_AS(id, VALUE, IN_BITS)                                                                                   \
    static void id##_run(void *data)                                                                                   \
    {                                                                                                                  \
        const struct sample *s = data;                                                                                 \
        int64_t sum = 0;                                                                                               \
        for (int i = 0; i < LAB_VALUES; i++, s++)                                                                      \
            sum += (VALUE);                                                                                            \
        lab_sink = sum;                                                                                                \
    }                                                                                                                  \
    static void id##_at(const struct sample *s, int64_t out[])                                                         \
    {                                                                                                                  \
        out[0] = (IN_BITS);                                                                                            \
    }
#define RIVAL(id, VALUE) RIVAL_AS(id, VALUE, VALUE)

/* A rival of two results, which CALL puts into x and y. */
#define RIVAL_2(id, CALL)                                                                                              \
    static void id##_run(void *data)                                                                                   \
    {                                                                                                                  \
        const struct sample *s = data;                                                                                 \
        int64_t sum = 0;                                                                                               \
        fx x, y;                                                                                                       \
        for (int i = 0; i < LAB_VALUES; i++, s++) {                                                                    \
            CALL;                                                                                                      \
            sum += x ^ y;                                                                                              \
        }                                                                                                              \
        lab_sink = sum;                                                                                                \
    }                                                                                                                  \
    static void id##_at(const struct sample *s, int64_t out[])                                                         \
    {                                                                                                                  \
        fx x, y;                                                                                                       \
        CALL;                                                                                                          \
        out[0] = x;                                                                                                    \
        out[1] = y;                                                                                                    \
    }

#define ROW(kind, host, id, name, trade, who)                                                                          \
    {                                                                                                                  \
        kind, host, name, trade, id##_run, id##_at, who                                                                \
    }
#define ROWS(name, table) const struct rivals name = { table, sizeof table / sizeof *table }

enum { QUARTER = 0x40000000 };

static inline fx wrap(int64_t v)
{
    return (fx)(uint32_t)v;
}

/* The nearest whole number, halves away from 0, with no branch to be mispredicted. */
static inline int64_t whole(double v)
{
    return (int64_t)(v + copysign(0.5, v));
}

static inline int64_t whole_f(float v)
{
    return (int64_t)(v + copysignf(0.5f, v));
}

static inline int64_t exact(struct truth t)
{
    return fx_sat(t.near);
}

/* ---- multiplication ---- */

static inline uint32_t size_of(fx v)
{
    return v < 0 ? 0 - (uint32_t)v : (uint32_t)v;
}

/* Four products of 16 bits, for a processor that has no larger ones; half away from zero, saturating. */
static fx mul_halves(fx a, fx b)
{
    uint32_t m = size_of(a), n = size_of(b), ml = m & 0xffff, mh = m >> 16, nl = n & 0xffff, nh = n >> 16;
    uint32_t low = ml * nl, top = mh * nh, mid = mh * nl, mid2 = ml * nh, sum = (low >> 16) + (low >> 15 & 1), more;

    more = sum + mid;
    top += (uint32_t)(more < mid) << 16;
    sum = more + mid2;
    top += (uint32_t)(sum < mid2) << 16;
    more = sum + (top << 16);
    if (top >= 0x10000 || more < sum || more > 0x7fffffffu + ((a ^ b) < 0))
        return (a ^ b) < 0 ? FX_MIN : FX_MAX;
    return (fx)((a ^ b) < 0 ? 0 - more : more);
}

static fx mul_bits(fx a, fx b)
{
    uint64_t sum = 0, m = size_of(a);

    for (uint32_t n = size_of(b); n; n >>= 1, m <<= 1)
        sum += n & 1 ? m : 0;
    sum = (sum + 0x7fff + (sum >> 16 & 1)) >> 16;
    return fx_sat((a ^ b) < 0 ? -(int64_t)sum : (int64_t)sum);
}

RIVAL(mul_cut, wrap((int64_t)s->a * s->b >> 16))
RIVAL(mul_up, wrap(((int64_t)s->a * s->b + 0x8000) >> 16))
RIVAL(mul_float, wrap(whole_f((float)s->a *(float)s->b / 65536)))
RIVAL(mul_engine, fx_mul(s->a, s->b))
RIVAL(mul_double, fx_sat(whole((double)s->a * s->b / 65536)))
RIVAL(mul_16, mul_halves(s->a, s->b))
RIVAL(mul_1, mul_bits(s->a, s->b))
RIVAL(mul_lfm, fix16_smul(s->a, s->b))

static const struct rival MUL[] = {
    ROW(CHEAPER, false, mul_cut, "truncated, wraps", "accuracy: half an ulp too low on average; overflow",
        "avoid: results are half an ulp too low on average, so mirrored patterns drift apart"),
    ROW(CHEAPER, false, mul_up, "half up, wraps", "ties; overflow",
        "sums of a few products that cannot overflow; ties round differently for −x and x"),
    ROW(ENGINE, false, mul_engine, "fx_mul", "nothing", "every scene"),
    ROW(DEARER, false, mul_float, "float32", "8 of 32 bits", "avoid: 24 bits are too few for a position"),
    ROW(DEARER, false, mul_double, "double, saturates", "ties; the lowest 11 bits of long products",
        "avoid: no more accurate than rounding half up, and conversions cost extra"),
    ROW(DEARER, false, mul_16, "four 16-bit products", "time", "processors that can only multiply 16-bit numbers"),
    ROW(DEARER, false, mul_1, "bit by bit", "time", "processors without a multiplier"),
    ROW(LIBRARY, false, mul_lfm, "libfixmath", "ties; time", "avoid: rounds half away from zero, and is slower"),
};
ROWS(rivals_mul, MUL);

/* ---- division ---- */

static fx div_bits(fx a, fx b)
{
    uint64_t n = (uint64_t)size_of(a) << 16, d = size_of(b), q = 0, rest = 0;

    for (int i = 47; i >= 0; i--) {
        rest = rest << 1 | (n >> i & 1);
        q <<= 1;
        if (rest >= d) {
            rest -= d;
            q |= 1;
        }
    }
    q += (rest * 2 > d) | ((rest * 2 == d) & (q & 1));
    return fx_sat((a ^ b) < 0 ? -(int64_t)q : (int64_t)q);
}

RIVAL(div_cut, wrap((int64_t)s->a *FX_ONE / s->b))
RIVAL(div_recip, wrap(s->a *(((int64_t)1 << 32) / s->b) >> 16))
RIVAL(div_float, wrap(whole_f((float)s->a * 65536 / (float)s->b)))
RIVAL_AS(div_kept, fx_sat(fx_nearest(s->a * s->other)), fx_sat(fx_nearest(s->a *(65536.0 / s->b))))
RIVAL(div_engine, fx_div(s->a, s->b))
RIVAL(div_twin, twin_div(s->a, s->b))
RIVAL(div_double, fx_sat(fx_nearest(s->a * 65536.0 / s->b)))
RIVAL(div_1, div_bits(s->a, s->b))
RIVAL(div_lfm, fix16_sdiv(s->a, s->b))

static const struct rival DIV[] = {
    ROW(CHEAPER, false, div_kept, "times an inverse stored as a double", "ties; the time to compute the inverse",
        "dividing many numbers by the same divisor"),
    ROW(CHEAPER, false, div_double, "double, half to even (fx_div)", "nothing: this is fx_div",
        "every scene: the double's error is too small to change the rounded quotient"),
    ROW(ENGINE, false, div_engine, "fx_div", "nothing", "every scene"),
    ROW(DEARER, false, div_float, "float32", "8 of 32 bits", "avoid: 24 bits are too few for a position"),
    ROW(DEARER, false, div_cut, "truncated, wraps", "accuracy: half an ulp too close to 0 on average; overflow",
        "integer results such as tiles, cells and frames"),
    ROW(DEARER, false, div_recip, "times a Q16.16 reciprocal", "all but 16 bits of the inverse",
        "dividing many numbers by the same divisor, if the divisor is larger than 1 px"),
    ROW(DEARER, false, div_twin, "the engine's integer twin", "time", "processors without hardware doubles"),
    ROW(DEARER, false, div_1, "bit by bit", "time", "processors without a divider"),
    ROW(LIBRARY, false, div_lfm, "libfixmath", "the last bit of some results; time",
        "avoid: sometimes wrong, and slower"),
};
ROWS(rivals_div, DIV);

/* ---- roots ---- */

/* Newton's method from a power of two above the root. */
static fx root_newton(fx x)
{
    uint64_t n = (uint64_t)x << 16, r = 1, next;

    if (x <= 0)
        return 0;
    while (r * r < n)
        r <<= 1;
    while ((next = (r + n / r) / 2) < r)
        r = next;
    return (fx)(r + (n > r * r + r));
}

/* Lomont's constant for a first guess at 1/sqrt(v), and one step of Newton's method. */
static float rsqrt_hack(float v)
{
    uint32_t bits;
    float r;

    memcpy(&bits, &v, sizeof bits);
    bits = 0x5f375a86 - (bits >> 1);
    memcpy(&r, &bits, sizeof r);
    return r * (1.5f - 0.5f * v * r * r);
}

/* Is the root larger than s->b? No root: squares are compared. */
static void sqrt_squares_run(void *data)
{
    const struct sample *s = data;
    int64_t sum = 0;

    for (int i = 0; i < LAB_VALUES; i++, s++)
        sum += (int64_t)s->a << 16 > (int64_t)s->b * s->b;
    lab_sink = sum;
}
#define sqrt_squares_at NULL

RIVAL(sqrt_cut, (int64_t)sqrt(s->a * 65536.0))
RIVAL(sqrt_hack, whole_f((float)s->a * 256 * rsqrt_hack((float)s->a)))
RIVAL(sqrt_float, whole_f(sqrtf((float)s->a) * 256))
RIVAL(sqrt_engine, fx_sqrt(s->a))
RIVAL(sqrt_double, whole(sqrt(s->a * 65536.0)))
RIVAL(sqrt_newton, root_newton(s->a))
RIVAL(sqrt_twin, twin_sqrt(s->a))
RIVAL(sqrt_lfm, fix16_sqrt(s->a))

static const struct rival SQRT[] = {
    ROW(CHEAPER, false, sqrt_squares, "no root: compare squares", "the root itself", "comparing lengths"),
    ROW(CHEAPER, false, sqrt_float, "libm sqrtf", "8 of 32 bits", "lengths in visual effects"),
    ROW(CHEAPER, false, sqrt_cut, "double, truncated", "half an ulp",
        "avoid: correct rounding takes only one more comparison"),
    ROW(ENGINE, false, sqrt_engine, "fx_sqrt", "nothing", "every scene; compare squares where possible"),
    ROW(CHEAPER, false, sqrt_double, "double (libm), rounded", "the exact check that the rounding is correct",
        "programs that need no guarantee of correct rounding"),
    ROW(DEARER, false, sqrt_hack, "float32, 1/√ by its bits", "20 of 32 bits",
        "avoid: the processor's own square root is as fast"),
    ROW(DEARER, false, sqrt_newton, "Newton's method, integers", "time", "integer processors with a divider"),
    ROW(DEARER, false, sqrt_twin, "the engine's twin: bit by bit", "time", "processors without hardware doubles"),
    ROW(LIBRARY, false, sqrt_lfm, "libfixmath", "time", "avoid: the slowest method"),
};
ROWS(rivals_sqrt, SQRT);

RIVAL(rsqrt_bits, whole_f(16777216.0f * rsqrt_hack((float)s->a)))
RIVAL(rsqrt_float, whole_f(16777216.0f / sqrtf((float)s->a)))
RIVAL(rsqrt_two, fx_div(FX_ONE, fx_sqrt(s->a)))
RIVAL(rsqrt_engine, fx_rsqrt(s->a))
RIVAL(rsqrt_double, whole(16777216.0 / sqrt((double)s->a)))
RIVAL(rsqrt_twin, twin_rsqrt(s->a))
RIVAL(rsqrt_lfm, fix16_div(FX_ONE, fix16_sqrt(s->a)))

static const struct rival RSQRT[] = {
    ROW(CHEAPER, false, rsqrt_bits, "float32 by its bits", "20 of 32 bits",
        "avoid: the processor's own square root is as fast"),
    ROW(CHEAPER, false, rsqrt_float, "float32", "8 of 32 bits", "directions in visual effects"),
    ROW(ENGINE, false, rsqrt_engine, "fx_rsqrt", "nothing", "every scene"),
    ROW(CHEAPER, false, rsqrt_double, "double (libm), rounded", "the exact check that the rounding is correct",
        "programs that need no guarantee of correct rounding"),
    ROW(DEARER, false, rsqrt_two, "1 / fx_sqrt", "the bits lost by rounding the root",
        "avoid: dividing by a rounded root is inaccurate"),
    ROW(DEARER, false, rsqrt_twin, "the engine's twin: bit by bit", "time", "processors without hardware doubles"),
    ROW(LIBRARY, false, rsqrt_lfm, "libfixmath: 1 / sqrt", "the bits lost by rounding the root; time", "avoid"),
};
ROWS(rivals_rsqrt, RSQRT);

/* ---- lengths ---- */

/* The larger plus 3/8 of the smaller. */
static inline fx hypot_max(fx x, fx y)
{
    uint32_t a = size_of(x), b = size_of(y);

    uint64_t high = a > b ? a : b, low = a > b ? b : a;

    return (fx)(high + low * 3 / 8);
}

static fx hypot_q16(fx x, fx y)
{
    return fx_sqrt(fx_add(fx_mul(x, x), fx_mul(y, y)));
}

static fx hypot_lfm_of(fx x, fx y)
{
    return fix16_sqrt(fix16_sadd(fix16_smul(x, x), fix16_smul(y, y)));
}

RIVAL(hypot_38, hypot_max(s->a, s->b))
RIVAL(hypot_float, wrap(whole_f(sqrtf((float)s->a *(float)s->a + (float)s->b * (float)s->b))))
RIVAL(hypot_double, fx_sat(whole(sqrt((double)s->a * s->a + (double)s->b * s->b))))
RIVAL(hypot_engine, fx_hypot(s->a, s->b))
RIVAL(hypot_squares, hypot_q16(s->a, s->b))
RIVAL(hypot_twin, twin_hypot(s->a, s->b))
RIVAL(hypot_libm, fx_sat(whole(hypot(s->a, s->b))))
RIVAL(hypot_libmf, fx_sat(whole_f(hypotf((float)s->a, (float)s->b))))
RIVAL(hypot_lfm, hypot_lfm_of(s->a, s->b))

static const struct rival HYPOT[] = {
    ROW(CHEAPER, false, hypot_38, "larger + ⅜ smaller", "up to 7 % of the length",
        "sorting by distance where an error of 7 % does not matter"),
    ROW(CHEAPER, false, hypot_float, "float32", "8 of 32 bits", "distances in visual effects"),
    ROW(CHEAPER, false, hypot_double, "double, rounded", "the exact check that the rounding is correct",
        "a game without replays: results near ties may be rounded the wrong way"),
    ROW(ENGINE, false, hypot_engine, "fx_hypot", "nothing", "every scene; compare squares where possible"),
    ROW(DEARER, false, hypot_squares, "squares in Q15.16", "lengths beyond 181 px",
        "avoid: squares overflow beyond 181 px"),
    ROW(DEARER, false, hypot_twin, "the engine's twin: bit by bit", "time", "processors without hardware doubles"),
    ROW(LIBRARY, true, hypot_libm, "libm hypot", "portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, true, hypot_libmf, "libm hypotf", "8 of 32 bits; portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, false, hypot_lfm, "libfixmath: squares and root", "lengths beyond 181 px; time",
        "avoid: squares overflow beyond 181 px"),
};
ROWS(rivals_hypot, HYPOT);

/* ---- sine and cosine ---- */

static fx SINES_256[256], SINES_1024[1025], SINES_64K[65536];
static int64_t STEPS[48]; /* arc tangents of 2^-k in 2^-48 turns */

static inline fx sin_lerp(ang a)
{
    const fx *t = &SINES_1024[a >> 22];

    return t[0] + wrap((int64_t)(t[1] - t[0]) * (int32_t)(a & 0x3fffff) >> 22);
}

/* x (4 - 4|x|) with x in half turns, as Q15.16. */
static inline fx sin_arch(ang a)
{
    int64_t x = (int32_t)a >> 14; /* 2^17 is half a turn */

    return wrap(x * (131072 - (x < 0 ? -x : x)) >> 16);
}

/* The quarter's sine as an odd polynomial: Taylor's series to the 11th power, which the fold makes good to 6e-8. */
static fx sin_taylor(ang a)
{
    int32_t folded = (int32_t)((a ^ a << 1) >> 31 ? 0x80000000 - a : a);
    double x = folded * (6.283185307179586 / 4294967296), z = x * x;

    x *= 1 + z * (-1 / 6.0 + z * (1 / 120.0 + z * (-1 / 5040.0 + z * (1 / 362880.0 - z / 39916800.0))));
    return (fx)whole(x * 65536);
}

/* Turns (x, 0) by the angle in steps of arc tangents of powers of two: 40 steps, 2^-44 of x. */
static void cordic(int64_t size, ang a, int64_t *x, int64_t *y)
{
    int64_t rest = (int64_t)(int32_t)a * 65536, c = size, s = 0;

    if (rest > (int64_t)1 << 46 || rest < -((int64_t)1 << 46)) { /* beyond a quarter: from the other side */
        rest += rest < 0 ? (int64_t)1 << 47 : -((int64_t)1 << 47);
        c = -c;
    }
    for (int k = 0; k < 40; k++) {
        int64_t dc = s >> k, ds = c >> k;
        bool back = rest < 0;
        c -= back ? -dc : dc;
        s += back ? -ds : ds;
        rest -= back ? -STEPS[k] : STEPS[k];
    }
    *x = c;
    *y = s;
}

static const int64_t CORDIC_ONE = 2670726652173; /* 2^42 over what the steps stretch: 0.60725... */

static fx cordic_sin(ang a)
{
    int64_t c, s;

    cordic(CORDIC_ONE, a, &c, &s);
    return (fx)((s + (1 << 25)) >> 26);
}

static inline fx sin_30(ang a)
{
    return (trig_sin30(a) + 8192) >> 14;
}

RIVAL(sin_256, SINES_256[(ang)(s->dir + (1 << 23)) >> 24])
RIVAL(sin_1024, sin_lerp(s->dir))
RIVAL(sin_parabola, sin_arch(s->dir))
RIVAL(sin_64k, SINES_64K[(ang)(s->dir + (1 << 15)) >> 16])
RIVAL(sin_11, sin_taylor(s->dir))
RIVAL(sin_engine, trig_sin(s->dir))
RIVAL(sin_q30, sin_30(s->dir))
RIVAL(sin_cordic, cordic_sin(s->dir))
RIVAL(sin_106, exact(truth_sin((int64_t)1 << 32, s->dir)))
RIVAL(sin_libm, whole(sin(s->radians) * 65536))
RIVAL(sin_libmf, whole_f(sinf((float)s->radians) * 65536))
RIVAL(sin_lfm, fix16_sin(s->rad))
RIVAL(sin_lfmp, fix16_sin_parabola(s->rad))

static const struct rival SIN[] = {
    ROW(CHEAPER, false, sin_256, "256 entries, nearest", "1 KiB of RAM; up to 803 ulp", "an 8-bit look, sparks"),
    ROW(CHEAPER, false, sin_parabola, "a parabola", "up to 0.06", "swaying in visual effects"),
    ROW(CHEAPER, false, sin_1024, "1024 entries, interpolated", "4 KiB of RAM; up to 1.7 ulp",
        "waves that tolerate uneven errors"),
    ROW(CHEAPER, false, sin_64k, "65,536 entries (256 KiB)", "256 KiB of RAM; up to 3.6 ulp",
        "16-bit angles, for which it is exact"),
    ROW(ENGINE, false, sin_engine, "trig_sin", "nothing", "every scene"),
    ROW(DEARER, false, sin_11, "Taylor to x¹¹, double", "up to 0.003 ulp; time", "short code on a host with doubles"),
    ROW(DEARER, false, sin_q30, "trig_sin30, rounded again", "a second rounding",
        "sines in products: multiply by the unrounded 30-bit sine, and round only the product"),
    ROW(DEARER, false, sin_cordic, "CORDIC, 40 steps", "time", "processors without a multiplier"),
    ROW(ORACLE, false, sin_106, "106 bits", "time", "test oracles"),
    ROW(LIBRARY, true, sin_libm, "libm sin", "portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, true, sin_libmf, "libm sinf", "8 of 32 bits; portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, false, sin_lfm, "libfixmath", "up to 508 ulp; time",
        "avoid: its series is too short near half a turn"),
    ROW(LIBRARY, false, sin_lfmp, "libfixmath, parabola", "up to 73 ulp; time", "swaying in visual effects"),
};
ROWS(rivals_sin, SIN);

RIVAL(cos_256, SINES_256[(ang)(s->dir + QUARTER + (1 << 23)) >> 24])
RIVAL(cos_1024, sin_lerp(s->dir + QUARTER))
RIVAL(cos_64k, SINES_64K[(ang)(s->dir + QUARTER + (1 << 15)) >> 16])
RIVAL(cos_engine, trig_cos(s->dir))
RIVAL(cos_cordic, cordic_sin(s->dir + QUARTER))
RIVAL(cos_libm, whole(cos(s->radians) * 65536))
RIVAL(cos_libmf, whole_f(cosf((float)s->radians) * 65536))
RIVAL(cos_lfm, fix16_cos(s->rad))

static const struct rival COS[] = {
    ROW(CHEAPER, false, cos_256, "256 entries, nearest", "1 KiB of RAM; up to 803 ulp", "see Sine"),
    ROW(CHEAPER, false, cos_1024, "1024 entries, interpolated", "4 KiB of RAM; up to 1.7 ulp", "see Sine"),
    ROW(CHEAPER, false, cos_64k, "65,536 entries (256 KiB)", "256 KiB of RAM; up to 3.6 ulp",
        "16-bit angles, for which it is exact"),
    ROW(ENGINE, false, cos_engine, "trig_cos", "nothing", "every scene"),
    ROW(DEARER, false, cos_cordic, "CORDIC, 40 steps", "time", "processors without a multiplier"),
    ROW(LIBRARY, true, cos_libm, "libm cos", "portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, true, cos_libmf, "libm cosf", "8 of 32 bits; portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, false, cos_lfm, "libfixmath", "up to 506 ulp; time",
        "avoid: its series is too short near half a turn"),
};
ROWS(rivals_cos, COS);

/* ---- directions ---- */

static ang ARCS[1026]; /* arc tangents of i / 1024 */

/* An angle of the first eighth brought where (x, y) is. */
static inline ang unfold(ang a, fx y, fx x)
{
    a = size_of(y) > size_of(x) ? QUARTER - a : a;
    a = x < 0 ? 0x80000000 - a : a;
    return y < 0 ? 0 - a : a;
}

/* The smaller coordinate over the larger, 2^32 - 1 for 1. */
static inline uint32_t slope(fx y, fx x)
{
    uint32_t a = size_of(x), b = size_of(y), low = a < b ? a : b, high = a < b ? b : a;

    return high == 0 ? 0 : low == high ? 0xffffffffu : (uint32_t)(((uint64_t)low << 32) / high);
}

/* t / 8 + 0.0434 t (1 - t) of a turn. */
static ang atan_square(fx y, fx x)
{
    uint64_t t = slope(y, x);

    return unfold((ang)((t >> 3) + ((t * (0xffffffff - t) >> 32) * 186616000 >> 32)), y, x);
}

static ang atan_nearest(fx y, fx x)
{
    uint64_t t = slope(y, x);

    return unfold(ARCS[((t + (1 << 23)) >> 24) * 4], y, x);
}

static ang atan_lerp(fx y, fx x)
{
    uint32_t t = slope(y, x);
    const ang *e = &ARCS[t >> 22];

    return unfold(e[0] + (ang)((uint64_t)(e[1] - e[0]) * (t & 0x3fffff) >> 22), y, x);
}

static ang atan_cordic(fx y, fx x)
{
    int64_t c = (int64_t)size_of(x) << 28, s = (int64_t)size_of(y) << 28, sum = 0;

    for (int k = 0; k < 40; k++) {
        int64_t dc = s >> k, ds = c >> k;
        bool back = s < 0;
        c += back ? -dc : dc;
        s -= back ? -ds : ds;
        sum += back ? -STEPS[k] : STEPS[k];
    }
    ang a = (ang)((sum + 0x8000) >> 16);
    a = x < 0 ? 0x80000000 - a : a;
    return y < 0 ? 0 - a : a;
}

static const double ANGS_A_RADIAN = 683565275.5764316;

RIVAL(atan2_square, atan_square(s->b, s->a))
RIVAL(atan2_256, atan_nearest(s->b, s->a))
RIVAL(atan2_1024, atan_lerp(s->b, s->a))
RIVAL(atan2_engine, trig_atan2(s->b, s->a))
RIVAL(atan2_twin, twin_atan2(s->b, s->a))
RIVAL(atan2_cordic, atan_cordic(s->b, s->a))
RIVAL(atan2_106, truth_atan2(s->b, s->a).near)
RIVAL(atan2_libm, (ang)whole(atan2(s->b, s->a) * ANGS_A_RADIAN))
RIVAL(atan2_libmf, (ang)whole_f(atan2f((float)s->b, (float)s->a) * (float)ANGS_A_RADIAN))
RIVAL_AS(atan2_lfm, fix16_atan2(s->b, s->a), (ang)whole(fix16_atan2(s->b, s->a) / 65536.0 * ANGS_A_RADIAN))

static const struct rival ATAN2[] = {
    ROW(CHEAPER, false, atan2_square, "a parabola", "up to 0.22°", "rotating a sprite"),
    ROW(CHEAPER, false, atan2_256, "257 entries, nearest", "1 KiB of RAM; up to 0.11°", "an 8-bit look"),
    ROW(CHEAPER, false, atan2_1024, "1025 entries, interpolated", "4 KiB of RAM; 5 of 32 bits",
        "16-bit angles, which it nearly always rounds correctly"),
    ROW(ENGINE, false, atan2_engine, "trig_atan2", "nothing", "every scene"),
    ROW(DEARER, false, atan2_twin, "the engine's integer twin", "time", "processors without hardware doubles"),
    ROW(DEARER, false, atan2_cordic, "CORDIC, 40 steps", "up to 0.001 units; time", "processors without a divider"),
    ROW(ORACLE, false, atan2_106, "106 bits", "time", "test oracles"),
    ROW(LIBRARY, true, atan2_libm, "libm atan2", "portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, true, atan2_libmf, "libm atan2f", "9 of 32 bits; portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, false, atan2_lfm, "libfixmath", "up to 0.58°; time", "rotating a sprite"),
};
ROWS(rivals_atan2, ATAN2);

/* ---- speed and direction to a velocity ---- */

static inline fx times_30(fx speed, int32_t part)
{
    int64_t p = (int64_t)speed * part;

    return wrap((p + (1 << 29) + (p >> 63)) >> 30);
}

static void polar_cordic_of(fx speed, ang a, fx *x, fx *y)
{
    int64_t c, s;

    cordic((speed * (CORDIC_ONE >> 10) + (1 << 7)) >> 8, a, &c, &s);
    *x = (fx)((c + (1 << 23)) >> 24);
    *y = (fx)((s + (1 << 23)) >> 24);
}

RIVAL_2(polar_256, (x = wrap((int64_t)s->a * SINES_256[(ang)(s->dir + QUARTER) >> 24] >> 16),
                    y = wrap((int64_t)s->a * SINES_256[s->dir >> 24] >> 16)))
RIVAL_2(polar_float, (x = (fx)whole_f((float)s->a * cosf((float)s->radians)),
                      y = (fx)whole_f((float)s->a * sinf((float)s->radians))))
RIVAL_2(polar_q16, (x = fx_mul(s->a, trig_cos(s->dir)), y = fx_mul(s->a, trig_sin(s->dir))))
RIVAL_2(polar_64k,
        (x = fx_mul(s->a, SINES_64K[(ang)(s->dir + QUARTER) >> 16]), y = fx_mul(s->a, SINES_64K[s->dir >> 16])))
RIVAL_2(polar_q30, (x = times_30(s->a, trig_cos30(s->dir)), y = times_30(s->a, trig_sin30(s->dir))))
RIVAL_2(polar_engine, trig_polar(s->a, s->dir, &x, &y))
RIVAL_2(polar_twin, twin_polar(s->a, s->dir, &x, &y))
RIVAL_2(polar_cordic, polar_cordic_of(s->a, s->dir, &x, &y))
RIVAL_2(polar_106, (x = (fx)exact(truth_sin((int64_t)s->a * 65536, s->dir + QUARTER)),
                    y = (fx)exact(truth_sin((int64_t)s->a * 65536, s->dir))))
RIVAL_2(polar_libm, (x = (fx)whole(s->a * cos(s->radians)), y = (fx)whole(s->a * sin(s->radians))))
RIVAL_2(polar_lfm, (x = fix16_smul(s->a, fix16_cos(s->rad)), y = fix16_smul(s->a, fix16_sin(s->rad))))

static const struct rival POLAR[] = {
    ROW(CHEAPER, false, polar_256, "256 entries, truncated", "1 KiB of RAM; up to 1.4°",
        "an 8-bit look: headings are up to 1.4° off"),
    ROW(ENGINE, false, polar_engine, "trig_polar", "nothing", "every scene; motion.def{ fine=true } for more bits"),
    ROW(DEARER, false, polar_64k, "speed × Q16 table of 65,536", "256 KiB of RAM; up to 0.0027°; time",
        "a 16-bit look: headings are up to 0.0027° off"),
    ROW(DEARER, false, polar_q16, "speed × Q16 sine", "accuracy at high speeds; time",
        "avoid: the speed multiplies the sine's rounding error"),
    ROW(DEARER, false, polar_q30, "speed × Q30 sine", "a second rounding; time", "code that already has a 30-bit sine"),
    ROW(DEARER, false, polar_twin, "the engine's integer twin", "time", "processors without hardware doubles"),
    ROW(DEARER, false, polar_cordic, "CORDIC, 40 steps", "time", "processors without a multiplier"),
    ROW(ORACLE, false, polar_106, "106 bits", "time", "test oracles"),
    ROW(LIBRARY, true, polar_libm, "libm sin and cos", "portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, true, polar_float, "libm sinf and cosf", "8 of 32 bits; portability: results differ between hosts",
        "a game without replays: C libraries give different results, even on the same machine"),
    ROW(LIBRARY, false, polar_lfm, "libfixmath", "7 of 16 bits of the sine; time", "avoid"),
};
ROWS(rivals_polar, POLAR);

/* ---- normalising ---- */

static inline void unit_by_max(fx vx, fx vy, fx *x, fx *y)
{
    fx size = hypot_max(vx, vy);

    *x = size ? wrap((int64_t)vx * FX_ONE / size) : 0;
    *y = size ? wrap((int64_t)vy * FX_ONE / size) : 0;
}

static inline void unit_by_float(fx vx, fx vy, fx *x, fx *y)
{
    float fx_ = (float)vx, fy = (float)vy, scale = 65536 / sqrtf(fx_ * fx_ + fy * fy);

    *x = (fx)whole_f(fx_ * scale);
    *y = (fx)whole_f(fy * scale);
}

static inline void unit_by_double(fx vx, fx vy, fx *x, fx *y)
{
    double scale = 65536 / sqrt((double)vx * vx + (double)vy * vy);

    *x = (fx)whole(vx * scale);
    *y = (fx)whole(vy * scale);
}

static inline void unit_by_division(fx vx, fx vy, fx *x, fx *y)
{
    fx size = fx_hypot(vx, vy);

    *x = fx_div(vx, size);
    *y = fx_div(vy, size);
}

static inline void unit_by_reciprocal(fx vx, fx vy, fx *x, fx *y)
{
    fx scale = fx_div(FX_ONE, fx_hypot(vx, vy));

    *x = fx_mul(vx, scale);
    *y = fx_mul(vy, scale);
}

static inline void unit_by_lfm(fx vx, fx vy, fx *x, fx *y)
{
    fx size = hypot_lfm_of(vx, vy);

    *x = fix16_sdiv(vx, size);
    *y = fix16_sdiv(vy, size);
}

RIVAL_2(unit_max, unit_by_max(s->a, s->b, &x, &y))
RIVAL_2(unit_float, unit_by_float(s->a, s->b, &x, &y))
RIVAL_2(unit_double, unit_by_double(s->a, s->b, &x, &y))
RIVAL_2(unit_recip, unit_by_reciprocal(s->a, s->b, &x, &y))
RIVAL_2(unit_div, unit_by_division(s->a, s->b, &x, &y))
RIVAL_2(unit_engine, trig_normalise(s->a, s->b, &x, &y))
RIVAL_2(unit_twin, twin_normalise(s->a, s->b, &x, &y))
RIVAL_2(unit_106, (x = (fx)exact(truth_unit(s->a, s->b)), y = (fx)exact(truth_unit(s->b, s->a))))
RIVAL_2(unit_lfm, unit_by_lfm(s->a, s->b, &x, &y))

static const struct rival NORMALISE[] = {
    ROW(CHEAPER, false, unit_max, "over larger + ⅜ smaller", "6 % of the length",
        "avoid: the results differ in length"),
    ROW(CHEAPER, false, unit_float, "float32", "8 of 32 bits", "directions in visual effects"),
    ROW(CHEAPER, false, unit_double, "double, rounded", "the exact check that the rounding is correct",
        "a game without replays: results near ties may be rounded the wrong way"),
    ROW(CHEAPER, false, unit_recip, "times 1 / length in Q15.16", "accuracy of long vectors",
        "avoid: long vectors are inaccurate"),
    ROW(CHEAPER, false, unit_div, "over fx_hypot", "accuracy of short vectors", "avoid: short vectors are inaccurate"),
    ROW(ENGINE, false, unit_engine, "trig_normalise", "nothing", "every scene"),
    ROW(DEARER, false, unit_twin, "the engine's integer twin", "time", "processors without hardware doubles"),
    ROW(ORACLE, false, unit_106, "106 bits", "time", "test oracles"),
    ROW(LIBRARY, false, unit_lfm, "libfixmath: over the root", "lengths beyond 181 px; time",
        "avoid: squares overflow beyond 181 px"),
};
ROWS(rivals_normalise, NORMALISE);

/* ---- between two values ---- */

RIVAL(lerp_32, wrap((int64_t)s->a + ((int64_t)wrap((int64_t)s->b - s->a) * s->t >> 16)))
RIVAL(lerp_up, wrap(s->a + ((((int64_t)s->b - s->a) * s->t + 0x8000) >> 16)))
RIVAL(lerp_float, wrap(whole_f((float)s->a + ((float)s->b - (float)s->a) * ((float)s->t / 65536))))
RIVAL(lerp_two, wrap((int64_t)wrap((int64_t)s->a *(FX_ONE - s->t) >> 16) + wrap((int64_t)s->b * s->t >> 16)))
RIVAL(lerp_engine, fx_lerp(s->a, s->b, s->t))
RIVAL(lerp_double, fx_sat(whole(s->a + ((double)s->b - s->a) * (s->t / 65536.0))))
RIVAL(lerp_106, exact(truth_lerp(s->a, s->b, s->t)))
RIVAL(lerp_lfm, fix16_lerp16(s->a, s->b, (uint16_t)s->t))

static const struct rival LERP[] = {
    ROW(CHEAPER, false, lerp_32, "truncated, 32-bit difference", "accuracy: half an ulp too low on average; range",
        "values less than 32768 px apart, where half an ulp does not matter"),
    ROW(CHEAPER, false, lerp_up, "64 bits, half up, wraps", "ties; overflow",
        "0 ≤ t ≤ 1, where ties need not round symmetrically"),
    ROW(CHEAPER, false, lerp_two, "a (1 − t) + b t, both truncated", "accuracy: one ulp too low on average",
        "avoid: not even monotonic"),
    ROW(ENGINE, false, lerp_engine, "fx_lerp", "nothing", "every scene"),
    ROW(DEARER, false, lerp_float, "float32", "8 of 32 bits", "colours, volumes"),
    ROW(DEARER, false, lerp_double, "double, saturates", "ties",
        "avoid: no more accurate than rounding half up, and conversions cost extra"),
    ROW(ORACLE, false, lerp_106, "106 bits", "time", "test oracles"),
    ROW(LIBRARY, false, lerp_lfm, "libfixmath (t < 1)", "accuracy: half an ulp too low on average; t = 1; time",
        "avoid: truncates, and treats t = 1 as 0"),
};
ROWS(rivals_lerp, LERP);

/* ---- degrees ---- */

static inline ang degrees_engine_of(double deg)
{
    ang a = 0;

    trig_from_degrees(deg, &a);
    return a;
}

RIVAL(degrees_cut, (ang)(int64_t)(s->deg *(4294967296.0 / 360)))
RIVAL(degrees_16, (ang)(uint64_t)whole(s->deg *(65536.0 / 360)) << 16)
RIVAL(degrees_float, (ang)(int64_t)whole_f((float)s->deg *(4294967296.0f / 360)))
RIVAL(degrees_double, (ang)(int64_t)whole(s->deg *(4294967296.0 / 360)))
RIVAL(degrees_engine, degrees_engine_of(s->deg))
RIVAL(degrees_106, (ang)truth_degrees(s->deg).near)
RIVAL(degrees_libm, (ang)(int64_t)whole(remainder(s->deg, 360) * 0.017453292519943295 * ANGS_A_RADIAN))
RIVAL(degrees_libmf, (ang)(int64_t)whole_f(remainderf((float)s->deg, 360) * 0.017453293f * (float)ANGS_A_RADIAN))
RIVAL_AS(degrees_lfm, fix16_deg_to_rad(fix16_from_dbl(s->deg)),
         (ang)whole(fix16_deg_to_rad(fix16_from_dbl(s->deg)) / 65536.0 * ANGS_A_RADIAN))

static const struct rival DEGREES[] = {
    ROW(CHEAPER, false, degrees_16, "16-bit angle", "16 of 32 bits", "a 16-bit look"),
    ROW(CHEAPER, false, degrees_float, "float32", "8 of 32 bits", "rotating sprites"),
    ROW(CHEAPER, false, degrees_cut, "double, truncated", "accuracy: half a unit too close to 0 on average",
        "avoid: 180° must be exactly half a turn"),
    ROW(CHEAPER, false, degrees_double, "double, times 2³²/360", "ties; angles beyond 2³¹°",
        "angles up to 2³¹° where ties do not matter"),
    ROW(ENGINE, false, degrees_engine, "trig_from_degrees", "nothing", "every scene; any finite number of degrees"),
    ROW(ORACLE, false, degrees_106, "106 bits", "time", "test oracles"),
    ROW(LIBRARY, false, degrees_libm, "through radians, double", "two more roundings; time",
        "avoid: rounds three times"),
    ROW(LIBRARY, false, degrees_libmf, "through radians, float32", "8 of 32 bits; time", "avoid"),
    ROW(LIBRARY, false, degrees_lfm, "libfixmath, to radians", "20 of 32 bits; time",
        "avoid: its π/180 has only 11 bits"),
};
ROWS(rivals_degrees, DEGREES);

/* ---- angles: a difference, and degrees of one ---- */

/* As degrees from -180 to 180, in angs. */
static inline ang angs_of(double deg)
{
    return (ang)whole(deg * (4294967296.0 / 360));
}

RIVAL(difference_16, (ang)(((ang)s->a >> 16) - (s->dir >> 16)) << 16)
RIVAL(difference_engine, (ang)trig_difference(s->dir, (ang)s->a))
RIVAL_AS(difference_double, (int64_t)remainder(s->other - s->deg, 360), angs_of(remainder(s->other - s->deg, 360)))
RIVAL_AS(difference_float, (int64_t)remainderf((float)s->other - (float)s->deg, 360),
         angs_of((double)remainderf((float)s->other - (float)s->deg, 360)))

static const struct rival DIFFERENCE[] = {
    ROW(ENGINE, false, difference_engine, "trig_difference", "nothing",
        "every scene; nothing is cheaper than a subtraction"),
    ROW(DEARER, false, difference_16, "16-bit angles", "16 of 32 bits", "a 16-bit look"),
    ROW(DEARER, false, difference_double, "double degrees, remainder", "time", "scripts"),
    ROW(DEARER, false, difference_float, "float32 degrees, remainderf", "8 of 32 bits; time", "avoid"),
};
ROWS(rivals_difference, DIFFERENCE);

/* In 2^-29 degrees, of which every angle has a whole number. */
#define IN_DEGREES(id, DEGREES) RIVAL_AS(id, (int64_t)(DEGREES), whole((DEGREES)*536870912.0))

static inline double degrees_lfm_of(fix16_t rad)
{
    fix16_t deg = fix16_rad_to_deg(rad);

    return (deg < 0 ? deg + 360 * 65536 : deg) / 65536.0;
}

IN_DEGREES(to_degrees_float, (double)((float)s->dir *(360 / 4294967296.0f)))
IN_DEGREES(to_degrees_engine, trig_to_degrees(s->dir))
IN_DEGREES(to_degrees_lfm, degrees_lfm_of(s->rad))

static const struct rival TO_DEGREES[] = {
    ROW(CHEAPER, false, to_degrees_float, "float32", "8 of 32 bits", "rotating sprites"),
    ROW(ENGINE, false, to_degrees_engine, "trig_to_degrees", "nothing",
        "every scene; all 2³² values survive a round trip through a script (section 7)"),
    ROW(LIBRARY, false, to_degrees_lfm, "libfixmath, from radians", "17 of 32 bits; time", "avoid"),
};
ROWS(rivals_to_degrees, TO_DEGREES);

/* ---- tables ---- */

void rivals_begin(void)
{
    for (uint32_t i = 0; i < 256; i++)
        SINES_256[i] = (fx)truth_sin((int64_t)1 << 32, i << 24).near;
    for (uint32_t i = 0; i <= 1024; i++)
        SINES_1024[i] = (fx)truth_sin((int64_t)1 << 32, i << 22).near;
    for (uint32_t i = 0; i < 65536; i++)
        SINES_64K[i] = (fx)truth_sin((int64_t)1 << 32, i << 16).near;
    for (int32_t i = 0; i <= 1024; i++)
        ARCS[i] = (ang)truth_atan2(i, 1024).near;
    ARCS[1025] = ARCS[1024];
    for (int k = 0; k < 48; k++) { /* beyond 2^-30 the arc tangent is its argument */
        struct truth t = truth_atan2(k <= 30 ? 1 << (30 - k) : 1, 1 << 30);
        double angs = (double)t.near + t.rest;
        for (int j = 30; j < k; j++)
            angs /= 2;
        STEPS[k] = (int64_t)(angs * 65536 + 0.5);
    }
}

/*
 * trig_columns.c - directions, polar coordinates and strides of many at once; the same bits as one by one.
 * floor: base
 *
 * The guesses are those of trig.c, taken apart into loops that gcc and clang vectorise at -O2 without flags: restrict
 * parameters, a constant trip count, no branch; what looks something up has loops of its own. A guess in doubt is left
 * to the functions that do one at a time. What a guess may be off stands there, but for strides, whose guesses are made
 * here. What is over after whole LANES goes with some of those before once more, or one by one.
 */
#include "trig.h"

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
#include "trig_tables.h"

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

/* |v|, but 0 for FX_MIN. */
static inline int32_t size_of(fx v)
{
    const uint32_t sign = (uint32_t)(v >> 31);

    return (int32_t)((((uint32_t)v ^ sign) - sign) & FX_MAX);
}

/* t = the shorter part by the longer. Returns 0 if some vector has none that is longer than 0, or FX_MIN for one. */
static int32_t slopes(const fx *restrict y, const fx *restrict x, double *restrict t)
{
    int32_t odd = 0;

    for (int i = 0; i < LANES; i++) {
        const int32_t ax = size_of(x[i]), ay = size_of(y[i]), low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;
        odd |= -(high == 0) | -(x[i] == FX_MIN) | -(y[i] == FX_MIN);
        t[i] = (double)low / (double)(high | -(high == 0));
    }
    return ~odd;
}

/* Turns atan(low / high) into the direction of (x, y). */
static void mirror(const fx *restrict y, const fx *restrict x, ang *restrict a)
{
    for (int i = 0; i < LANES; i++) {
        const uint32_t steep = (uint32_t) - (size_of(x[i]) < size_of(y[i]));
        const uint32_t left = (uint32_t)(x[i] >> 31), up = (uint32_t)(y[i] >> 31);
        const uint32_t first = (a[i] ^ steep) - steep + (steep & 0x40000000);
        const uint32_t half = (first ^ left) - left + (left & 0x80000000);
        a[i] = (half ^ up) - up;
    }
}

/*
 * Guesses, in 2^-24 of an ang, become whole angs; doubtful: those within 5000 of another, as trig.c has it, and 8 more,
 * for they are looked at in steps of 4. Returns 0 if none is.
 */
static int32_t cut(const double *restrict guess, ang *restrict a, int32_t *restrict doubtful)
{
    const uint32_t doubt = 1252;
    int32_t any = 0;

    for (int i = 0; i < LANES; i++) {
        const uint64_t steps = bits_of(guess[i] + 27021597764222976.0); /* 1.5 * 2^54: its last bit is 4 */
        const uint32_t rest = ((uint32_t)steps << 10) + (doubt << 10);
        a[i] = (ang)(steps >> 22) - 0x60000000; /* what 1.5 * 2^54 is in these bits */
        doubtful[i] = -((int32_t)(rest ^ 0x80000000) <= (int32_t)(doubt << 11 ^ 0x80000000));
        any |= doubtful[i];
    }
    return any;
}

static void turns(const fx *y, const fx *x, ang *a)
{
    const double cells = 105553116266496.0;
    double t[LANES], guess[LANES];
    int32_t doubtful[LANES];

    if (!slopes(y, x, t)) {
        for (int i = 0; i < LANES; i++)
            a[i] = trig_atan2(y[i], x[i]);
        return;
    }
    for (int i = 0; i < LANES; i++) {
        const double sum = t[i] + cells, h = t[i] - (sum - cells), hh = h * h;
        const double *c = ARC[bits_of(sum) & 127];
        guess[i] = (c[0] + c[1] * h) + hh * ((c[2] + c[3] * h) + hh * c[4]);
    }
    const int32_t any = cut(guess, a, doubtful);
    mirror(y, x, a);
    for (int i = 0; any && i < LANES; i++)
        if (doubtful[i])
            a[i] = trig_atan2(y[i], x[i]);
}

void trig_atan2s(const fx *y, const fx *x, ang *a, int n)
{
    int i = 0;

    for (; i + LANES <= n; i += LANES)
        turns(y + i, x + i, a + i);
    if (i && n - i >= LANES / 2) { /* some of them again */
        turns(y + n - LANES, x + n - LANES, a + n - LANES);
        return;
    }
    for (; i < n; i++)
        a[i] = trig_atan2(y[i], x[i]);
}

/* ---- polar coordinates ---- */

/* Of the step from the nearest ray. */
static void steps_of(const ang *restrict dir, double *restrict sine, double *restrict versine)
{
    for (int i = 0; i < LANES; i++) {
        const double h = (int32_t)(dir[i] << 8), hh = h * h;
        sine[i] = (RAY_STEP.a + RAY_STEP.b * hh) * h;
        versine[i] = (RAY_STEP.c + RAY_STEP.d * hh) * hh;
    }
}

/* In steps of 2^-10, as trig_polar does it; which are in doubt? Returns 0 if none is. */
static int32_t products(const fx *restrict speed, const double *restrict x, const double *restrict y, fx *restrict vx,
                        fx *restrict vy, int32_t *restrict doubtful)
{
    int32_t any = 0;

    for (int i = 0; i < LANES; i++) {
        const double v = speed[i];
        const uint64_t in_x = bits_of(v * x[i] + 6597069766656.5), in_y = bits_of(v * y[i] + 6597069766656.5);
        vx[i] = (fx)(in_x >> 10);
        vy[i] = (fx)(in_y >> 10);
        doubtful[i] = -(((uint32_t)in_x & 1023) == 0) | -(((uint32_t)in_y & 1023) == 0) | -(speed[i] == FX_MIN);
        any |= doubtful[i];
    }
    return any;
}

static void polars(const fx *speed, const ang *dir, fx *vx, fx *vy)
{
    double sine[LANES], versine[LANES], x[LANES], y[LANES];
    int32_t doubtful[LANES];

    steps_of(dir, sine, versine);
    for (int i = 0; i < LANES; i++) {
        const double *ray = RAY[(ang)(dir[i] + 0x800000) >> 24];
        const double c = ray[0], s = ray[1];
        x[i] = c - (c * versine[i] + s * sine[i]);
        y[i] = s + (c * sine[i] - s * versine[i]);
    }
    const int32_t any = products(speed, x, y, vx, vy, doubtful);
    for (int i = 0; any && i < LANES; i++)
        if (doubtful[i])
            trig_polar(speed[i], dir[i], &vx[i], &vy[i]);
}

void trig_polars(const fx *speed, const ang *dir, fx *vx, fx *vy, int n)
{
    int i = 0;

    for (; i + LANES <= n; i += LANES)
        polars(speed + i, dir + i, vx + i, vy + i);
    if (i && n - i >= LANES / 2) {
        i = n - LANES;
        polars(speed + i, dir + i, vx + i, vy + i);
        return;
    }
    for (; i < n; i++)
        trig_polar(speed[i], dir[i], &vx[i], &vy[i]);
}

/* ---- strides ---- */

/* An angle of a quarter as the eighth from the nearer axis on: trig.c's heading_of. */
static inline uint32_t eighth_of(ang dir)
{
    const uint32_t u = dir & 0x3fffffff, past = 0 - (u >> 29);

    return (u ^ past) - past + (past & 0x40000000);
}

/* Sine of what eighth_of(dir) is beyond the last of the 513 directions, less than 2^-9.3, and one less its cosine. */
static void parts_beyond(const ang *restrict dir, double *restrict sine, double *restrict versine)
{
    for (int i = 0; i < LANES; i++) {
        const double r = (double)(int32_t)(eighth_of(dir[i]) & 0xfffff) * 0x1.921fb54442d18p-30, rr = r * r;
        sine[i] = r - r * (rr * (1.0 / 6 - rr * (1.0 / 120)));
        versine[i] = rr * (0.5 - rr * (1.0 / 24 - rr * (1.0 / 720)));
    }
}

/* Cosine and sine of an eighth become those of the direction. */
static void unfold(const ang *restrict dir, double *restrict cosine, double *restrict sine)
{
    for (int i = 0; i < LANES; i++) {
        const uint64_t c = bits_of(cosine[i]), s = bits_of(sine[i]);
        const uint64_t swap = 0 - (uint64_t)((dir[i] ^ dir[i] << 1) >> 30 & 1), change = (c ^ s) & swap;
        cosine[i] = double_of(c ^ change ^ (uint64_t)((dir[i] + 0x40000000) >> 31) << 63);
        sine[i] = double_of(s ^ change ^ (uint64_t)(dir[i] >> 31) << 63);
    }
}

/* Within 2^-52.4: the directions are cut to 53 bits, the last sum is rounded to them, and all else is below 2^-60. */
static void circles(const ang *dir, double *cosine, double *sine)
{
    double along[LANES], back[LANES];

    parts_beyond(dir, along, back);
    for (int i = 0; i < LANES; i++) {
        const uint64_t *way = WAY[eighth_of(dir[i]) >> 20];
        const double c = (double)(int64_t)(way[0] >> 11) * 0x1p-53, s = (double)(int64_t)(way[1] >> 11) * 0x1p-53;
        cosine[i] = c - (c * back[i] + s * along[i]);
        sine[i] = s + (c * along[i] - s * back[i]);
    }
    unfold(dir, cosine, sine);
}

/* A length as a double, exactly: |v| <= 2^48. */
static inline double length_of(int64_t v)
{
    return double_of((uint64_t)v + 0x4338000000000000) - 6755399441055744.0; /* 1.5 * 2^52 has no bits below one */
}

/*
 * d = `to` times the part less `from` times it, each rounded. Such a product is off by less than 2^-52.4 of its length,
 * and by 2^-53 of it for its own rounding: one that is within 2^-51 of its length of halfway is doubtful. Returns 0 if
 * none is.
 */
static uint64_t spans(const int64_t *restrict from, const int64_t *restrict to, const double *restrict part,
                      int64_t *restrict d, uint64_t *restrict doubtful)
{
    uint64_t any = 0;

    for (int i = 0; i < LANES; i++) {
        const double a = length_of(from[i]), b = length_of(to[i]), x = a * part[i], y = b * part[i];
        const double whole_x = x + 6755399441055744.0, whole_y = y + 6755399441055744.0;
        const double left_x = 0.5 - fabs(x - (whole_x - 6755399441055744.0)) - fabs(a) * 0x1p-51;
        const double left_y = 0.5 - fabs(y - (whole_y - 6755399441055744.0)) - fabs(b) * 0x1p-51;
        d[i] = (int64_t)(bits_of(whole_y) - bits_of(whole_x));
        doubtful[i] = (bits_of(left_x) | bits_of(left_y)) >> 63;
        any |= doubtful[i];
    }
    return any;
}

static void strides(const int64_t *from, const int64_t *to, const ang *dir, int64_t *dx, int64_t *dy)
{
    double cosine[LANES], sine[LANES];
    uint64_t doubtful[2][LANES];

    circles(dir, cosine, sine);
    const uint64_t any = spans(from, to, cosine, dx, doubtful[0]) | spans(from, to, sine, dy, doubtful[1]);
    for (int i = 0; any && i < LANES; i++)
        if (doubtful[0][i] | doubtful[1][i])
            trig_stride(from[i], to[i], dir[i], &dx[i], &dy[i]);
}

void trig_strides(const int64_t *from, const int64_t *to, const ang *dir, int64_t *dx, int64_t *dy, int n)
{
    int i = 0;

    for (; i + LANES <= n; i += LANES)
        strides(from + i, to + i, dir + i, dx + i, dy + i);
    if (i && n - i >= LANES / 2) {
        i = n - LANES;
        strides(from + i, to + i, dir + i, dx + i, dy + i);
        return;
    }
    for (; i < n; i++)
        trig_stride(from[i], to[i], dir[i], &dx[i], &dy[i]);
}
#endif

/*
 * shapes.c - the contact tests of geom.h against shapes_oracle.h, near contact, at the ends of the domain and at
 * random.
 *
 *     shapes [--sample] [--only SHAPE] [--threads N]     30 million cases a shape; --sample: 100,000
 *     shapes --shortcuts                                 what a cheaper circle test gets wrong
 *
 * Cases come from fixed seeds, a chunk a seed, so that neither the number of threads nor the order of chunks shows. A
 * third of a chunk is near contact: of a case and a neighbour with the other answer, which differ in one argument, that
 * argument is bisected to two values one unit apart; these two are tried, and one more on either side. Exit 1: a wrong
 * answer, or cases too one-sided to show anything.
 */
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../../src/base/geom.h"
#include "shapes_oracle.h"

enum { MOST_ARGUMENTS = 9, THIRD = 4096, MOST_THREADS = 64 };
enum { NEAR, ENDS, RANDOM, KINDS };
static const int64_t PIXEL = 65536, FULL_CASES = 30000000, SAMPLE_CASES = 100000;

/* ---- chance ---- */

struct dice {
    uint64_t state;
};

/* splitmix64, Steele, Lea and Flood 2014. */
static uint64_t roll(struct dice *d)
{
    uint64_t z = d->state += 0x9e3779b97f4a7c15;

    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

static int64_t between(struct dice *d, int64_t low, int64_t high)
{
    return low + (int64_t)(roll(d) % (uint64_t)(high - low + 1));
}

static bool one_in(struct dice *d, int n)
{
    return between(d, 1, n) == 1;
}

static int64_t either_sign(struct dice *d, int64_t v)
{
    return one_in(d, 2) ? v : -v;
}

/* ---- shapes ---- */

/*
 * What a case consists of, as drawn and as placed: two shapes a and b, a starts at d seen from b and moves by w. Half
 * their bars are h and g. Which of these are arguments is the shape's choice.
 */
enum role { DX, DY, WX, WY, HX, HY, GX, GY, R, HW, HH, AX, AY, BX, BY, EX, EY, R1, R2, HW1, HH1, HW2, HH2, ROLES };

struct shape {
    const char *name;
    bool (*tried)(const int64_t *), (*oracle)(const int64_t *);
    int64_t low, high;   /* coordinates */
    int64_t fast;        /* most of |wx|, |wy| */
    int64_t large, half; /* most of r, hw, hh, and of what they are the sum of */
    int n;
    enum role role[MOST_ARGUMENTS];
};

static bool try_circles(const int64_t *v)
{
    return geom_circles((fx)v[0], (fx)v[1], (fx)v[2], (fx)v[3], (fx)v[4]);
}

static bool right_circles(const int64_t *v)
{
    return oracle_disc(v[0] - v[2], v[1] - v[3], v[4]);
}

static bool try_boxes(const int64_t *v)
{
    return geom_boxes((fx)v[0], (fx)v[1], (fx)v[2], (fx)v[3], (fx)v[4], (fx)v[5], (fx)v[6], (fx)v[7]);
}

static bool right_boxes(const int64_t *v)
{
    return oracle_boxes(v, v + 4);
}

static bool try_circle_box(const int64_t *v)
{
    return geom_circle_box((fx)v[0], (fx)v[1], (fx)v[2], (fx)v[3], (fx)v[4], (fx)v[5], (fx)v[6]);
}

static bool right_circle_box(const int64_t *v)
{
    return oracle_round_box(v[0] - v[3], v[1] - v[4], v[2], v[5], v[6]);
}

static bool try_swept_circles(const int64_t *v)
{
    return geom_swept_circles(v[0], v[1], v[2], v[3], v[4]);
}

static bool right_swept_circles(const int64_t *v)
{
    return oracle_swept_disc(v[0], v[1], v[2], v[3], v[4]);
}

static bool try_capsule(const int64_t *v)
{
    return geom_capsule_circle((fx)v[0], (fx)v[1], (fx)v[2], (fx)v[3], (fx)v[4], (fx)v[5], (fx)v[6], (fx)v[7]);
}

static bool right_capsule(const int64_t *v)
{
    if (v[4] < 0 || v[7] < 0)
        return false;
    return oracle_swept_disc(v[0] - v[5], v[1] - v[6], v[2] - v[0], v[3] - v[1], v[4] + v[7]);
}

static bool try_swept_circle_box(const int64_t *v)
{
    return geom_swept_circle_box(v[0], v[1], v[2], v[3], v[4], v[5], v[6]);
}

static bool right_swept_circle_box(const int64_t *v)
{
    return oracle_swept_round_box(v[0], v[1], v[2], v[3], v[4], v[5], v[6]);
}

static bool try_swept_boxes(const int64_t *v)
{
    return geom_swept_boxes(v[0], v[1], v[2], v[3], v[4], v[5]);
}

static bool right_swept_boxes(const int64_t *v)
{
    return oracle_swept_box(v[0], v[1], v[2], v[3], v[4], v[5]);
}

static bool try_swept_capsule(const int64_t *v)
{
    return geom_swept_capsule(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]);
}

static bool right_swept_capsule(const int64_t *v)
{
    return oracle_swept_bar(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]);
}

static bool try_swept_capsules(const int64_t *v)
{
    return geom_swept_capsules(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]);
}

static bool right_swept_capsules(const int64_t *v)
{
    return oracle_swept_bars(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]);
}

/* From d to d + h/2, and at the end from d + w to d + w + g/2. */
static bool try_turned_bar(const int64_t *v)
{
    const struct geom_bar bar = { .ax = v[0],
                                  .ay = v[1],
                                  .ux = v[2],
                                  .uy = v[3],
                                  .bx = v[0] + v[4] / 2,
                                  .by = v[1] + v[5] / 2,
                                  .vx = v[2] + v[6] / 2 - v[4] / 2,
                                  .vy = v[3] + v[7] / 2 - v[5] / 2 };

    return geom_swept_bar(&bar, v[8]);
}

static bool right_turned_bar(const int64_t *v)
{
    int64_t p[4][2] = { { v[0], v[1] },
                        { v[0] + v[4] / 2, v[1] + v[5] / 2 },
                        { v[0] + v[2] + v[6] / 2, v[1] + v[3] + v[7] / 2 },
                        { v[0] + v[2], v[1] + v[3] } };

    return oracle_turned_bar(p, v[8]);
}

#define FAR   ((int64_t)1 << 61) /* as far as a start may be */
#define FAST  ((int64_t)1 << 31)
#define WORLD ((int64_t)1 << 30) /* 16384 pixels */
#define BAR   (WORLD / 2)        /* half of one */

static const struct shape SHAPES[] = {
    { "circle-circle", try_circles, right_circles, FX_MIN, FX_MAX, 0, FX_MAX, 0, 5, { AX, AY, BX, BY, R } },
    { "box-box",
      try_boxes,
      right_boxes,
      FX_MIN,
      FX_MAX,
      0,
      2 * (int64_t)FX_MAX,
      FX_MAX,
      8,
      { AX, AY, HW1, HH1, BX, BY, HW2, HH2 } },
    { "circle-box", try_circle_box, right_circle_box, FX_MIN, FX_MAX, 0, FX_MAX, 0, 7, { AX, AY, R, BX, BY, HW, HH } },
    { "swept-circles", try_swept_circles, right_swept_circles, -FAR, FAR, FAST, WORLD, 0, 5, { DX, DY, WX, WY, R } },
    { "capsule-circle",
      try_capsule,
      right_capsule,
      -WORLD,
      WORLD,
      FAST,
      WORLD,
      WORLD / 2,
      8,
      { AX, AY, EX, EY, R1, BX, BY, R2 } },
    { "swept-circle-box",
      try_swept_circle_box,
      right_swept_circle_box,
      -FAR,
      FAR,
      FAST,
      WORLD,
      0,
      7,
      { DX, DY, WX, WY, R, HW, HH } },
    { "swept-boxes", try_swept_boxes, right_swept_boxes, -FAR, FAR, FAST, WORLD, 0, 6, { DX, DY, WX, WY, HW, HH } },
    { "swept-capsule",
      try_swept_capsule,
      right_swept_capsule,
      -FAR / 2,
      FAR / 2,
      FAST,
      WORLD,
      0,
      9,
      { DX, DY, WX, WY, HX, HY, R, HW, HH } },
    { "swept-capsules",
      try_swept_capsules,
      right_swept_capsules,
      -FAR / 4,
      FAR / 4,
      FAST,
      WORLD,
      0,
      9,
      { DX, DY, WX, WY, HX, HY, GX, GY, R } },
    { "turned-bar",
      try_turned_bar,
      right_turned_bar,
      -FAR / 4,
      FAR / 4,
      FAST / 4,
      WORLD,
      0,
      9,
      { DX, DY, WX, WY, HX, HY, GX, GY, R } },
};
enum { SHAPE_COUNT = sizeof SHAPES / sizeof *SHAPES };

static bool has(const struct shape *s, enum role role)
{
    for (int i = 0; i < s->n; i++)
        if (s->role[i] == role)
            return true;
    return false;
}

static bool has_corners(const struct shape *s)
{
    return has(s, HW) || has(s, HW1);
}

static bool is_round(const struct shape *s)
{
    return has(s, R) || has(s, R1);
}

/* Draws half the bars that the shape has, up to `most` long on either axis. */
static void draw_bars(struct dice *d, const struct shape *s, int64_t most, int64_t *c)
{
    most = most > BAR ? BAR : most;
    for (enum role role = HX; role <= GY; role++)
        c[role] = has(s, role) && !one_in(d, 16) ? between(d, -most, most) : 0;
}

/* What the argument may be. */
static void limits(const struct shape *s, enum role role, int64_t *low, int64_t *high)
{
    bool length = role == R || role == HW || role == HH, part = role >= R1, way = role == WX || role == WY;
    bool bar = role >= HX && role <= GY;

    *high = length ? s->large : part ? s->half : way ? s->fast : bar ? BAR : s->high;
    *low = length || part ? -2 : way ? -s->fast : bar ? -BAR : s->low;
}

/*
 * Both ends of a's way and b on one axis, d and w being given: anywhere the coordinates go, or as near to an end of
 * them as it can be. False: it does not fit.
 */
static bool place_axis(struct dice *dice, const struct shape *s, int64_t *c, enum role axis, bool at_end)
{
    int64_t d = c[DX + axis], e = d + c[WX + axis], least = d < e ? d : e, most = d < e ? e : d;
    int64_t low = s->low - (least < 0 ? least : 0), high = s->high - (most > 0 ? most : 0);

    if (low > high)
        return false;
    c[BX + axis] = at_end ? (one_in(dice, 2) ? low : high) : between(dice, low, high);
    c[AX + axis] = c[BX + axis] + d;
    c[EX + axis] = c[BX + axis] + e;
    return true;
}

/* A length as the sum of two. */
static void split(struct dice *dice, const struct shape *s, int64_t *c, enum role sum, enum role first,
                  enum role second, bool at_end)
{
    int64_t low = c[sum] > s->half ? c[sum] - s->half : 0, high = c[sum] - low;

    c[first] = at_end || high < low ? (one_in(dice, 2) ? low : high) : between(dice, low, high);
    c[second] = c[sum] - c[first];
}

/* The arguments of what was drawn. */
static bool place(struct dice *dice, const struct shape *s, int64_t *c, bool at_end, int64_t *v)
{
    for (enum role axis = 0; axis < 2; axis++)
        if (has(s, AX) && !place_axis(dice, s, c, axis, at_end))
            return false;
    split(dice, s, c, R, R1, R2, at_end);
    split(dice, s, c, HW, HW1, HW2, at_end);
    split(dice, s, c, HH, HH1, HH2, at_end);
    for (int i = 0; i < s->n; i++) {
        int64_t low, high;

        limits(s, s->role[i], &low, &high);
        v[i] = c[s->role[i]];
        if (v[i] < low || v[i] > high)
            return false;
    }
    return true;
}

/* ---- cases ---- */

/* As in a game: a field of 384 x 448 pixels. */
static void draw_game(struct dice *d, const struct shape *s, int64_t *c)
{
    int64_t most = one_in(d, 3) ? 160 : 32, speed = one_in(d, 3) ? 64 : 8, apart = one_in(d, 3) ? 384 : most;

    c[DX] = between(d, -apart * PIXEL, apart * PIXEL);
    c[DY] = between(d, -apart * PIXEL, apart * PIXEL);
    c[WX] = between(d, -speed * PIXEL, speed * PIXEL);
    c[WY] = between(d, -speed * PIXEL, speed * PIXEL);
    c[R] = between(d, 0, most * PIXEL);
    c[HW] = between(d, 0, most * PIXEL);
    c[HH] = between(d, 0, most * PIXEL);
    draw_bars(d, s, most * PIXEL, c);
}

/* All of a size, from one unit to the whole domain. */
static void draw_scaled(struct dice *d, const struct shape *s, int64_t *c)
{
    int64_t size = (int64_t)1 << between(d, 1, 32), large = size < s->large ? size : s->large;
    int64_t fast = size < s->fast ? size : s->fast, apart = one_in(d, 2) ? large : size;

    apart >>= !is_round(s) || !has_corners(s);

    c[DX] = between(d, -apart, apart);
    c[DY] = between(d, -apart, apart);
    c[WX] = between(d, -fast, fast);
    c[WY] = between(d, -fast, fast);
    c[R] = between(d, 0, large);
    c[HW] = between(d, 0, large);
    c[HH] = between(d, 0, large);
    draw_bars(d, s, apart, c);
}

/*
 * In contact at one point, exactly. The path runs along (p, q), p^2 + q^2 = h^2, and the point of contact lies across
 * it, and so does a's bar; p, q and h are whole for m^2 - n^2, 2mn, m^2 + n^2.
 */
static void draw_touching(struct dice *d, const struct shape *s, int64_t *c)
{
    int64_t m = between(d, 1, 20), n = between(d, 0, m), h = m * m + n * n;
    int64_t p = either_sign(d, m * m - n * n), q = either_sign(d, 2 * m * n);
    int64_t most = (s->large >> between(d, 0, 29)) / h, out = is_round(s) ? between(d, 0, most) : 0;
    int64_t along = s->fast ? between(d, 0, most) : 0, way = s->fast ? between(d, 0, along) : 0;
    bool corner = has_corners(s);

    c[R] = out * h;
    c[HW] = corner ? between(d, 0, most * h) : 0;
    c[HH] = corner ? between(d, 0, most * h) : 0;
    c[DX] = q * out - p * way + (q < 0 || (q == 0 && one_in(d, 2)) ? -c[HW] : c[HW]);
    c[DY] = -p * out - q * way + (p > 0 || (p == 0 && one_in(d, 2)) ? -c[HH] : c[HH]);
    c[WX] = p * along;
    c[WY] = q * along;
    draw_bars(d, s, most * h, c);
    for (enum role bar = HX; bar <= GX; bar += 2) {
        int64_t side = c[bar] * q - c[bar + 1] * p < 0 ? -1 : 1; /* its end that is away from b, so that the other ends
                                                                    where the path was */
        c[DX] += side * c[bar];
        c[DY] += side * c[bar + 1];
    }
}

/* All along one line, the bars and the way to b too: what is swept has no inside. */
static void draw_flat(struct dice *d, int64_t *c)
{
    int64_t p = between(d, -9, 9), q = between(d, -9, 9), unit = (int64_t)1 << between(d, 0, 20);

    for (enum role role = DX; role <= GY; role += 2) {
        int64_t length = unit * between(d, -20, 20);

        c[role] = p * length;
        c[role + 1] = q * length;
    }
    c[R] = between(d, 0, 9 * unit);
    c[HW] = between(d, 0, 9 * unit);
    c[HH] = between(d, 0, 9 * unit);
}

/* A number of which much depends, or up to two beside it. */
static int64_t an_end(struct dice *d, int64_t most)
{
    const int64_t ENDS_OF[] = { 0,     0,        8191 * PIXEL, 16382 * PIXEL, 16383 * PIXEL, 32766 * PIXEL,
                                WORLD, most / 2, most,         most };
    int64_t v = ENDS_OF[between(d, 0, (int)(sizeof ENDS_OF / sizeof *ENDS_OF) - 1)] + between(d, -2, 2);

    return v > most ? most : v;
}

/* Each number at an end of what it may be; what lies within one in 16 is far beyond contact. */
static void draw_ends(struct dice *d, const struct shape *s, int64_t *c)
{
    int64_t apart = s->high - s->low < 4 * WORLD ? s->high - s->low : one_in(d, 16) ? s->high : 6 * WORLD;

    c[R] = an_end(d, s->large);
    c[HW] = an_end(d, s->large);
    c[HH] = an_end(d, s->large);
    c[WX] = either_sign(d, an_end(d, s->fast));
    c[WY] = either_sign(d, an_end(d, s->fast));
    for (enum role bar = HX; bar <= GY; bar++)
        c[bar] = has(s, bar) ? either_sign(d, an_end(d, BAR)) : 0;
    for (enum role axis = 0; axis < 2; axis++) {
        int64_t way = -c[WX + axis], reach = c[one_in(d, 2) ? HW + axis : R];

        c[DX + axis] = either_sign(d, one_in(d, 2) ? an_end(d, apart) : an_end(d, reach > 0 ? reach : 0));
        c[DX + axis] += one_in(d, 2) ? way : 0;
    }
}

static void draw_case(struct dice *d, const struct shape *s, int kind, int64_t *v)
{
    int64_t c[ROLES];
    int64_t how;

    do {
        how = between(d, 0, 3);
        if (kind == ENDS)
            draw_ends(d, s, c);
        else if (has(s, HX) && one_in(d, 16))
            draw_flat(d, c);
        else if (kind == NEAR && how == 0)
            draw_touching(d, s, c);
        else if (how == 1)
            draw_game(d, s, c);
        else
            draw_scaled(d, s, c);
        if (s->fast == 0)
            c[WX] = c[WY] = 0;
    } while (!place(d, s, c, kind == ENDS || one_in(d, 4), v));
}

/* ---- counting ---- */

struct tally {
    int64_t hits[KINDS], cases[KINDS], wrong;
    int64_t first_chunk; /* of the first wrong answer */
    int64_t first[MOST_ARGUMENTS];
};

static void count(const struct shape *s, const int64_t *v, int kind, int64_t chunk, struct tally *t)
{
    bool hit = s->oracle(v);

    t->cases[kind]++;
    t->hits[kind] += hit;
    if (s->tried(v) == hit)
        return;
    if (t->wrong++ == 0) {
        t->first_chunk = chunk;
        memcpy(t->first, v, sizeof t->first);
    }
}

/* Another value of argument k, for which the answer is not `hit`; false: none found. */
static bool other_side(struct dice *d, const struct shape *s, int64_t *v, int k, bool hit)
{
    int64_t low, high, was = v[k];

    limits(s, s->role[k], &low, &high);
    for (int i = 0; i < 6; i++) {
        int64_t step = (int64_t)(roll(d) >> between(d, 30, 62));

        v[k] = was + (one_in(d, 2) ? step : -step);
        v[k] = v[k] < low ? low : v[k] > high ? high : v[k];
        if (s->oracle(v) != hit)
            return true;
    }
    v[k] = was;
    return false;
}

static const int64_t *with(int64_t *v, int k, int64_t value)
{
    v[k] = value;
    return v;
}

/* Two cases on either side of a contact, or one where the shapes are too thin for more; returns how many in all. */
static int near_contact(struct dice *d, const struct shape *s, int64_t chunk, struct tally *t)
{
    int64_t v[MOST_ARGUMENTS] = { 0 }, here, there, low, high;

    draw_case(d, s, NEAR, v);

    int k = (int)between(d, 0, s->n - 1);
    bool hit = s->oracle(v);

    here = v[k];
    if (!other_side(d, s, v, k, hit))
        return 0;
    there = v[k];
    while (there - here > 1 || here - there > 1) {
        v[k] = here + (there - here) / 2;
        if (s->oracle(v) == hit)
            here = v[k];
        else
            there = v[k];
    }
    count(s, with(v, k, here), NEAR, chunk, t);
    count(s, with(v, k, there), NEAR, chunk, t);

    int64_t before = 2 * here - there, after = 2 * there - here;

    limits(s, s->role[k], &low, &high);
    if (before < low || before > high || after < low || after > high || s->oracle(with(v, k, before)) != hit ||
        s->oracle(with(v, k, after)) == hit)
        return 2;
    count(s, with(v, k, before), NEAR, chunk, t);
    count(s, with(v, k, after), NEAR, chunk, t);
    return 4;
}

static void run_chunk(const struct shape *s, int64_t chunk, struct tally *t)
{
    struct dice d = { (uint64_t)chunk * 0xd1342543de82ef95 + (uint64_t)(s - SHAPES) };
    int64_t v[MOST_ARGUMENTS] = { 0 };

    roll(&d);
    for (int i = 0; i < THIRD;)
        i += near_contact(&d, s, chunk, t);
    for (int kind = ENDS; kind <= RANDOM; kind++)
        for (int i = 0; i < THIRD; i++) {
            draw_case(&d, s, kind, v);
            count(s, v, kind, chunk, t);
        }
}

/* Chunks are taken in turn by all threads. */
struct crew {
    const struct shape *shape;
    atomic_llong next;
    int64_t chunks;
};

struct worker {
    struct crew *crew;
    struct tally tally;
};

static void *work(void *arg)
{
    struct worker *w = arg;
    int64_t chunk;

    while ((chunk = atomic_fetch_add(&w->crew->next, 1)) < w->crew->chunks)
        run_chunk(w->crew->shape, chunk, &w->tally);
    return NULL;
}

static void add_tally(struct tally *sum, const struct tally *t)
{
    for (int kind = 0; kind < KINDS; kind++) {
        sum->hits[kind] += t->hits[kind];
        sum->cases[kind] += t->cases[kind];
    }
    if (t->wrong && (!sum->wrong || t->first_chunk < sum->first_chunk)) {
        sum->first_chunk = t->first_chunk;
        memcpy(sum->first, t->first, sizeof sum->first);
    }
    sum->wrong += t->wrong;
}

static struct tally run_shape(const struct shape *s, int64_t cases, int threads)
{
    struct crew crew = { .shape = s, .chunks = (cases + 3 * THIRD - 1) / (3 * THIRD) };
    static struct worker workers[MOST_THREADS];
    pthread_t id[MOST_THREADS];
    struct tally sum = { .wrong = 0 };

    for (int i = 0; i < threads; i++) {
        workers[i] = (struct worker){ .crew = &crew };
        if (pthread_create(&id[i], NULL, work, &workers[i]) != 0) {
            fprintf(stderr, "shapes: no thread\n");
            exit(2);
        }
    }
    for (int i = 0; i < threads; i++) {
        pthread_join(id[i], NULL);
        add_tally(&sum, &workers[i].tally);
    }
    return sum;
}

static double percent(int64_t part, int64_t whole)
{
    return 100.0 * (double)part / (double)whole;
}

/* False: a wrong answer, or too few of one. */
static bool report(const struct shape *s, const struct tally *t)
{
    int64_t cases = t->cases[NEAR] + t->cases[ENDS] + t->cases[RANDOM];
    int64_t hits = t->hits[NEAR] + t->hits[ENDS] + t->hits[RANDOM];
    double share = percent(hits, cases), near = percent(t->hits[NEAR], t->cases[NEAR]);
    bool fair = share >= 30 && share <= 70 && near == 50;

    printf("%-16s %9lld %6.1f %6.1f %11lld %9lld %6.1f %6.1f %11lld\n", s->name, (long long)cases, share, 100 - share,
           (long long)t->hits[NEAR], (long long)(t->cases[NEAR] - t->hits[NEAR]),
           percent(t->hits[ENDS], t->cases[ENDS]), percent(t->hits[RANDOM], t->cases[RANDOM]), (long long)t->wrong);
    if (!fair)
        printf("    too one-sided\n");
    if (t->wrong) {
        printf("    wrong for");
        for (int i = 0; i < s->n; i++)
            printf(" %lld", (long long)t->first[i]);
        printf(": %s\n", s->oracle(t->first) ? "they touch" : "they do not touch");
    }
    fflush(stdout);
    return fair && t->wrong == 0;
}

static bool prove(int64_t cases, const char *only, int threads)
{
    bool good = true;

    printf("%-16s %9s %6s %6s %11s %9s %6s %6s %11s\n", "", "", "hits", "misses", "hits near", "misses", "hits % of",
           "", "");
    printf("%-16s %9s %6s %6s %11s %9s %6s %6s %11s\n", "shape", "cases", "%", "%", "contact", "there", "ends",
           "random", "mismatches");
    for (int i = 0; i < SHAPE_COUNT; i++)
        if (!only || strcmp(only, SHAPES[i].name) == 0) {
            struct tally t = run_shape(&SHAPES[i], cases, threads);

            good &= report(&SHAPES[i], &t);
        }
    return good;
}

/* ---- shortcuts ---- */

/* As written down without a thought: everything in Q15.16, what does not fit cut off. */
static bool q16_wrapping(fx x1, fx y1, fx x2, fx y2, fx r)
{
    int64_t dx = (int32_t)((uint32_t)x1 - (uint32_t)x2), dy = (int32_t)((uint32_t)y1 - (uint32_t)y2);
    uint32_t xx = (uint32_t)((dx * dx + 0x8000) >> 16), yy = (uint32_t)((dy * dy + 0x8000) >> 16);

    return (int32_t)(xx + yy) <= (int32_t)(((int64_t)r * r + 0x8000) >> 16);
}

static bool q16_saturating(fx x1, fx y1, fx x2, fx y2, fx r)
{
    fx dx = fx_sub(x1, x2), dy = fx_sub(y1, y2);

    return fx_add(fx_mul(dx, dx), fx_mul(dy, dy)) <= fx_mul(r, r);
}

/* As geom_circles, without the boxes before: what does not fit 64 bits is cut off. */
static bool u64_without_box(fx x1, fx y1, fx x2, fx y2, fx r)
{
    uint64_t dx = geom_gap(x1, x2), dy = geom_gap(y1, y2), limit = (uint64_t)(int64_t)r;

    return dx * dx + dy * dy <= limit * limit;
}

static const struct {
    const char *name;
    bool (*hit)(fx x1, fx y1, fx x2, fx y2, fx r);
    int64_t fails; /* from this distance on, in pixels */
} SHORTCUTS[] = {
    { "wraps", q16_wrapping, 182 },
    { "saturates", q16_saturating, 182 },
    { "no box", u64_without_box, 65536 },
};
enum { SHORTCUT_COUNT = sizeof SHORTCUTS / sizeof *SHORTCUTS };

/* How many of `runs` cases with centres low..high pixels apart each gets wrong: at any such radius, or within 2
 * units. */
static void shortcut_band(int64_t low, int64_t high, int64_t runs, bool near, int64_t *wrong)
{
    const struct shape *s = &SHAPES[0];
    struct dice d = { (uint64_t)low * 2 + near };
    int64_t c[ROLES] = { 0 }, v[MOST_ARGUMENTS];

    for (int i = 0; i < runs;) {
        c[DX] = either_sign(&d, between(&d, 0, high * PIXEL - 1));
        c[DY] = either_sign(&d, between(&d, 0, high * PIXEL - 1));
        c[R] = 0;
        if (oracle_disc(c[DX], c[DY], low * PIXEL) || !oracle_disc(c[DX], c[DY], high * PIXEL) ||
            !place(&d, s, c, false, v))
            continue;

        double apart = sqrt((double)c[DX] * (double)c[DX] + (double)c[DY] * (double)c[DY]);

        v[4] = near ? (int64_t)apart + between(&d, -1, 2) : between(&d, 0, 2 * (int64_t)apart);
        v[4] = !near && v[4] > high * PIXEL ? between(&d, 0, high * PIXEL) : v[4];
        v[4] = v[4] > FX_MAX ? FX_MAX : v[4];
        for (int k = 0; k < SHORTCUT_COUNT; k++)
            wrong[k] += SHORTCUTS[k].hit((fx)v[0], (fx)v[1], (fx)v[2], (fx)v[3], (fx)v[4]) != s->oracle(v);
        i++;
    }
}

/* False: a shortcut is right where it should fail, or the other way round. */
static bool shortcuts(int64_t runs)
{
    static const int64_t BANDS[] = { 0, 16, 64, 128, 181, 182, 256, 512, 2048, 16384, 46341, 65536, 92681 };
    bool shown = true;

    printf("\nWrong answers of cheaper circle tests in %%, by the distance of the centres: squares in Q15.16 that wrap "
           "or\n"
           "saturate, and 64-bit squares without the box test first. Left: any radius up to the end of the band and\n"
           "twice the distance. Right: within 2 units of contact.\n"
           "\n"
           "%-14s",
           "pixels");
    for (int k = 0; k < 2 * SHORTCUT_COUNT; k++)
        printf("%s %10s", k == SHORTCUT_COUNT ? " |" : "", SHORTCUTS[k % SHORTCUT_COUNT].name);
    for (size_t i = 0; i + 1 < sizeof BANDS / sizeof *BANDS; i++) {
        int64_t wrong[2 * SHORTCUT_COUNT] = { 0 };

        shortcut_band(BANDS[i], BANDS[i + 1], runs, false, wrong);
        shortcut_band(BANDS[i], BANDS[i + 1], runs, true, wrong + SHORTCUT_COUNT);
        printf("\n%6lld..%-6lld", (long long)BANDS[i], (long long)BANDS[i + 1]);
        for (int k = 0; k < 2 * SHORTCUT_COUNT; k++)
            printf("%s %10.4f", k == SHORTCUT_COUNT ? " |" : "", percent(wrong[k], runs));
        for (int k = 0; k < SHORTCUT_COUNT; k++)
            shown &= (BANDS[i + 1] > 181 || wrong[k] <= runs / 1000) &&
                     (BANDS[i] < SHORTCUTS[k].fails || wrong[k] >= runs / 100);
    }
    printf("\n");
    return shown;
}

static int usage(void)
{
    fprintf(stderr, "shapes [--sample] [--only SHAPE] [--threads N] | --shortcuts\n");
    return 2;
}

int main(int argc, char **argv)
{
    int64_t cases = FULL_CASES;
    const char *only = NULL;
    int threads = 2;

    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--sample") == 0)
            cases = SAMPLE_CASES;
        else if (strcmp(argv[i], "--only") == 0 && i + 1 < argc)
            only = argv[++i];
        else if (strcmp(argv[i], "--threads") == 0 && i + 1 < argc)
            threads = atoi(argv[++i]);
        else if (strcmp(argv[i], "--shortcuts") == 0 && argc == 2)
            return !shortcuts(1000000);
        else
            return usage();
    if (threads < 1 || threads > MOST_THREADS)
        return usage();

    bool good = prove(cases, only, threads);

    if (!only)
        good &= shortcuts(cases / 30);
    printf("\n%s\n", good ? "shapes: no mismatch" : "shapes: FAILED");
    return good ? 0 : 1;
}

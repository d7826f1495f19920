/*
 * bench_fx.c - Curtain's arithmetic against libfixmath's: `bench_fx ROM DEMO`. bench_fx.sh builds it.
 *
 * Every function of every side runs over the same 65,536 arguments, side after side, ROUNDS times; a ratio is theirs to
 * ours within one round, and its median counts. Two ways of running: free, where calls can overlap, and chained, where
 * each argument waits for the last result (which is masked to nothing, so that the arguments stay the same). Times are
 * of this thread's processor time.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../numbers.h"
#include "bench_fx.h"

enum { ROUNDS = 31, SIDES = 5 };

static const struct call *const sides[SIDES] = { ours, theirs_debian, theirs_o2, theirs_uncached, theirs_lut };
static const char *const side_names[SIDES] = { "Curtain", "Debian's", "-O2", "-O2 no cache", "-O2 sine table" };

static struct args args[2][OPS];
static const char *const set_names[2] = { "full range", "demo" };
static const char *const way_names[2] = { "free", "chained" };

static volatile int32_t fed = 15; /* which bits of a result go into the next argument */
static volatile uint32_t sink;

static bool there(int side)
{
    return sides[side][0].name;
}

static uint32_t bits(double v)
{
    uint64_t u;

    memcpy(&u, &v, sizeof u);
    return (uint32_t)(u >> 32);
}

/* A loop over the arguments, free or chained; i names the argument and w what of the last result is fed into it. */
#define LOOP(CALL)                                                                                                     \
    do {                                                                                                               \
        const int32_t mask = fed;                                                                                      \
        uint32_t sum = 0;                                                                                              \
        if (chained) {                                                                                                 \
            int32_t w = 0;                                                                                             \
            for (int i = 0; i < INPUTS; i++)                                                                           \
                w = (int32_t)(CALL)&mask;                                                                              \
            sum = (uint32_t)w;                                                                                         \
        } else {                                                                                                       \
            const int32_t w = 0;                                                                                       \
            for (int i = 0; i < INPUTS; i++)                                                                           \
                sum ^= (uint32_t)(CALL);                                                                               \
        }                                                                                                              \
        sink = sum;                                                                                                    \
    } while (0)

static void run(const struct call *c, const struct args *g, bool chained)
{
    const int32_t *a = c->shape == RADIANS ? g->rad : g->a, *b = g->b;

    switch (c->shape) {
    case ONE:
    case RADIANS:
        LOOP(c->f.one(a[i] ^ w));
        break;
    case TWO:
        LOOP(c->f.two(a[i] ^ w, b[i]));
        break;
    case ANGLE:
        LOOP(c->f.angle(a[i] ^ w, b[i]));
        break;
    case TURN:
        LOOP(c->f.turn((uint32_t)(a[i] ^ w)));
        break;
    case LERP:
        LOOP(c->f.lerp(a[i] ^ w, b[i], g->t[i]));
        break;
    case LERP16:
        LOOP(c->f.lerp16(a[i] ^ w, b[i], g->t[i]));
        break;
    case FROM_DOUBLE:
        LOOP(c->f.from_double(g->d[i ^ w]));
        break;
    case TO_DOUBLE:
        LOOP(bits(c->f.to_double(a[i] ^ w)));
        break;
    }
}

/* Nanoseconds a call. */
static double measure(const struct call *c, const struct args *g, bool chained)
{
    struct timespec start, end;

    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &start);
    run(c, g, chained);
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
    return ((double)(end.tv_sec - start.tv_sec) * 1e9 + (double)(end.tv_nsec - start.tv_nsec)) / INPUTS;
}

static double median(double v[ROUNDS])
{
    numbers_sort(v, ROUNDS);
    return v[ROUNDS / 2];
}

/* The worst ratio of a function: whose, where, and the quartiles of its rounds. */
struct worst {
    double ratio, low, high;
    int side, set, way;
};

static void keep_worst(struct worst *w, const struct worst *other)
{
    if (w->ratio == 0 || other->ratio < w->ratio)
        *w = *other;
}

/* One line: a function on one set of arguments, run one way. */
static void line(int op, int set, int way, struct worst *worst)
{
    static double ns[SIDES][ROUNDS], ratio[ROUNDS];

    for (int r = -1; r < ROUNDS; r++) /* -1 warms up */
        for (int s = 0; s < SIDES; s++)
            if (there(s))
                ns[s][r < 0 ? 0 : r] = measure(&sides[s][op], &args[set][op], way);
    printf("%-15s %-19s %-10s %-8s", ours[op].name, theirs_debian[op].name, set_names[set], way_names[way]);
    for (int s = 1; s < SIDES; s++) {
        if (!there(s))
            continue;
        for (int r = 0; r < ROUNDS; r++)
            ratio[r] = ns[s][r] / ns[0][r];
        struct worst w = { median(ratio), 0, 0, s, set, way };
        w.low = ratio[ROUNDS / 4];
        w.high = ratio[ROUNDS * 3 / 4];
        keep_worst(worst, &w);
        double copy[ROUNDS];
        memcpy(copy, ns[s], sizeof copy);
        printf("  %7.2f %6.2f", median(copy), w.ratio);
    }
    printf("  %7.2f\n", median(ns[0]));
}

static void say_worst(const char *head, int op, const struct worst *w)
{
    printf("%s%-15s %-19s %6.2f  (%.2f to %.2f)  %s, %s, %s\n", head, ours[op].name, theirs_debian[op].name, w->ratio,
           w->low, w->high, side_names[w->side], set_names[w->set], way_names[w->way]);
}

/* Within 2 % is the same: some of these functions are one and the same instruction. */
static void conclude(const struct worst worst[OPS])
{
    static const char *const verdict[3] = { "slower", "as fast", "faster" };
    int n[3] = { 0 };

    for (int v = 2; v >= 0; v--) {
        printf("%s:", verdict[v]);
        for (int op = 0; op < OPS; op++)
            if (v == (worst[op].ratio < 0.98 ? 0 : worst[op].ratio <= 1.02 ? 1 : 2)) {
                printf(" %s/%s", ours[op].name, theirs_debian[op].name);
                n[v]++;
            }
        printf("%s\n", n[v] ? "" : " none");
    }
    printf("Curtain is faster than libfixmath on %d of %d functions, as fast on %d, slower on %d\n", n[2], OPS, n[1],
           n[0]);
}

int main(int argc, char **argv)
{
    struct worst worst[OPS] = { { 0 } };
    int most = 0;

    if (argc != 3) {
        fprintf(stderr, "usage: bench_fx ROM DEMO\n");
        return 2;
    }
    inputs_random(args[0]);
    inputs_recorded(argv[1], argv[2], args[1]);
    printf("nanoseconds a call and how many times Curtain's; medians of %d rounds over %d arguments\n\n", ROUNDS,
           INPUTS);
    printf("%-15s %-19s %-10s %-8s", "Curtain", "libfixmath", "arguments", "run");
    for (int s = 1; s < SIDES; s++)
        if (there(s))
            printf("  %14s", side_names[s]);
    printf("  Curtain\n");
    for (int op = 0; op < OPS; op++)
        for (int set = 0; set < 2; set++)
            for (int way = 0; way < 2; way++)
                line(op, set, way, &worst[op]);
    printf("\nthe worst ratio of each function, its quartiles, and where it was\n\n");
    for (int op = 0; op < OPS; op++) {
        say_worst("", op, &worst[op]);
        if (worst[op].ratio < worst[most].ratio)
            most = op;
    }
    say_worst("\nworst of all: ", most, &worst[most]);
    conclude(worst);
    return 0;
}

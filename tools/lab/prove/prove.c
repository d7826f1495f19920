/*
 * prove.c - the harness of the proof programs.
 *
 * Threads take chunks by number from a counter. Each has tallies of its own, added up when all are done, and each chunk
 * its own stream of random numbers, so that what is tried does not depend on who tries it.
 */
#include <inttypes.h>
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "oracle.h"

enum { THREADS_MOST = 64 };

static bool sampled;
static uint64_t seed = 1, phases;
static int threads = 2;
static const char *hard_file;
static struct tally total[PROVE_TALLIES];
static uint64_t all_wrong;
static double since;

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static void tally_clear(struct tally *t)
{
    memset(t, 0, sizeof *t);
    t->nearest = 0.5;
    t->keep = 1;
}

static void keep_hard(struct tally *t, double off, struct prove_case c)
{
    int at;

    if (t->hards == PROVE_HARD && off >= t->off[PROVE_HARD - 1])
        return;
    for (int i = 0; i < t->hards; i++)
        if (t->hard[i].a == c.a && t->hard[i].b == c.b)
            return;
    at = t->hards < PROVE_HARD ? t->hards++ : PROVE_HARD - 1;
    for (; at > 0 && t->off[at - 1] > off; at--) {
        t->off[at] = t->off[at - 1];
        t->hard[at] = t->hard[at - 1];
    }
    t->off[at] = off;
    t->hard[at] = c;
}

/* What is near a tie comes here, and before there is such an input, what is nearer than all before. */
void tally_near(struct tally *t, double off, int64_t a, int64_t b)
{
    t->near += off < PROVE_NEAR;
    t->ties += off == 0;
    if (off == 0 || off >= 0.5)
        return;
    t->nearest = off < t->nearest ? off : t->nearest;
    t->keep = t->nearest < PROVE_NEAR ? PROVE_NEAR : t->nearest;
    keep_hard(t, off, (struct prove_case){ a, b });
}

void tally_wrong(struct tally *t, double error, int64_t a, int64_t b, int64_t got, int64_t want)
{
    t->tried++;
    t->wrong++;
    t->worst = error > t->worst ? error : t->worst;
    if (t->wrongs < PROVE_WRONG) {
        t->first[t->wrongs].input = (struct prove_case){ a, b };
        t->first[t->wrongs].got = got;
        t->first[t->wrongs++].want = want;
    }
}

static void tally_add(struct tally *to, const struct tally *t)
{
    to->tried += t->tried;
    to->wrong += t->wrong;
    to->ties += t->ties;
    to->near += t->near;
    to->by_mpfr += t->by_mpfr;
    to->worst = t->worst > to->worst ? t->worst : to->worst;
    to->nearest = t->nearest < to->nearest ? t->nearest : to->nearest;
    for (int i = 0; i < t->hards; i++)
        keep_hard(to, t->off[i], t->hard[i]);
    for (int i = 0; i < t->wrongs && to->wrongs < PROVE_WRONG; i++)
        to->first[to->wrongs++] = t->first[i];
}

struct phase {
    prove_chunk *f;
    uint64_t chunks, runs;
    atomic_uint_fast64_t next;
};

struct worker {
    pthread_t thread;
    struct phase *phase;
    struct tally t[PROVE_TALLIES];
};

static uint64_t chosen(const struct phase *p, uint64_t run, uint64_t *random)
{
    if (p->runs == p->chunks || run == 0)
        return run;
    return run == 1 ? p->chunks - 1 : numbers_random(random) % p->chunks;
}

static void *work(void *arg)
{
    struct worker *w = arg;
    struct phase *p = w->phase;
    uint64_t run;

    while ((run = atomic_fetch_add(&p->next, 1)) < p->runs) {
        uint64_t random = (seed * 1000 + phases) * 0x2545f4914f6cdd1d + run * 0xd1342543de82ef95;

        p->f(chosen(p, run, &random), w->t, &random);
        if (!sampled && isatty(2) && run % (p->runs / 200 + 1) == 0)
            fprintf(stderr, "\r%5.1f %% \r", 100.0 * (double)run / (double)p->runs);
    }
    oracle_thread_ends();
    return NULL;
}

void prove_phase(prove_chunk *f, uint64_t chunks, uint64_t sample)
{
    static struct worker w[THREADS_MOST];
    struct phase p = { f, chunks, sampled && sample < chunks ? sample : chunks, 0 };

    phases++;
    for (int i = 0; i < threads; i++) {
        w[i].phase = &p;
        for (int k = 0; k < PROVE_TALLIES; k++)
            tally_clear(&w[i].t[k]);
        if (pthread_create(&w[i].thread, NULL, work, &w[i])) {
            perror("pthread_create");
            exit(2);
        }
    }
    for (int i = 0; i < threads; i++) {
        pthread_join(w[i].thread, NULL);
        for (int k = 0; k < PROVE_TALLIES; k++)
            tally_add(&total[k], &w[i].t[k]);
    }
}

bool prove_sampled(void)
{
    return sampled;
}

/* The inputs nearest to ties of earlier full runs. */
static const struct {
    const char *name;
    int64_t a, b;
} HARD[] = {
#include "hard.inc"
};

void prove_hard(int id, const char *name, prove_try *f)
{
    for (size_t i = 0; i < COUNT(HARD); i++)
        if (!strcmp(HARD[i].name, name))
            f(&total[id], HARD[i].a, HARD[i].b);
}

static void write_hard(const struct tally *t, const char *name)
{
    FILE *f = fopen(hard_file, "a");

    if (!f) {
        perror(hard_file);
        exit(2);
    }
    for (int i = 0; i < t->hards; i++)
        fprintf(f, "{ \"%s\", %" PRId64 ", %" PRId64 " },\n", name, t->hard[i].a, t->hard[i].b);
    fclose(f);
}

/* Cut, not rounded, to 10 digits: what is below one half does not look like it. */
static double cut(double v)
{
    return floor(v * 1e10) / 1e10;
}

void prove_line(int id, const char *name, const char *how)
{
    struct tally *t = &total[id];
    double most = t->nearest < 0x1p-40 ? nextafter(0.5, 0) : 0.5 - t->nearest;
    double worst = t->wrong ? t->worst : t->ties ? 0.5 : most;

    printf("%-18s %12" PRIu64 " inputs, %" PRIu64 " misrounded, worst %.10f ulp, ", name, t->tried, t->wrong,
           cut(worst));
    printf("%" PRIu64 " ties, %" PRIu64 " within 2^-16 of one", t->ties, t->near);
    if (t->nearest < 0.5)
        printf(", nearest 2^%.2f", log2(t->nearest));
    if (t->by_mpfr)
        printf(", %" PRIu64 " with MPFR", t->by_mpfr);
    printf(": %s (%.1f s)\n", how, now() - since);
    for (int i = 0; i < t->wrongs; i++)
        printf("    %s of %" PRId64 ", %" PRId64 " is %" PRId64 ", not %" PRId64 "\n", name, t->first[i].input.a,
               t->first[i].input.b, t->first[i].got, t->first[i].want);
    fflush(stdout);
    if (hard_file && t->hards)
        write_hard(t, name);
    all_wrong += t->wrong;
    tally_clear(t);
}

static int usage(const char *program)
{
    fprintf(stderr, "usage: %s [--sample] [--seed N] [--threads N] [--only NAME] [--hard FILE]\n", program);
    return 2;
}

int prove_main(int argc, char **argv, const struct proof *proofs, int n)
{
    const char *only = NULL;
    bool found = false;

    for (int i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--sample"))
            sampled = true;
        else if (i + 1 == argc)
            return usage(argv[0]);
        else if (!strcmp(argv[i], "--seed"))
            seed = strtoull(argv[++i], NULL, 0);
        else if (!strcmp(argv[i], "--threads"))
            threads = atoi(argv[++i]);
        else if (!strcmp(argv[i], "--only"))
            only = argv[++i];
        else if (!strcmp(argv[i], "--hard"))
            hard_file = argv[++i];
        else
            return usage(argv[0]);
    }
    if (threads < 1 || threads > THREADS_MOST)
        return usage(argv[0]);
    for (int k = 0; k < PROVE_TALLIES; k++)
        tally_clear(&total[k]);
    for (int i = 0; i < n; i++) {
        if (only && strcmp(only, proofs[i].name))
            continue;
        found = true;
        since = now();
        phases = 100 * (uint64_t)i; /* the same inputs with --only and without */
        proofs[i].prove();
    }
    oracle_thread_ends();
    if (!found)
        return usage(argv[0]);
    return all_wrong != 0;
}

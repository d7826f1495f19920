/*
 * all.c - see all.h. Each document has a process of its own, which puts what it finds into memory that all share.
 */
#include "all.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

const double all_rank[ALL_RANKS] = { 0, 0.35, 0.5, 1 };

static struct side_setup setup_of(const struct all_setup *a, int document, int rank)
{
    return (struct side_setup){ a->documents->path[document], all_rank[rank], a->seed, a->loop };
}

static void fail(struct compared *out, const struct side *s)
{
    *out = (struct compared){ .failed = true };
    snprintf(out->what, sizeof out->what, "%s", s->error);
}

static void beside_board(const struct side_setup *setup, struct compared *out)
{
    struct side a, b;

    if (!side_apart(&a, setup, ROUND_NEAREST)) {
        fail(out, &a);
        return;
    }
    if (!side_board(&b, setup)) {
        fail(out, &b);
        a.close(&a);
        return;
    }
    compare_sides(&a, &b, ALL_FRAMES, out);
}

static void beside_itself(const struct side_setup *setup, enum side_rounding rounding, struct compared *out)
{
    struct side a, b;

    if (!side_apart(&a, setup, ROUND_NEAREST)) {
        fail(out, &a);
        return;
    }
    if (!side_apart(&b, setup, rounding)) {
        fail(out, &b);
        a.close(&a);
        return;
    }
    compare_sides(&a, &b, ALL_FRAMES, out);
}

static void one(const struct all_setup *a, int document, struct all_result *out)
{
    bool ask = a->what == ALL_ROUNDINGS || list_has(a->exceptions, a->documents->path[document]);

    for (int r = 0; a->what == ALL_BOARD && r < ALL_RANKS; r++) {
        const struct side_setup setup = setup_of(a, document, r);
        beside_board(&setup, &out->board[r]);
        ask |= !compared_alike(&out->board[r]);
    }
    for (int r = 0; ask && r < ALL_RANKS; r++)
        for (int k = 1; k < SIDE_ROUNDINGS; k++) {
            const struct side_setup setup = setup_of(a, document, r);
            beside_itself(&setup, (enum side_rounding)k, &out->rounding[r][k]);
        }
    out->asked = ask;
}

static void crashed(struct all_result *out)
{
    for (int r = 0; r < ALL_RANKS; r++) {
        out->board[r].failed = true;
        snprintf(out->board[r].what, sizeof out->board[r].what, "the program that compares crashed");
    }
}

/* Waits for one process to end. */
static void await(struct all_result *results, const pid_t *who, int n)
{
    int status;
    const pid_t pid = wait(&status);

    for (int i = 0; i < n; i++)
        if (who[i] == pid && status)
            crashed(&results[i]);
}

struct all_result *all_compare(const struct all_setup *setup)
{
    const int n = setup->documents->n;
    pid_t *who = calloc((size_t)n, sizeof *who);
    struct all_result *out =
        mmap(NULL, (size_t)n * sizeof *out, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int running = 0;

    if (out == MAP_FAILED || !who) {
        free(who);
        return NULL;
    }
    for (int i = 0; i < n; i++) {
        if (setup->only && !strstr(setup->documents->path[i], setup->only))
            continue;
        if (running == setup->jobs) {
            await(out, who, n);
            running--;
        }
        fflush(NULL);
        who[i] = fork();
        if (!who[i]) {
            one(setup, i, &out[i]);
            _exit(0);
        }
        running += who[i] > 0;
        if (who[i] < 0)
            crashed(&out[i]);
    }
    for (; running; running--)
        await(out, who, n);
    free(who);
    return out;
}

void all_free(struct all_result *r, int n)
{
    munmap(r, (size_t)n * sizeof *r);
}

bool all_rounded_otherwise(const struct all_result *r, int rank)
{
    for (int k = 1; k < SIDE_ROUNDINGS; k++)
        if (!compared_alike(&r->rounding[rank][k]))
            return true;
    return false;
}

bool all_alike(const struct all_result *r)
{
    for (int k = 0; k < ALL_RANKS; k++)
        if (!compared_alike(&r->board[k]))
            return false;
    return true;
}

bool all_excused(const struct all_result *r)
{
    for (int k = 0; k < ALL_RANKS; k++)
        if (!compared_alike(&r->board[k]) && !all_rounded_otherwise(r, k))
            return false;
    return r->asked;
}

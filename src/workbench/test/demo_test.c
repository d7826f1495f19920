/*
 * demo_test.c - see demo_test.h.
 */
#include "demo_test.h"

#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "../../player/replay.h"
#include "../../common/files.h"
#include "golden.h"
#include "outcome.h"

struct demo_test {
    struct demo demo;
    struct replay replay;
    struct verdict verdict;
};

/* Writes the picture's name for "demos/a b.demo": "demo-a-b". */
static void picture_name(const char *name, char *out, size_t size)
{
    const char *base = strrchr(name, '/');

    snprintf(out, size, "demo-%.60s", base ? base + 1 : name);
    for (char *p = out; *p; p++) {
        if (strcmp(p, ".demo") == 0)
            *p = 0;
        else if (!strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-", *p))
            *p = '-';
        if (!*p)
            break;
    }
}

static void write_failure(const struct testing *t, const char *name, struct demo_test *d, FILE *out)
{
    const struct golden g = { .dir = t->dir, .out = out };
    char text[1400], warning[160], picture[80];

    replay_text(&d->replay, &d->demo, &d->verdict, text, sizeof text);
    const char *why = demo_replay_warning(&d->demo, &t->game->cart, warning, sizeof warning);
    outcome_write(out, LINE_FAILURE, "%s: %s%s%s%s", name, text, why ? " (" : "", why ? why : "", why ? ")" : "");
    if (d->verdict.kind == VERDICT_DIFFERS) {
        picture_name(name, picture, sizeof picture);
        golden_save_got(&g, d->replay.guard.board, picture);
    }
}

/* Returns how many frames were played. */
static uint32_t run(const struct testing *t, const char *name, struct demo_test *d, FILE *out)
{
    char err[600];

    if (!demo_check_cart(&d->demo, &t->game->cart, err, sizeof err)) {
        outcome_write(out, LINE_FAILURE, "%s: %s", name, err);
        return 0;
    }
    if (!d->demo.complete) {
        outcome_write(out, LINE_FAILURE, "%s: truncated: %u frames and no end mark", name, (unsigned)d->demo.frames);
        return 0;
    }
    const enum result result = replay_run(&d->replay, &t->game->cart, &d->demo, NULL, &d->verdict, err, sizeof err);
    if (result != RESULT_DONE)
        outcome_write(out, result == RESULT_HOST_FAILED ? LINE_HOST_ERROR : LINE_FAILURE, "%s: %s", name, err);
    else if (d->verdict.kind != VERDICT_HOLDS)
        write_failure(t, name, d, out);
    return result == RESULT_DONE ? d->verdict.frame : 0;
}

void demo_test_run(const struct testing *t, const char *name, FILE *out)
{
    const uint64_t start = plat_usec();
    char path[DEMO_PATH_SIZE], err[DEMO_ERR_SIZE + 200];
    struct demo_test *d = calloc(1, sizeof *d);
    uint32_t frames = 0;

    if (!d || snprintf(path, sizeof path, "%s/%s", t->dir, name) >= (int)sizeof path)
        outcome_write(out, LINE_HOST_ERROR, "%s: %s", name, d ? "path too long" : "out of memory");
    else if (!demo_load(&d->demo, path, err, sizeof err))
        outcome_write(out, LINE_FAILURE, "%s", err);
    else
        frames = run(t, name, d, out);
    outcome_write(out, LINE_COST, "%u %llu", (unsigned)frames, (unsigned long long)clock_since(start));
    if (d) {
        replay_close(&d->replay);
        demo_free(&d->demo);
    }
    free(d);
}

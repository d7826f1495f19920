/*
 * one_script.c - a script of tests/ as a test: what the board's trial.h asks of the cabinet.
 */
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../demo/demo.h"
#include "../../common/files.h"
#include "../../common/tree.h"
#include "../../player/run/guard.h"
#include "golden.h"
#include "one.h"

enum { TAKEN = 256, SCRIPTS = 64 };

/* A board that a script has begun. */
struct run {
    struct guard guard;
    struct demo demo;
    bool plays; /* the demo */
    void *snapshot, *output;
    size_t room; /* of the snapshot, bytes */
};

struct stage {
    const struct testing *t;
    FILE *out;
    struct golden golden;
    struct run run[TRIAL_RUNS];
    char taken[TAKEN][TRIAL_NAME + 8]; /* "one.png" */
    int n_taken;
    uint8_t *script[SCRIPTS]; /* that were required */
    int n_scripts;
};

static void close_run(struct run *r)
{
    free(r->snapshot);
    free(r->output);
    guard_close(&r->guard);
    demo_free(&r->demo);
    *r = (struct run){ 0 };
}

/* ---- scripts ---- */

static uint8_t *read_script(const struct testing *t, const char *name, size_t *n, char *err, size_t err_size)
{
    char path[FILES_PATH_SIZE];
    uint8_t *data;

    if (snprintf(path, sizeof path, "%s/%s", t->dir, name) >= (int)sizeof path) {
        err_set(err, err_size, "%s: path too long", name);
        return NULL;
    }
    return files_read_text(path, name, TREE_SCRIPT, &data, n, err, err_size) ? data : NULL;
}

static const char *required(void *context, const char *name, size_t *n)
{
    struct stage *s = context;
    char path[FILES_PATH_SIZE], err[FILES_ERR_SIZE];

    if (!manifest_path_ok(name) || s->n_scripts == SCRIPTS)
        return NULL;
    snprintf(path, sizeof path, "tests/%s.lua", name);
    s->script[s->n_scripts] = read_script(s->t, path, n, err, sizeof err);
    return (const char *)s->script[s->n_scripts++];
}

/* ---- runs ---- */

static bool load_demo(struct stage *s, struct run *r, const char *name, char *err, size_t err_size)
{
    char path[DEMO_PATH_SIZE], why[300];

    if (!manifest_path_ok(name))
        return err_set(err, err_size, "demo: expected a file of the game, as in \"demos/run.demo\", got \"%s\"", name);
    if (snprintf(path, sizeof path, "%s/%s", s->t->dir, name) >= (int)sizeof path)
        return err_set(err, err_size, "demo: path too long");
    if (!demo_load(&r->demo, path, err, err_size))
        return false;
    if (!demo_check_cart(&r->demo, s->t->cart, why, sizeof why))
        return err_set(err, err_size, "%s: %s", name, why);
    r->plays = true;
    return true;
}

static struct board *power(void *context, int run, const struct trial_start *want, uint32_t *frames, char *err,
                           size_t err_size)
{
    struct stage *s = context;
    struct run *r = &s->run[run];
    struct board_start start;

    close_run(r);
    if (want->demo ? !load_demo(s, r, want->demo, err, err_size)
                   : !s->t->start(s->t->user, want, &start, err, err_size))
        return NULL;
    if (!s->t->press(s->t->user, run, want->pads ? want->pads : "", err, err_size))
        return NULL;
    if (!guard_power(&r->guard, s->t->cart->rom, want->demo ? &r->demo.start : &start, err, err_size))
        return NULL;
    r->output = malloc(board_output_size());
    *frames = r->demo.frames;
    if (r->output)
        return r->guard.board;
    result_set_host_error(err, err_size, "out of memory");
    return NULL;
}

static bool press(void *context, int run, const char *list, char *err, size_t err_size)
{
    struct stage *s = context;

    if (s->run[run].plays && list[0])
        return err_set(err, err_size, "pads: not allowed with a demo, which contains its own input");
    return s->t->press(s->t->user, run, list, err, err_size);
}

static void tick(void *context, int run)
{
    struct stage *s = context;
    struct run *r = &s->run[run];
    const uint32_t frame = board_frame(r->guard.board);
    uint16_t pads[MAX_PLAYERS];

    if (r->plays)
        demo_pads(&r->demo, frame, pads);
    else
        s->t->pressed(s->t->user, run, frame, pads);
    guard_tick(&r->guard, pads);
}

static bool keep(void *context, int run)
{
    struct run *r = &((struct stage *)context)->run[run];
    const size_t size = board_snapshot_size(r->guard.board);

    if (size > r->room) {
        free(r->snapshot);
        r->snapshot = malloc(size);
        r->room = r->snapshot ? size : 0;
        if (!r->snapshot)
            return false;
    }
    board_save(r->guard.board, r->snapshot);
    board_output_save(r->guard.board, r->output);
    return true;
}

static void back(void *context, int run)
{
    struct run *r = &((struct stage *)context)->run[run];

    board_restore(r->guard.board, r->snapshot);
    board_output_restore(r->guard.board, r->output);
}

/* ---- what is kept ---- */

/* Each file is compared once. */
static bool take(struct stage *s, const char *name, const char *ending, char *err, size_t err_size)
{
    char file[TRIAL_NAME + 8];

    snprintf(file, sizeof file, "%s%s", name, ending);
    for (int i = 0; i < s->n_taken; i++)
        if (strcmp(s->taken[i], file) == 0)
            return err_set(err, err_size, "duplicate name in this test");
    if (s->n_taken == TAKEN)
        return err_set(err, err_size, "expected at most %d names in a test", TAKEN);
    memcpy(s->taken[s->n_taken++], file, sizeof file);
    return true;
}

static bool shot(void *context, int run, const char *name, char *err, size_t err_size)
{
    struct stage *s = context;

    return take(s, name, ".png", err, err_size) &&
           golden_picture(&s->golden, s->run[run].guard.board, name, err, err_size);
}

static bool hash(void *context, int run, const char *name, char *err, size_t err_size)
{
    struct stage *s = context;

    return take(s, name, ".hash", err, err_size) &&
           golden_hash(&s->golden, s->run[run].guard.board, name, err, err_size);
}

static void fails(void *context, const char *sentence)
{
    outcome_say(((struct stage *)context)->out, SAYS_WRONG, "%s", sentence);
}

static void printed(void *context, const char *line)
{
    outcome_say(((struct stage *)context)->out, SAYS_PRINTED, "%s", line);
}

/* ---- all of it ---- */

static void say_fault(const struct board_fault *f, FILE *out)
{
    outcome_say(out, SAYS_WRONG, "%s", f->message);
    for (const char *p = f->trace; *p; p += strcspn(p, "\n"), p += *p == '\n')
        outcome_say(out, SAYS_TRACE, "%.*s", (int)strcspn(p, "\n"), p);
}

static uint32_t run_script(struct stage *s, const char *name, const uint8_t *text, size_t n)
{
    const struct trial_host host = { .context = s,
                                     .script = required,
                                     .power = power,
                                     .press = press,
                                     .tick = tick,
                                     .keep = keep,
                                     .back = back,
                                     .shot = shot,
                                     .hash = hash,
                                     .fails = fails,
                                     .print = printed };
    struct board_fault fault;
    void *block, *memory = tree_work(trial_size(), &block);
    char chunk[FILES_PATH_SIZE];
    uint32_t frames = 0;

    snprintf(chunk, sizeof chunk, "%.*s", (int)(strlen(name) - strlen(".lua")), name);
    if (!memory)
        outcome_say(s->out, SAYS_HOST, "%s: out of memory", name);
    else if (!trial_script(memory, &host, chunk, (const char *)text, n, &fault, &frames))
        say_fault(&fault, s->out);
    free(block);
    return frames;
}

void one_script(const struct testing *t, const char *name, FILE *out)
{
    const uint64_t begun = plat_usec();
    struct stage *s = calloc(1, sizeof *s);
    char err[FILES_ERR_SIZE] = "out of memory";
    size_t n = 0;
    uint8_t *text = s ? read_script(t, name, &n, err, sizeof err) : NULL;
    uint32_t frames = 0;

    if (text) {
        s->t = t;
        s->out = out;
        s->golden = (struct golden){ t->dir, t->update, out };
        frames = run_script(s, name, text, n);
    } else {
        outcome_say(out, SAYS_HOST, "%s", err);
    }
    outcome_say(out, SAYS_COST, "%u %llu", (unsigned)frames, (unsigned long long)clock_since(begun));
    for (int i = 0; s && i < TRIAL_RUNS; i++)
        close_run(&s->run[i]);
    for (int i = 0; s && i < s->n_scripts; i++)
        free(s->script[i]);
    free(text);
    free(s);
}

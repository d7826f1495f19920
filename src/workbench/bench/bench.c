/*
 * bench.c - see bench.h. Plays the demo or the section of the command line; otherwise every demo of the game, and then
 * each stage and phase that no demo reached, with an invincible ship that flies from side to side.
 */
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../common/progress.h"
#include "../../common/report.h"
#include "../../player/game/game.h"
#include "../../player/run/sections.h"
#include "bench_json.h"
#include "bench_print.h"
#include "measure.h"

enum { START_FRAMES = 1800 /* of a game without demos and sections */ };

struct work {
    const struct bench *b;
    struct measure measure;
    struct sections sections;
    struct demo *demo; /* the game's */
    char (*name)[MEASURE_NAME];
    int demos;
};

/* ---- the game's demos ---- */

static int count_demos(const struct rom *rom)
{
    struct lump l;
    int n = 0;

    for (int i = rom_find_first(rom, "demo/"); i < (int)rom->count; i++, n++) {
        rom_lump(rom, i, &l);
        if (strncmp(l.name, "demo/", 5) != 0)
            break;
    }
    return n;
}

static enum result read_demo(struct work *w, int i, const struct lump *l)
{
    char err[512], warning[128];
    struct demo *d = &w->demo[i];

    snprintf(w->name[i], sizeof w->name[i], "%s.demo", l->name + strlen("demo/"));
    if (!demo_read(d, l->data, l->size, err, sizeof err) || !demo_check_cart(d, w->b->cart, err, sizeof err))
        return report_line(RESULT_REFUSED, "demos/%s: %s", w->name[i], err);
    if (demo_replay_warning(d, w->b->cart, warning, sizeof warning))
        report_line(RESULT_DONE, "demos/%s: %s; playback may diverge", w->name[i], warning);
    return RESULT_DONE;
}

static enum result read_demos(struct work *w)
{
    const struct rom *rom = w->b->cart->rom;
    const int first = rom_find_first(rom, "demo/");
    enum result result = RESULT_DONE;

    w->demos = count_demos(rom);
    w->demo = calloc((size_t)w->demos + 1, sizeof *w->demo);
    w->name = calloc((size_t)w->demos + 1, sizeof *w->name);
    if (!w->demo || !w->name)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    for (int i = 0; i < w->demos && result == RESULT_DONE; i++) {
        struct lump l;
        rom_lump(rom, first + i, &l);
        result = read_demo(w, i, &l);
    }
    return result;
}

/* ---- runs ---- */

static struct measure_run demo_run(const struct demo *d, const char *name)
{
    return (struct measure_run){ .name = name, .start = d->start, .demo = d };
}

static struct measure_run section_run(const struct work *w, const char *id, enum section_kind kind)
{
    struct measure_run run = { .name = id, .start = w->b->start, .kind = kind };

    snprintf(run.start.practice.section, sizeof run.start.practice.section, "%s", id);
    run.start.practice.invincible = true;
    return run;
}

static enum result measure_one(struct work *w, const struct measure_run *run)
{
    measure_plan(&w->measure, run);
    return measure_add(&w->measure, run);
}

static enum result play_demos(struct work *w)
{
    enum result result = read_demos(w);

    for (int i = 0; i < w->demos && result == RESULT_DONE; i++) {
        const struct measure_run run = demo_run(&w->demo[i], w->name[i]);
        measure_plan(&w->measure, &run);
    }
    for (int i = 0; i < w->demos && result == RESULT_DONE; i++) {
        const struct measure_run run = demo_run(&w->demo[i], w->name[i]);
        result = measure_add(&w->measure, &run);
    }
    return result;
}

static bool is_unvisited(const struct work *w, const struct section *s)
{
    return (s->kind == SECTION_STAGE || s->kind == SECTION_PHASE) && !measure_has(&w->measure, s->id);
}

/* A stage contains its bosses, so is_unvisited is checked before each section. */
static enum result play_sections(struct work *w)
{
    enum result result = RESULT_DONE;

    sections_list(&w->sections, w->b->cart->rom, &w->b->start, false);
    for (int i = 0; i < w->sections.n && result == RESULT_DONE; i++)
        if (is_unvisited(w, &w->sections.section[i])) {
            const struct section *s = &w->sections.section[i];
            const struct measure_run run = section_run(w, s->id, s->kind);
            result = measure_one(w, &run);
        }
    return result;
}

static enum result play_from_start(struct work *w)
{
    const struct measure_run run = { .name = "start", .start = w->b->start, .max_frames = START_FRAMES };

    return measure_one(w, &run);
}

static enum result play(struct work *w)
{
    const struct bench *b = w->b;
    const char *section = b->start.practice.section;

    if (b->demo) {
        const struct measure_run run = demo_run(b->demo, b->demo_name);
        return measure_one(w, &run);
    }
    if (section[0]) {
        const struct measure_run run = section_run(w, section, strchr(section, '/') ? SECTION_PHASE : SECTION_STAGE);
        return measure_one(w, &run);
    }
    enum result result = b->custom_start ? RESULT_DONE : play_demos(w);
    result = result == RESULT_DONE ? play_sections(w) : result;
    return result == RESULT_DONE && w->measure.runs == 0 ? play_from_start(w) : result;
}

static enum result bench_run(const struct bench *b)
{
    struct work *w = calloc(1, sizeof *w);

    if (!w)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    w->b = b;
    measure_open(&w->measure, b->cart);
    progress_begin();
    enum result result = play(w);
    progress_end();
    if (result == RESULT_DONE && w->measure.all.frames == 0)
        result = report_line(RESULT_REFUSED, "%s: no frame to measure", b->path);
    if (result == RESULT_DONE) {
        measure_end(&w->measure);
        if (b->json)
            bench_json(b, &w->measure);
        else
            bench_print(b, &w->measure);
        result = report_stdout(result);
    }
    measure_close(&w->measure);
    for (int i = 0; i < w->demos && w->demo; i++)
        demo_free(&w->demo[i]);
    free(w->demo);
    free(w->name);
    free(w);
    return result;
}

enum result bench_command(const struct args *a)
{
    struct game *g = calloc(1, sizeof *g);
    char err[1024];
    enum result result;

    if (!g)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    if (!game_open(g, a->words[0], a, err, sizeof err)) {
        result = report_error(err);
    } else {
        const struct bench b = { .path = a->words[0],
                                 .cart = &g->cart,
                                 .start = g->start,
                                 .demo = g->has_demo ? &g->demo : NULL,
                                 .demo_name = a->demo,
                                 .custom_start = a->seeded || a->n_dips || a->difficulty || a->lang,
                                 .slower = a->machine,
                                 .json = a->json };
        result = bench_run(&b);
        game_close(g);
    }
    free(g);
    return result;
}

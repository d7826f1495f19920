/*
 * survive.c - see survive.h.
 */
#include "survive.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../common/files.h"
#include "../../common/progress.h"
#include "../../common/report.h"
#include "../../player/picture/png.h"
#include "../../player/run/sections.h"
#include "../../common/output_paths.h"
#include "../../base/err.h"
#include "../../player/game/game.h"
#include "map.h"
#include "survive_print.h"

enum {
    SURVIVE_FRAMES = 7200, /* without --frames */
    SURVIVE_EFFORT = 4,    /* without --effort */
    MIN_PART = 60          /* frames; a shorter part of a stage is skipped */
};

struct survive {
    const struct args *a;
    const char *path; /* of the game, for messages */
    struct game game;
    char name[128]; /* of the current section, for progress */
};

/* ---- progress ---- */

/* The section may end before the limit. */
static void show_progress(void *user, uint32_t done, uint32_t of)
{
    const struct survive *s = user;

    progress_update(done, of, "%s: survived to frame %u of %u", s->name, (unsigned)done, (unsigned)of);
}

/* ---- a section ---- */

static const char *difficulty_name(const struct survive *s, int32_t difficulty)
{
    const struct manifest *m = &s->game.cart.manifest;
    const int i = difficulty >= 0 ? difficulty : m->difficulty;

    return m->n_difficulties > 1 && i < m->n_difficulties ? m->difficulties[i] : "";
}

static enum result play_section(struct survive *s, struct section_run *run, const struct board_start *start)
{
    bool host;

    *run = (struct section_run){ .search = { .effort = s->a->effort ? s->a->effort : SURVIVE_EFFORT,
                                             .limit = s->a->n_spans ? s->a->spans[0].last : SURVIVE_FRAMES,
                                             .on_progress = show_progress,
                                             .user = s } };
    snprintf(s->name, sizeof s->name, "%s", start->practice.section[0] ? start->practice.section : "from the title");
    progress_begin();
    const bool good = s->a->bots ? section_play_bots(run, &s->game.rom, start, s->a->bots, &host)
                                 : section_search(run, &s->game.rom, start, &host);
    progress_end();
    if (!good)
        return report_line(host ? RESULT_HOST_FAILED : RESULT_REFUSED, "%s: %s", s->path, run->err);
    if (run->search.verdict == SEARCH_FAULT)
        return report_fault(board_last_output(run->simulation.b)->fault, s->a->verbose);
    return RESULT_DONE;
}

static const char *demo_path(const struct survive *s)
{
    return s->a->out ? s->a->out : "survive.demo";
}

/* Writes the demo's path with the suffix .png. */
static bool picture_path(const char *demo, char *out, size_t size)
{
    const char *dot = strrchr(demo, '.'), *slash = strrchr(demo, '/');
    const int n = (int)(dot && (!slash || dot > slash + 1) && dot > demo ? (size_t)(dot - demo) : strlen(demo));

    return snprintf(out, size, "%.*s.png", n, demo) < (int)size;
}

static bool is_demo(const uint8_t *head, size_t n)
{
    return n >= 4 && memcmp(head, "CDEM", 4) == 0;
}

/* Checks before the search that the output files can be written. */
static bool check_outputs(const struct survive *s, char *err, size_t err_size)
{
    char picture[FILES_PATH_SIZE];
    const char *demo = demo_path(s);

    if (!picture_path(demo, picture, sizeof picture))
        return err_set(err, err_size, "-o: path too long");
    const struct output_path out[] = { { "-o", demo, NULL }, { "--map", s->a->map, NULL }, { "-o", picture, NULL } };
    return output_paths_check(s->path, NULL, out, 3, err, err_size) &&
           output_path_derived(s->path, picture, png_is_signed, err, err_size) &&
           (s->a->out || output_path_derived(s->path, demo, is_demo, err, err_size));
}

static enum result write_files(struct survive *s, struct section_run *run, struct survive_output *of, char *picture,
                               size_t size)
{
    const char *demo = demo_path(s);
    char err[FILES_ERR_SIZE];
    size_t bytes = 0;
    enum result result = RESULT_DONE;

    if (s->a->map) {
        uint8_t *png = map_sheet(run, &s->game.cart, &bytes);
        result = report_save_png(s->a->map, png, bytes);
        of->map = s->a->map;
    }
    if (result == RESULT_DONE && section_survived(run)) {
        of->demo = demo;
        if (!simulation_record(&run->simulation, &s->game.cart, run->search.pads, run->search.frames, demo,
                               s->a->prints, err, sizeof err))
            result = report_line(RESULT_HOST_FAILED, "%s", err);
    } else if (result == RESULT_DONE) {
        if (!picture_path(demo, picture, size))
            return report_line(RESULT_REFUSED, "-o: path too long");
        of->picture = picture;
        uint8_t *png = map_last(run, &s->game.cart, &bytes);
        result = report_save_png(picture, png, bytes);
    }
    return result;
}

static enum result section_result(const struct section_run *run)
{
    return section_survived(run) || run->search.verdict == SEARCH_BOTS ? RESULT_DONE : RESULT_DIFFERS;
}

static enum result survive_section(struct survive *s)
{
    struct section_run *run = calloc(1, sizeof *run);
    char picture[FILES_PATH_SIZE], err[FILES_ERR_SIZE];

    if (!run)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    if (!s->a->bots && !check_outputs(s, err, sizeof err)) {
        free(run);
        return report_line(RESULT_REFUSED, "%s", err);
    }
    const struct board_start *start = &s->game.start;
    struct survive_output of = { .section = start->practice.section,
                                 .difficulty = difficulty_name(s, start->difficulty) };
    enum result result = play_section(s, run, start);
    if (result == RESULT_DONE && run->search.verdict != SEARCH_NO_SHIP && !s->a->bots)
        result = write_files(s, run, &of, picture, sizeof picture);
    if (result == RESULT_DONE) {
        (s->a->json ? survive_print_json : survive_print_section)(&of, run);
        result = report_stdout(section_result(run));
    }
    section_close(run);
    free(run);
    return result;
}

/* ---- all sections ---- */

/* Compares a section at a difficulty with itself at the next harder one. */
static enum result compare(const struct survive *s, const struct section_run *easier, const struct section_run *harder,
                           const char *section, int difficulty)
{
    char why[160] = "";

    if (s->a->bots)
        bots_compare(&easier->measure.bots, &harder->measure.bots, why, sizeof why);
    else if (!section_survived(easier) && section_survived(harder))
        snprintf(why, sizeof why, "no way was found, but one was found at the next harder difficulty");
    else
        measure_compare(&easier->measure, &harder->measure, why, sizeof why);
    if (!why[0])
        return RESULT_DONE;
    return report_line(RESULT_DIFFERS, "%s: %s is harder than %s: %s", section, difficulty_name(s, difficulty),
                       difficulty_name(s, difficulty + 1), why);
}

static enum result worst(enum result a, enum result b)
{
    return a > b ? a : b;
}

/* Saves the demo as SECTION-DIFFICULTY.demo in the folder of -o, with - for / and :. */
static enum result save_demo(struct survive *s, struct section_run *run, struct survive_output *of, char *path,
                             size_t size)
{
    char err[FILES_ERR_SIZE];

    if (!s->a->out || !section_survived(run))
        return RESULT_DONE;
    const int start = snprintf(path, size, "%s/", s->a->out);
    if (start < 0 || (size_t)start + 1 >= size ||
        snprintf(path + start, size - (size_t)start, "%s%s%s.demo", of->section, of->difficulty[0] ? "-" : "",
                 of->difficulty) >= (int)(size - (size_t)start))
        return report_line(RESULT_REFUSED, "-o: path too long");
    for (char *c = path + start; *c; c++)
        if (*c == '/' || *c == ':')
            *c = '-';
    of->demo = path;
    if (!output_path_derived(s->path, path, is_demo, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    if (simulation_record(&run->simulation, &s->game.cart, run->search.pads, run->search.frames, path, s->a->prints,
                          err, sizeof err))
        return RESULT_DONE;
    return report_line(RESULT_HOST_FAILED, "%s", err);
}

static void print_row(const struct survive *s, const struct survive_output *of, const struct section_run *run)
{
    if (s->a->json)
        survive_print_json(of, run);
    else if (s->a->bots)
        survive_print_bots_row(of, run);
    else
        survive_print_row(of, run);
}

/* Returns whether a part has no frames to play, as from a mark at which a boss enters. */
static bool is_empty(const struct survive *s, const struct section_run *run)
{
    return s->a->bots &&
           (run->search.verdict == SEARCH_NO_SHIP || bots_flown(&run->measure.bots) < MIN_PART * (uint32_t)s->a->bots);
}

/* Plays a section at each wanted difficulty. */
static enum result survive_difficulties(struct survive *s, const char *section, struct section_run run[2])
{
    const struct manifest *m = &s->game.cart.manifest;
    const int first = s->a->difficulty ? s->game.start.difficulty : 0;
    const int last = s->a->difficulty || m->n_difficulties < 1 ? first : m->n_difficulties - 1;
    enum result result = RESULT_DONE;
    char path[FILES_PATH_SIZE];

    for (int d = first; d <= last && result < RESULT_REFUSED; d++) {
        struct board_start start = s->game.start;
        start.difficulty = m->n_difficulties ? d : -1;
        snprintf(start.practice.section, sizeof start.practice.section, "%s", section);
        struct section_run *now = &run[d & 1], *before = &run[1 - (d & 1)];
        section_close(now);
        const enum result found = play_section(s, now, &start);
        result = worst(result, found);
        if (found != RESULT_DONE)
            break;
        if (is_empty(s, now))
            break;
        struct survive_output of = { .section = section, .difficulty = difficulty_name(s, start.difficulty) };
        result = worst(result, save_demo(s, now, &of, path, sizeof path));
        print_row(s, &of, now);
        fflush(stdout);
        result = worst(result, section_result(now));
        if (d > first)
            result = worst(result, compare(s, before, now, section, d - 1));
    }
    section_close(&run[0]);
    section_close(&run[1]);
    return result;
}

static bool is_wanted(const struct survive *s, const struct section *section)
{
    const char *stage = s->a->stage;
    const size_t n = stage ? strlen(stage) : 0;

    if (section->kind == SECTION_BOSS || (section->kind == SECTION_MARK && !s->a->bots))
        return false;
    return !stage || (strncmp(section->id, stage, n) == 0 && strchr("/:", section->id[n])); /* or the end of the id */
}

static enum result survive_all(struct survive *s)
{
    struct sections *list = calloc(1, sizeof *list);
    struct section_run *run = calloc(2, sizeof *run);
    enum result result = RESULT_DONE;
    int n = 0;

    if (!list || !run) {
        free(list);
        free(run);
        return report_line(RESULT_HOST_FAILED, "out of memory");
    }
    sections_list(list, &s->game.rom, &s->game.start, false);
    for (int i = 0; i < list->n && result < RESULT_REFUSED; i++)
        if (is_wanted(s, &list->section[i])) {
            if (n++ == 0 && !s->a->json)
                (s->a->bots ? survive_print_bots_head : survive_print_head)();
            result = worst(result, survive_difficulties(s, list->section[i].id, run));
        }
    if (n > 0 && list->why[0])
        result = worst(result, report_line(RESULT_DIFFERS, "--all: cannot list all sections: %s", list->why));
    if (n == 0)
        result = report_line(RESULT_REFUSED, "--all: %s",
                             list->why[0] ? list->why : "--stage: no such stage or boss in the game");
    free(list);
    free(run);
    return report_stdout(result);
}

/* ---- the command ---- */

enum result survive_command(const struct args *a)
{
    const bool one_frame = a->n_spans == 1 && a->spans[0].first == a->spans[0].last && a->spans[0].last > 0;
    struct survive *s = calloc(1, sizeof *s);
    char err[1024];
    enum result result;

    if (!s)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    s->a = a;
    if (a->n_spans && !one_frame) {
        result = report_line(RESULT_REFUSED, "--frames: survive takes one number, the number of frames to search");
    } else if (!game_open(&s->game, a->n_words ? a->words[0] : NULL, a, err, sizeof err)) {
        result = report_error(err);
    } else {
        s->path = s->game.path ? s->game.path : "the built-in game";
        result = a->all ? survive_all(s) : survive_section(s);
        game_close(&s->game);
    }
    free(s);
    return result;
}

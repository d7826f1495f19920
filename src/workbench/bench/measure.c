/*
 * measure.c - see measure.h.
 *
 * The clock is read before a tick (without the guard's own work), at the end of each phase of the tick, and after the
 * picture and the sound. The markers of a tick determine the section of its frame.
 */
#include "measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "../../common/progress.h"
#include "../../common/report.h"
#include "../../player/picture/shade.h"
#include "../../player/run/guard.h"
#include "sweep.h"
#include "../../common/array.h"

enum {
    COUNT_COST = 2,        /* counting a frame's instructions takes about as long as timing 2 frames */
    GUESSED_FRAMES = 3600, /* frames of a run of unknown length */
    PROGRESS_EVERY = 16    /* frames */
};

/* Microseconds of one frame in one round. */
struct times {
    uint32_t tick, draw, sound;
};

struct runner {
    struct measure *m;
    const struct measure_run *run;
    struct guard guard;
    struct fb fb;
    struct view view;
    struct shade_cache shades;
    void *memory, *scratch, *sounds; /* sounds: NULL: the game is silent */
    uint32_t rgb[256];
    int16_t mix[2 * BOARD_SOUND_FRAMES];
    uint64_t tick_start, last_lap; /* usec: start of the tick, and end of the last timed interval */
    uint64_t phase[PHASES];

    /* per frame, allocated by the first round */
    uint32_t frames;
    uint16_t *section;
    struct times *times[MEASURE_ROUNDS];
    uint64_t hash; /* at the end of the run */
};

/* ---- sections ---- */

static int find_section(const struct measure *m, const char *name)
{
    for (int i = 0; i < m->n; i++)
        if (strcmp(m->section[i].name, name) == 0)
            return i;
    return -1;
}

static int find_or_add_section(struct measure *m, const char *name)
{
    const int i = find_section(m, name);

    if (i >= 0 || m->n == MEASURE_MAX_SECTIONS)
        return i < 0 ? 0 : i;
    snprintf(m->section[m->n].name, MEASURE_NAME, "%s", name);
    return m->n++;
}

/* The current stage and phase of a run. */
struct place {
    char stage[MEASURE_NAME], phase[MEASURE_NAME];
};

static void update_place(struct place *p, const struct board_marker *k)
{
    switch (k->kind) {
    case MARKER_STAGE:
        *p = (struct place){ 0 };
        snprintf(p->stage, sizeof p->stage, "%s", k->name);
        break;
    case MARKER_PHASE:
        snprintf(p->phase, sizeof p->phase, "%s/%s", k->parent, k->name);
        break;
    case MARKER_WON:
    case MARKER_LOST:
        p->phase[0] = 0;
        break;
    case MARKER_CLEAR:
    case MARKER_GAME:
    case MARKER_OVER:
        *p = (struct place){ 0 };
        break;
    default:
        break;
    }
}

static int current_section(struct measure *m, struct place *p, const struct board_out *out)
{
    for (int i = 0; i < out->marker_count; i++)
        update_place(p, &out->marker[i]);
    return find_or_add_section(m, p->phase[0] ? p->phase : p->stage);
}

/* ---- one frame ---- */

static void on_tick_start(void *context)
{
    struct runner *p = context;

    p->tick_start = p->last_lap = plat_usec();
}

static void on_phase_end(void *context, enum board_phase phase)
{
    struct runner *p = context;

    p->phase[phase] += clock_lap(&p->last_lap);
}

static const struct board_out *timed_tick(struct runner *p, const uint16_t pads[MAX_PLAYERS], struct times *t)
{
    board_set_phase_callback(p->guard.board, on_phase_end, p);
    const struct board_out *out = guard_tick(&p->guard, pads);
    *t = (struct times){ .tick = (uint32_t)(p->last_lap - p->tick_start) };
    if (out->fault)
        return out;
    p->last_lap = plat_usec();
    board_draw(p->guard.board, &p->view, &p->fb, p->rgb, p->scratch);
    t->draw = (uint32_t)clock_lap(&p->last_lap);
    if (p->sounds)
        board_mix_sound(p->guard.board, p->sounds, p->mix);
    t->sound = (uint32_t)clock_lap(&p->last_lap);
    return out;
}

/* ---- a round ---- */

static void read_pads(const struct runner *p, uint32_t frame, uint16_t pads[MAX_PLAYERS])
{
    if (p->run->demo)
        demo_pads(p->run->demo, frame, pads);
    else
        sweep_pads(frame, pads);
}

static bool restart(struct runner *p)
{
    char err[512];

    if (!guard_restart(&p->guard, &p->run->start, err, sizeof err)) {
        report_line(RESULT_REFUSED, "%s: %s", p->run->name, err);
        return false;
    }
    return true;
}

static enum result report_run_fault(const struct runner *p)
{
    return report_line(RESULT_REFUSED, "%s: frame %u: %s", p->run->name, (unsigned)board_frame(p->guard.board),
                       board_last_output(p->guard.board)->fault->message);
}

static void show_progress(struct runner *p, uint32_t frame, const char *what)
{
    struct measure *m = p->m;

    if (frame % PROGRESS_EVERY == 0)
        progress_update(m->done, m->planned, "%s: %s", p->run->name, what);
}

static bool reserve_frame(struct runner *p)
{
    bool good = array_append(&p->section, p->frames, sizeof *p->section) != NULL;

    for (int r = 0; r < MEASURE_ROUNDS; r++)
        good = array_append(&p->times[r], p->frames, sizeof *p->times[r]) && good;
    return good;
}

static uint32_t frame_limit(const struct measure_run *run)
{
    return run->max_frames ? run->max_frames : run->demo ? run->demo->frames : SWEEP_FRAMES;
}

/* Plays a run to its end; the other rounds have the same length. */
static enum result first_round(struct runner *p)
{
    const uint32_t limit = frame_limit(p->run);
    const struct board_out *out = board_last_output(p->guard.board);
    struct place place = { 0 };
    uint16_t pads[MAX_PLAYERS];
    bool over = out->fault != NULL;

    for (uint32_t f = 0; f < limit && !over; f++) {
        if (!reserve_frame(p))
            return report_line(RESULT_HOST_FAILED, "out of memory");
        read_pads(p, f, pads);
        out = timed_tick(p, pads, &p->times[0][f]);
        p->section[f] = (uint16_t)current_section(p->m, &place, out);
        p->frames++;
        p->m->done++;
        show_progress(p, f, "timing");
        over = out->fault || (!p->run->demo && sweep_over(p->run->kind, out));
    }
    p->hash = board_hash(p->guard.board);
    /* a demo may end with a fault; the frames before it are measured */
    return out->fault && (!p->run->demo || p->frames < limit) ? report_run_fault(p) : RESULT_DONE;
}

static enum result next_round(struct runner *p, int round)
{
    uint16_t pads[MAX_PLAYERS];

    for (uint32_t f = 0; f < p->frames; f++) {
        read_pads(p, f, pads);
        timed_tick(p, pads, &p->times[round][f]);
        p->m->done++;
        show_progress(p, f, "timing");
    }
    return RESULT_DONE;
}

static void update_peaks(struct measure *m, const struct board *b)
{
    struct inspect_gauge now[MAX_PARTS];

    m->parts = inspect_gauges(b, now);
    for (int i = 0; i < m->parts; i++) {
        struct inspect_gauge *peak = &m->peak[i];
        const struct inspect_gauge was = *peak;
        *peak = now[i];
        peak->live = was.live > now[i].live ? was.live : now[i].live;
        peak->high = was.high > now[i].high ? was.high : now[i].high;
        peak->refused = was.refused > now[i].refused ? was.refused : now[i].refused;
    }
    m->lua_peak = m->lua_peak > board_lua_peak(b) ? m->lua_peak : board_lua_peak(b);
}

/* Counts instructions without timing. */
static enum result count_round(struct runner *p)
{
    struct profile *profile = &p->m->profile;
    const struct board_out *out = board_last_output(p->guard.board);
    uint16_t pads[MAX_PLAYERS];

    board_set_profile(p->guard.board, profile);
    for (uint32_t f = 0; f < p->frames && !out->fault; f++) {
        const uint64_t before = profile_work(&profile->total);
        read_pads(p, f, pads);
        out = board_tick(p->guard.board, pads);
        p->m->section[p->section[f]].lua += profile_work(&profile->total) - before;
        update_peaks(p->m, p->guard.board);
        p->m->done += COUNT_COST;
        show_progress(p, f, "counting Lua instructions");
    }
    board_set_profile(p->guard.board, NULL);
    return RESULT_DONE;
}

/* ---- all rounds ---- */

static uint32_t min_u32(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static struct times shortest_times(const struct runner *p, uint32_t f)
{
    struct times t = p->times[0][f];

    for (int r = 1; r < MEASURE_ROUNDS; r++) {
        t.tick = min_u32(t.tick, p->times[r][f].tick);
        t.draw = min_u32(t.draw, p->times[r][f].draw);
        t.sound = min_u32(t.sound, p->times[r][f].sound);
    }
    return t;
}

static bool add_frame(struct measure_section *s, const struct times *t, const char *in, uint32_t at)
{
    const uint32_t cost = t->tick + t->draw + t->sound;

    if (!array_append(&s->frame_usec, s->frames, sizeof *s->frame_usec))
        return false;
    s->frame_usec[s->frames++] = cost;
    s->tick += t->tick;
    s->draw += t->draw;
    s->sound += t->sound;
    if (cost > s->worst || !s->worst_run) {
        s->worst = cost;
        s->worst_frame = at;
        s->worst_run = in;
    }
    return true;
}

static bool add_frames(struct runner *p)
{
    for (uint32_t f = 0; f < p->frames; f++) {
        const struct times t = shortest_times(p, f);
        if (!add_frame(&p->m->section[p->section[f]], &t, p->run->name, f + 1) ||
            !add_frame(&p->m->all, &t, p->run->name, f + 1))
            return false;
    }
    for (int i = 0; i < PHASES; i++)
        p->m->all.phase[i] += p->phase[i] / MEASURE_ROUNDS;
    return true;
}

static enum result all_rounds(struct runner *p)
{
    enum result result = first_round(p);

    for (int r = 1; r <= MEASURE_ROUNDS && result == RESULT_DONE; r++) {
        if (!restart(p))
            return RESULT_REFUSED;
        result = r < MEASURE_ROUNDS ? next_round(p, r) : count_round(p);
        if (result == RESULT_DONE && board_hash(p->guard.board) != p->hash)
            result = report_line(RESULT_HOST_FAILED, "%s: two runs with the same input differ", p->run->name);
    }
    if (result == RESULT_DONE && !add_frames(p))
        return report_line(RESULT_HOST_FAILED, "out of memory");
    return result;
}

static bool runner_open(struct runner *p)
{
    const struct board *b = p->guard.board;
    int w, h;

    board_screen_size(b, &w, &h);
    p->memory = malloc(fb_size(w, h));
    p->scratch = malloc(board_scratch_size(b) + 1);
    p->sounds = board_has_sound(b) ? malloc(board_sound_tables_size()) : NULL;
    if (!p->memory || !p->scratch || (board_has_sound(b) && !p->sounds))
        return false;
    fb_init(&p->fb, p->memory, w, h);
    p->view = (struct view){ .shades = shade_get_tables(&p->shades, p->m->cart) };
    if (p->sounds)
        board_sound_init_tables(p->sounds);
    p->guard.before = on_tick_start;
    p->guard.context = p;
    return true;
}

static void runner_close(struct runner *p)
{
    guard_close(&p->guard);
    free(p->memory);
    free(p->scratch);
    free(p->sounds);
    free(p->section);
    for (int r = 0; r < MEASURE_ROUNDS; r++)
        free(p->times[r]);
    free(p);
}

static uint64_t planned_frames(const struct measure_run *run)
{
    return (uint64_t)(MEASURE_ROUNDS + COUNT_COST) * (run->demo || run->max_frames ? frame_limit(run) : GUESSED_FRAMES);
}

void measure_plan(struct measure *m, const struct measure_run *run)
{
    m->planned += planned_frames(run);
}

enum result measure_add(struct measure *m, const struct measure_run *run)
{
    struct runner *p = calloc(1, sizeof *p);
    const uint64_t done = m->done + planned_frames(run);
    enum result result;
    char err[512];

    if (!p)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    p->m = m;
    p->run = run;
    if (!guard_power(&p->guard, m->rom, &run->start, err, sizeof err))
        result = report_line(RESULT_REFUSED, "%s: %s", run->name, err);
    else
        result = runner_open(p) ? all_rounds(p) : report_line(RESULT_HOST_FAILED, "out of memory");
    m->runs += result == RESULT_DONE;
    m->done = done;
    runner_close(p);
    return result;
}

/* ---- results ---- */

void measure_open(struct measure *m, const struct cart *cart)
{
    memset(m, 0, sizeof *m);
    m->rom = cart->rom;
    m->cart = cart;
    m->n = 1;
}

bool measure_has(const struct measure *m, const char *name)
{
    return find_section(m, name) >= 0;
}

static int ascending(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;

    return (x > y) - (x < y);
}

void measure_end(struct measure *m)
{
    for (int i = 0; i < m->n; i++) {
        struct measure_section *s = &m->section[i];
        if (s->frames)
            qsort(s->frame_usec, s->frames, sizeof *s->frame_usec, ascending);
        m->all.lua += s->lua;
    }
    if (m->all.frames)
        qsort(m->all.frame_usec, m->all.frames, sizeof *m->all.frame_usec, ascending);
}

uint32_t measure_percentile(const struct measure_section *s, int percent)
{
    const uint64_t i = ((uint64_t)s->frames * (uint64_t)percent + 99) / 100;

    return s->frames ? s->frame_usec[i ? i - 1 : 0] : 0;
}

uint32_t measure_count_over(const struct measure_section *s, uint64_t limit)
{
    uint32_t low = 0, high = s->frames;

    while (low < high) {
        const uint32_t i = low + (high - low) / 2;
        if (s->frame_usec[i] > limit)
            high = i;
        else
            low = i + 1;
    }
    return s->frames - low;
}

void measure_close(struct measure *m)
{
    for (int i = 0; i < m->n; i++)
        free(m->section[i].frame_usec);
    free(m->all.frame_usec);
}

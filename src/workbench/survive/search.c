/*
 * search.c - see search.h.
 *
 * First, the whole section is forecast: it runs with an invincible ship, and the bullets are recorded. If the forecast
 * leaves a path, the path is flown. If the bullets do not depend on the ship, the search is done. If the forecast
 * leaves no path, and bullets were identical in runs with other buttons, no path exists.
 *
 * Otherwise the search continues in short segments: it forecasts some frames, plans a path and flies it. If bullets
 * reacted, it forecasts them again with the ship on this path. The first part of the survived path becomes part of the
 * run. From a dead end the search backtracks, further each time, and prefers other paths.
 */
#include "search.h"

#include <stdlib.h>
#include <string.h>
#include "plan.h"

enum {
    SEGMENT = 120,        /* frames of a segment */
    MIN_PATH = 6,         /* a shorter path is a dead end */
    FORECASTS = 4,        /* forecasts per segment */
    MAX_CHECKPOINTS = 48, /* saved states to backtrack to */
    MOVES_ALL = 1 << 21,  /* moves that a plan of the whole section may try */
    MOVES_SEGMENT = 1 << 16,
    PROBES = 8,
    PLANS_PER_EFFORT = 100, /* plans */
    PROGRESS_EVERY = 64     /* frames */
};

struct checkpoint {
    struct simulation_state state;
    uint32_t frame;
};

struct searcher {
    struct search *s;
    struct checkpoint checkpoints[MAX_CHECKPOINTS];
    int n_checkpoints;
    struct forecast forecast;
    uint32_t seed, backtrack;
    uint16_t *now; /* the pads of the current run */
    uint16_t guess[SEGMENT];
    uint32_t guessed;
    bool bullets_reacted; /* a path through the whole forecast was hit: the bullets reacted */
};

/* ---- frames ---- */

static bool reserve_pads(struct search *s, uint32_t frame)
{
    if (frame < s->capacity)
        return true;
    const uint32_t capacity = s->limit + 1;
    uint16_t *pads = realloc(s->pads, capacity * sizeof *pads);
    if (!pads)
        return false;
    s->pads = pads;
    s->capacity = capacity;
    return true;
}

static void show_progress(const struct search *s)
{
    if (s->on_progress)
        s->on_progress(s->user, s->frames, s->limit);
}

static enum simulation_end tick(struct simulation *t, uint16_t pads)
{
    const uint16_t both[MAX_PLAYERS] = { pads, 0 };

    return simulation_tick(t, both);
}

bool search_begin(struct search *s)
{
    struct simulation *t = s->t;
    enum simulation_end end = board_last_output(t->b)->fault ? SIMULATION_FAULT : SIMULATION_RUNNING;

    s->verdict = SEARCH_NO_SHIP;
    if (!reserve_pads(s, s->limit)) {
        s->verdict = SEARCH_NO_MEMORY;
        return false;
    }
    while (end == SIMULATION_RUNNING && !simulation_can_steer(t) && s->frames < s->limit) {
        const uint16_t pads = simulation_menu_pads(t);
        end = tick(t, pads);
        s->pads[s->frames++] = pads;
    }
    s->begin = s->last = s->frames;
    if (end == SIMULATION_FAULT)
        s->verdict = SEARCH_FAULT;
    return end == SIMULATION_RUNNING && simulation_can_steer(t);
}

/* ---- forecast and flight ---- */

static uint16_t choose_pads(const struct simulation *t, uint16_t steer)
{
    return simulation_can_steer(t) ? (uint16_t)(steer | PAD_FIRE) : simulation_menu_pads(t);
}

/* Forecasts `frames` frames with an invincible ship, which follows `pads` for the first n frames. */
static enum simulation_end make_forecast(struct searcher *w, uint32_t frames, const uint16_t *pads, uint32_t n)
{
    struct simulation *t = w->s->t;
    enum simulation_end end = SIMULATION_RUNNING;

    forecast_clear(&w->forecast, board_frame(t->b));
    t->recording = &w->forecast;
    danger_set_invincible(t->b, true);
    for (uint32_t f = 0; f < frames && end == SIMULATION_RUNNING && !w->forecast.full; f++) {
        end = tick(t, choose_pads(t, f < n ? pads[f] : 0));
        if (f % PROGRESS_EVERY == 0)
            show_progress(w->s);
    }
    t->recording = NULL;
    return end;
}

/* Flies a plan to its end or to a hit. *lived: frames before the hit. */
static enum simulation_end fly(struct searcher *w, const struct plan *p, uint32_t from, uint32_t *lived)
{
    struct simulation *t = w->s->t;
    enum simulation_end end = SIMULATION_RUNNING;

    for (*lived = 0; *lived < p->frames && from + *lived < w->s->limit; ++*lived) {
        const uint16_t pads = choose_pads(t, p->pads[*lived]);
        w->now[from + *lived] = pads;
        end = tick(t, pads);
        if (end == SIMULATION_ENDED)
            ++*lived;
        if (end != SIMULATION_RUNNING)
            break;
    }
    return end;
}

/* Stores the current run if it is the longest. A run that reached the end is better than any longer run. */
static void store_longest(struct searcher *w, uint32_t frames, enum simulation_end end)
{
    struct search *s = w->s;

    if (frames <= s->frames && end != SIMULATION_ENDED)
        return;
    memcpy(s->pads, w->now, frames * sizeof *s->pads);
    s->frames = s->last = frames;
}

static bool is_decided(struct search *s, enum simulation_end end)
{
    if (end == SIMULATION_ENDED)
        s->verdict = SEARCH_SURVIVED;
    else if (end == SIMULATION_FAULT)
        s->verdict = SEARCH_FAULT;
    else if (s->frames >= s->limit)
        s->verdict = SEARCH_LASTED;
    else
        return false;
    return true;
}

/* ---- the whole section ---- */

/* Sets s->reacts: whether the shapes of the first frames depend on the buttons. */
static void probe(struct searcher *w, const struct simulation_state *start, uint32_t frames)
{
    struct search *s = w->s;
    struct forecast first = w->forecast;
    uint32_t random = 1;
    uint16_t pads = 0;

    w->forecast = (struct forecast){ 0 };
    for (s->probes = 0; s->probes < PROBES && !s->reacts; s->probes++) {
        simulation_restore(s->t, start);
        forecast_clear(&w->forecast, s->begin);
        s->t->recording = &w->forecast;
        s->t->ship_was_moved = false;
        danger_set_invincible(s->t->b, true);
        for (uint32_t f = 0; f < frames && !s->reacts; f++) {
            random = random * 1664525u + 1013904223u;
            if (f % (4 + 4 * s->probes) == 0)
                pads = (uint16_t)((reach_move_pads((int)((random >> 16) % REACH_MOVES)) & ~PAD_FOCUS) |
                                  (random >> 9 & 1 ? PAD_FOCUS : 0) | (s->probes % 2 ? PAD_FIRE : 0));
            const enum simulation_end end = tick(s->t, pads);
            s->reacts = s->t->ship_was_moved || end == SIMULATION_FAULT ||
                        (end != SIMULATION_RUNNING && f + 1 < frames) || w->forecast.frames <= f ||
                        w->forecast.frame[f].checksum != first.frame[f].checksum;
            s->reacts_at = s->begin + f + 1;
        }
    }
    s->t->recording = NULL;
    forecast_close(&w->forecast);
    w->forecast = first;
}

/* Searches with cells of one size. True: the verdict is final. */
static bool search_with_cells(struct searcher *w, const struct simulation_state *start, fx cell)
{
    struct search *s = w->s;
    struct reach r;
    struct plan p = { 0 };
    uint32_t lived;
    bool decided = false, good;
    const fx x = start->ship.path.x, y = start->ship.path.y;

    good = reach_compute(&r, &w->forecast, cell, 0, x, y);
    if (good && reach_is_empty(&r)) {
        probe(w, start, r.frames);
        decided = !s->reacts;
        s->verdict = SEARCH_CANNOT;
        s->last = s->begin + r.frames;
    }
    if (good && !decided) {
        reach_prune(&r);
        s->plans++;
        good = plan_make(&p, &r, x, y, MOVES_ALL, 0, 1);
        simulation_restore(s->t, start);
        const enum simulation_end end = fly(w, &p, s->begin, &lived);
        const bool was_decided = decided;
        store_longest(w, s->begin + lived, end);
        w->bullets_reacted = end == SIMULATION_HIT && p.frames == w->forecast.frames;
        decided = was_decided || ((end != SIMULATION_RUNNING || s->begin + lived >= s->limit) &&
                                  end != SIMULATION_HIT && is_decided(s, end));
    } else if (good) { /* to find the longest run */
        const uint32_t last = s->last;
        reach_prune(&r);
        if (plan_make(&p, &r, x, y, MOVES_ALL / 8, 0, 1)) {
            simulation_restore(s->t, start);
            const enum simulation_end end = fly(w, &p, s->begin, &lived);
            store_longest(w, s->begin + lived, end);
        }
        s->last = last;
    }
    plan_free(&p);
    reach_free(&r);
    return decided;
}

static bool search_whole(struct searcher *w, const struct simulation_state *start)
{
    struct search *s = w->s;
    const enum simulation_end end = make_forecast(w, s->limit - s->begin, NULL, 0);

    if (end == SIMULATION_FAULT && w->forecast.frames == 0) {
        s->verdict = SEARCH_FAULT;
        return true;
    }
    /* large cells are the cheapest; small ones do not help if bullets reacted to a ship on a complete path */
    for (fx cell = 2 * FX_ONE; cell >= FX_ONE / 2 && !s->reacts && !w->bullets_reacted; cell /= 2)
        if (search_with_cells(w, start, cell))
            return true;
    return false;
}

/* ---- segments ---- */

/* Drops every second checkpoint, except the newest ones. */
static void thin_out(struct searcher *w)
{
    int n = 1;

    for (int i = 1; i < w->n_checkpoints; i++) {
        if (i % 2 && i + 8 < w->n_checkpoints)
            simulation_state_free(&w->checkpoints[i].state);
        else
            w->checkpoints[n++] = w->checkpoints[i];
        if (n - 1 != i)
            w->checkpoints[i].state = (struct simulation_state){ 0 };
    }
    w->n_checkpoints = n;
}

static bool add_checkpoint(struct searcher *w)
{
    if (w->n_checkpoints == MAX_CHECKPOINTS)
        thin_out(w);
    struct checkpoint *p = &w->checkpoints[w->n_checkpoints];
    p->frame = board_frame(w->s->t->b);
    if (!simulation_save(w->s->t, &p->state))
        return false;
    w->n_checkpoints++;
    return true;
}

/* Makes and flies a plan from the last checkpoint. *best: length of the longest path so far; its pads are in
 * `best_pads`. */
static enum simulation_end try_plan(struct searcher *w, uint32_t *best, uint16_t best_pads[SEGMENT])
{
    struct search *s = w->s;
    const struct checkpoint *at = &w->checkpoints[w->n_checkpoints - 1];
    const uint32_t left = s->limit - at->frame;
    struct reach r = { 0 };
    struct plan p = { 0 };
    uint32_t lived = 0;
    enum simulation_end end = SIMULATION_HIT;
    const fx x = at->state.ship.path.x, y = at->state.ship.path.y;

    simulation_restore(s->t, &at->state);
    make_forecast(w, left < SEGMENT ? left : SEGMENT, w->guess, w->guessed);
    s->plans++;
    if (reach_compute(&r, &w->forecast, 2 * FX_ONE, 0, x, y)) {
        reach_prune(&r);
        plan_make(&p, &r, x, y, MOVES_SEGMENT, w->seed, 1);
        simulation_restore(s->t, &at->state);
        end = fly(w, &p, at->frame, &lived);
        store_longest(w, at->frame + lived, end);
        w->guessed = p.frames;
        memcpy(w->guess, p.pads, p.frames * sizeof *p.pads);
        if (lived > *best) {
            *best = lived;
            memcpy(best_pads, &w->now[at->frame], lived * sizeof *best_pads);
        }
    }
    plan_free(&p);
    reach_free(&r);
    return end;
}

/* Flies the first part of the best path. */
static enum simulation_end fly_path(struct searcher *w, const uint16_t *pads, uint32_t frames)
{
    const struct checkpoint *at = &w->checkpoints[w->n_checkpoints - 1];
    enum simulation_end end = SIMULATION_RUNNING;

    simulation_restore(w->s->t, &at->state);
    for (uint32_t f = 0; f < frames && end == SIMULATION_RUNNING; f++) {
        w->now[at->frame + f] = pads[f];
        end = tick(w->s->t, pads[f]);
    }
    return end;
}

/* Backtracks by more checkpoints each time, at most to the first. */
static void backtrack(struct searcher *w)
{
    w->backtrack = w->backtrack ? w->backtrack * 2 : 1;
    w->seed++;
    w->guessed = 0;
    for (uint32_t i = 0; i < w->backtrack && w->n_checkpoints > 1; i++)
        simulation_state_free(&w->checkpoints[--w->n_checkpoints].state);
    if (w->backtrack >= MAX_CHECKPOINTS)
        w->backtrack = 0;
}

/* Skips the frames in which the ship cannot be steered. */
static enum simulation_end wait_until_steered(struct searcher *w)
{
    struct simulation *t = w->s->t;
    enum simulation_end end = SIMULATION_RUNNING;

    while (end == SIMULATION_RUNNING && !simulation_can_steer(t) && board_frame(t->b) < w->s->limit) {
        const uint32_t frame = board_frame(t->b);
        w->now[frame] = simulation_menu_pads(t);
        end = tick(t, w->now[frame]);
        if (end != SIMULATION_HIT && end != SIMULATION_FAULT)
            store_longest(w, frame + 1, end);
    }
    return end;
}

static enum simulation_end search_segment(struct searcher *w)
{
    uint16_t best_pads[SEGMENT];
    uint32_t best = 0;
    enum simulation_end end = SIMULATION_RUNNING;
    const uint32_t left = w->s->limit - w->checkpoints[w->n_checkpoints - 1].frame,
                   whole = left < SEGMENT ? left : SEGMENT;

    for (int k = 0; k < FORECASTS && best < whole; k++) {
        end = try_plan(w, &best, best_pads);
        if (end == SIMULATION_ENDED || end == SIMULATION_FAULT)
            return end;
    }
    if (best == left) /* up to the limit */
        return SIMULATION_RUNNING;
    if (best < MIN_PATH) {
        backtrack(w);
        simulation_restore(w->s->t, &w->checkpoints[w->n_checkpoints - 1].state);
        return SIMULATION_RUNNING;
    }
    const uint32_t flown = best == whole ? best / 2 : best / 3 + 1;
    w->guessed = 0;
    return fly_path(w, best_pads, flown);
}

static void search_segments(struct searcher *w, const struct simulation_state *start)
{
    struct search *s = w->s;
    enum simulation_end end = SIMULATION_RUNNING;
    uint32_t furthest = 0;

    memcpy(w->now, s->pads, s->begin * sizeof *w->now);
    simulation_restore(s->t, start);
    while (s->plans < s->effort * PLANS_PER_EFFORT) {
        if (end == SIMULATION_RUNNING)
            end = wait_until_steered(w);
        if (end == SIMULATION_HIT) { /* while the ship could not be steered */
            backtrack(w);
            simulation_restore(s->t, &w->checkpoints[w->n_checkpoints - 1].state);
            end = SIMULATION_RUNNING;
        }
        if (is_decided(s, end))
            return;
        const uint32_t now = board_frame(s->t->b);
        if (w->n_checkpoints == 0 || w->checkpoints[w->n_checkpoints - 1].frame < now)
            if (!add_checkpoint(w))
                break;
        if (now > furthest + SEGMENT) {
            furthest = now;
            w->backtrack = 0;
        }
        show_progress(s);
        end = search_segment(w);
        if (is_decided(s, end))
            return;
    }
    s->verdict = SEARCH_NOT_FOUND;
}

void search_run(struct search *s)
{
    struct searcher *w = calloc(1, sizeof *w);
    struct simulation_state start = { 0 };

    s->verdict = SEARCH_NO_MEMORY;
    if (w) {
        w->s = s;
        w->now = calloc(s->limit + 1, sizeof *w->now);
    }
    if (w && w->now && search_begin(s)) {
        memcpy(w->now, s->pads, s->begin * sizeof *w->now);
        if (!simulation_save(s->t, &start))
            s->verdict = SEARCH_NO_MEMORY;
        else if (!search_whole(w, &start))
            search_segments(w, &start);
    }
    for (int i = 0; w && i < MAX_CHECKPOINTS; i++)
        simulation_state_free(&w->checkpoints[i].state);
    if (w) {
        forecast_close(&w->forecast);
        free(w->now);
    }
    free(w);
    simulation_state_free(&start);
}

void search_close(struct search *s)
{
    free(s->pads);
    s->pads = NULL;
}

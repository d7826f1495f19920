/*
 * search.c - see search.h.
 *
 * First, the whole section is forecast: it runs with an invincible ship, and the bullets are recorded. If the forecast
 * leaves a path, the path is flown. If the bullets do not depend on the ship, the search is done. If the forecast
 * leaves no path, and bullets were identical in runs with other buttons, no path exists.
 *
 * Otherwise the search continues in short segments: it forecasts some frames, plans a path, flies it, and where bullets
 * reacted, forecasts them again with the ship on that path. The first part of the survived path is kept. From a dead
 * end the search goes back, further each time, and prefers other paths.
 */
#include "search.h"

#include <stdlib.h>
#include <string.h>
#include "plan.h"

enum {
    AHEAD = 120,         /* frames of a segment */
    LEAST = 6,           /* a shorter path is a dead end */
    TURNS = 4,           /* forecasts of a segment */
    MARKS = 48,          /* saved states to go back to */
    MOVES_ALL = 1 << 21, /* moves that a plan of the whole section may try */
    MOVES_SEGMENT = 1 << 16,
    PROBES = 8,
    EFFORT = 100,       /* plans */
    PROGRESS_EVERY = 64 /* frames */
};

struct place {
    struct simulation_state mark;
    uint32_t frame;
};

struct work {
    struct search *s;
    struct place place[MARKS];
    int places;
    struct forecast forecast;
    uint32_t taste, back;
    uint16_t *now; /* the pads of the present run */
    uint16_t guess[AHEAD];
    uint32_t guessed;
    bool astray; /* a path through the whole forecast was hit: the bullets reacted */
};

/* ---- frames ---- */

static bool room_for(struct search *s, uint32_t frame)
{
    if (frame < s->room)
        return true;
    const uint32_t room = s->limit + 1;
    uint16_t *pads = realloc(s->pads, room * sizeof *pads);
    if (!pads)
        return false;
    s->pads = pads;
    s->room = room;
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
    enum simulation_end end = board_last_output(t->b)->fault ? SIMULATION_FAULT : SIMULATION_ON;

    s->verdict = SEARCH_NO_SHIP;
    if (!room_for(s, s->limit)) {
        s->verdict = SEARCH_NO_MEMORY;
        return false;
    }
    while (end == SIMULATION_ON && !simulation_can_steer(t) && s->frames < s->limit) {
        const uint16_t pads = simulation_menu_pads(t);
        end = tick(t, pads);
        s->pads[s->frames++] = pads;
    }
    s->begin = s->last = s->frames;
    if (end == SIMULATION_FAULT)
        s->verdict = SEARCH_FAULT;
    return end == SIMULATION_ON && simulation_can_steer(t);
}

/* ---- forecast and flight ---- */

static uint16_t held(const struct simulation *t, uint16_t steer)
{
    return simulation_can_steer(t) ? (uint16_t)(steer | PAD_FIRE) : simulation_menu_pads(t);
}

/* Runs `frames` frames with an invincible ship, steered by the n pads first. */
static enum simulation_end make_forecast(struct work *w, uint32_t frames, const uint16_t *pads, uint32_t n)
{
    struct simulation *t = w->s->t;
    enum simulation_end end = SIMULATION_ON;

    forecast_clear(&w->forecast, board_frame(t->b));
    t->into = &w->forecast;
    danger_set_invincible(t->b, true);
    for (uint32_t f = 0; f < frames && end == SIMULATION_ON && !w->forecast.full; f++) {
        end = tick(t, held(t, f < n ? pads[f] : 0));
        if (f % PROGRESS_EVERY == 0)
            show_progress(w->s);
    }
    t->into = NULL;
    return end;
}

/* Flies a plan to its end or to a hit; the frame of the hit does not count as lived. */
static enum simulation_end fly(struct work *w, const struct plan *p, uint32_t from, uint32_t *lived)
{
    struct simulation *t = w->s->t;
    enum simulation_end end = SIMULATION_ON;

    for (*lived = 0; *lived < p->frames && from + *lived < w->s->limit; ++*lived) {
        const uint16_t pads = held(t, p->pads[*lived]);
        w->now[from + *lived] = pads;
        end = tick(t, pads);
        if (end == SIMULATION_ENDED)
            ++*lived;
        if (end != SIMULATION_ON)
            break;
    }
    return end;
}

/* Stores the current run if it is the longest. A run that reached the end is better than any longer run. */
static void keep_longest(struct work *w, uint32_t frames, enum simulation_end end)
{
    struct search *s = w->s;

    if (frames <= s->frames && end != SIMULATION_ENDED)
        return;
    memcpy(s->pads, w->now, frames * sizeof *s->pads);
    s->frames = s->last = frames;
}

static bool over(struct search *s, enum simulation_end end)
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
static void probe(struct work *w, const struct simulation_state *start, uint32_t frames)
{
    struct search *s = w->s;
    struct forecast first = w->forecast;
    uint32_t random = 1;
    uint16_t pads = 0;

    w->forecast = (struct forecast){ 0 };
    for (s->probes = 0; s->probes < PROBES && !s->reacts; s->probes++) {
        simulation_restore(s->t, start);
        forecast_clear(&w->forecast, s->begin);
        s->t->into = &w->forecast;
        s->t->astray = false;
        danger_set_invincible(s->t->b, true);
        for (uint32_t f = 0; f < frames && !s->reacts; f++) {
            random = random * 1664525u + 1013904223u;
            if (f % (4 + 4 * s->probes) == 0)
                pads = (uint16_t)((reach_pads((int)((random >> 16) % REACH_WAYS)) & ~PAD_FOCUS) |
                                  (random >> 9 & 1 ? PAD_FOCUS : 0) | (s->probes % 2 ? PAD_FIRE : 0));
            const enum simulation_end end = tick(s->t, pads);
            s->reacts = s->t->astray || end == SIMULATION_FAULT || (end != SIMULATION_ON && f + 1 < frames) ||
                        w->forecast.frames <= f || w->forecast.frame[f].print != first.frame[f].print;
            s->reacts_at = s->begin + f + 1;
        }
    }
    s->t->into = NULL;
    forecast_close(&w->forecast);
    w->forecast = first;
}

/* Searches with cells of one size. True: the verdict is final. */
static bool try_all(struct work *w, const struct simulation_state *start, fx cell)
{
    struct search *s = w->s;
    struct reach r;
    struct plan p = { 0 };
    uint32_t lived;
    bool decided = false, good;
    const fx x = start->ship.path.x, y = start->ship.path.y;

    good = reach_open(&r, &w->forecast, cell, 0, x, y);
    if (good && reach_ended(&r)) {
        probe(w, start, r.frames);
        decided = !s->reacts;
        s->verdict = SEARCH_CANNOT;
        s->last = s->begin + r.frames;
    }
    if (good && !decided) {
        reach_back(&r);
        s->plans++;
        good = plan_make(&p, &r, x, y, MOVES_ALL, 0, 1);
        simulation_restore(s->t, start);
        const enum simulation_end end = fly(w, &p, s->begin, &lived);
        const bool kept = decided;
        keep_longest(w, s->begin + lived, end);
        w->astray = end == SIMULATION_HIT && p.frames == w->forecast.frames;
        decided =
            kept || ((end != SIMULATION_ON || s->begin + lived >= s->limit) && end != SIMULATION_HIT && over(s, end));
    } else if (good) { /* for the longest run */
        const uint32_t last = s->last;
        reach_back(&r);
        if (plan_make(&p, &r, x, y, MOVES_ALL / 8, 0, 1)) {
            simulation_restore(s->t, start);
            const enum simulation_end end = fly(w, &p, s->begin, &lived);
            keep_longest(w, s->begin + lived, end);
        }
        s->last = last;
    }
    plan_free(&p);
    reach_close(&r);
    return decided;
}

static bool all_at_once(struct work *w, const struct simulation_state *start)
{
    struct search *s = w->s;
    const enum simulation_end end = make_forecast(w, s->limit - s->begin, NULL, 0);

    if (end == SIMULATION_FAULT && w->forecast.frames == 0) {
        s->verdict = SEARCH_FAULT;
        return true;
    }
    /* large cells are the cheapest; small ones do not help if bullets reacted to a ship on a complete path */
    for (fx cell = 2 * FX_ONE; cell >= FX_ONE / 2 && !s->reacts && !w->astray; cell /= 2)
        if (try_all(w, start, cell))
            return true;
    return false;
}

/* ---- segments ---- */

/* Drops every second saved state, except the newest. */
static void thin_out(struct work *w)
{
    int n = 1;

    for (int i = 1; i < w->places; i++) {
        if (i % 2 && i + 8 < w->places)
            simulation_state_free(&w->place[i].mark);
        else
            w->place[n++] = w->place[i];
        if (n - 1 != i)
            w->place[i].mark = (struct simulation_state){ 0 };
    }
    w->places = n;
}

static bool put_place(struct work *w)
{
    if (w->places == MARKS)
        thin_out(w);
    struct place *p = &w->place[w->places];
    p->frame = board_frame(w->s->t->b);
    if (!simulation_save(w->s->t, &p->mark))
        return false;
    w->places++;
    return true;
}

/* Makes and flies a plan from the last place; *best: frames of the longest so far, whose pads are in `keep`. */
static enum simulation_end try_plan(struct work *w, uint32_t *best, uint16_t keep[AHEAD])
{
    struct search *s = w->s;
    const struct place *at = &w->place[w->places - 1];
    const uint32_t left = s->limit - at->frame;
    struct reach r = { 0 };
    struct plan p = { 0 };
    uint32_t lived = 0;
    enum simulation_end end = SIMULATION_HIT;
    const fx x = at->mark.ship.path.x, y = at->mark.ship.path.y;

    simulation_restore(s->t, &at->mark);
    make_forecast(w, left < AHEAD ? left : AHEAD, w->guess, w->guessed);
    s->plans++;
    if (reach_open(&r, &w->forecast, 2 * FX_ONE, 0, x, y)) {
        reach_back(&r);
        plan_make(&p, &r, x, y, MOVES_SEGMENT, w->taste, 1);
        simulation_restore(s->t, &at->mark);
        end = fly(w, &p, at->frame, &lived);
        keep_longest(w, at->frame + lived, end);
        w->guessed = p.frames;
        memcpy(w->guess, p.pads, p.frames * sizeof *p.pads);
        if (lived > *best) {
            *best = lived;
            memcpy(keep, &w->now[at->frame], lived * sizeof *keep);
        }
    }
    plan_free(&p);
    reach_close(&r);
    return end;
}

/* Flies the first part of the best path. */
static enum simulation_end fly_kept(struct work *w, const uint16_t *keep, uint32_t frames)
{
    const struct place *at = &w->place[w->places - 1];
    enum simulation_end end = SIMULATION_ON;

    simulation_restore(w->s->t, &at->mark);
    for (uint32_t f = 0; f < frames && end == SIMULATION_ON; f++) {
        w->now[at->frame + f] = keep[f];
        end = tick(w->s->t, keep[f]);
    }
    return end;
}

/* Goes back over more places each time, at most to the first. */
static void go_back(struct work *w)
{
    w->back = w->back ? w->back * 2 : 1;
    w->taste++;
    w->guessed = 0;
    for (uint32_t i = 0; i < w->back && w->places > 1; i++)
        simulation_state_free(&w->place[--w->places].mark);
    if (w->back >= MARKS)
        w->back = 0;
}

/* Passes the frames in which the ship cannot be steered. */
static enum simulation_end wait_until_steered(struct work *w)
{
    struct simulation *t = w->s->t;
    enum simulation_end end = SIMULATION_ON;

    while (end == SIMULATION_ON && !simulation_can_steer(t) && board_frame(t->b) < w->s->limit) {
        const uint32_t frame = board_frame(t->b);
        w->now[frame] = simulation_menu_pads(t);
        end = tick(t, w->now[frame]);
        if (end != SIMULATION_HIT && end != SIMULATION_FAULT)
            keep_longest(w, frame + 1, end);
    }
    return end;
}

static enum simulation_end one_segment(struct work *w)
{
    uint16_t keep[AHEAD];
    uint32_t best = 0;
    enum simulation_end end = SIMULATION_ON;
    const uint32_t left = w->s->limit - w->place[w->places - 1].frame, whole = left < AHEAD ? left : AHEAD;

    for (int k = 0; k < TURNS && best < whole; k++) {
        end = try_plan(w, &best, keep);
        if (end == SIMULATION_ENDED || end == SIMULATION_FAULT)
            return end;
    }
    if (best == left) /* up to the limit */
        return SIMULATION_ON;
    if (best < LEAST) {
        go_back(w);
        simulation_restore(w->s->t, &w->place[w->places - 1].mark);
        return SIMULATION_ON;
    }
    const uint32_t flown = best == whole ? best / 2 : best / 3 + 1;
    w->guessed = 0;
    return fly_kept(w, keep, flown);
}

static void in_segments(struct work *w, const struct simulation_state *start)
{
    struct search *s = w->s;
    enum simulation_end end = SIMULATION_ON;
    uint32_t furthest = 0;

    memcpy(w->now, s->pads, s->begin * sizeof *w->now);
    simulation_restore(s->t, start);
    while (s->plans < s->effort * EFFORT) {
        if (end == SIMULATION_ON)
            end = wait_until_steered(w);
        if (end == SIMULATION_HIT) { /* while the ship could not be steered */
            go_back(w);
            simulation_restore(s->t, &w->place[w->places - 1].mark);
            end = SIMULATION_ON;
        }
        if (over(s, end))
            return;
        const uint32_t now = board_frame(s->t->b);
        if (w->places == 0 || w->place[w->places - 1].frame < now)
            if (!put_place(w))
                break;
        if (now > furthest + AHEAD) {
            furthest = now;
            w->back = 0;
        }
        show_progress(s);
        end = one_segment(w);
        if (over(s, end))
            return;
    }
    s->verdict = SEARCH_NOT_FOUND;
}

void search_run(struct search *s)
{
    struct work *w = calloc(1, sizeof *w);
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
        else if (!all_at_once(w, &start))
            in_segments(w, &start);
    }
    for (int i = 0; w && i < MARKS; i++)
        simulation_state_free(&w->place[i].mark);
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

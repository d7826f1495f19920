/*
 * seek.c - see seek.h.
 *
 * First all of the section is foreseen: it is run with a ship that nothing hits, and what the bullets do is written
 * down. Where that leaves a way, the way is flown; if bullets do not care where the ship is, that is all. Where it
 * leaves none, and bullets were the same in runs with other buttons, there is none.
 *
 * Else it goes on in pieces: foresees some frames, finds a way, flies it, and where bullets went elsewhere because of
 * that, foresees them again with the ship on that way. Of what was survived the first part is kept. In a dead end it
 * goes back, further each time, and prefers other ways.
 */
#include "seek.h"

#include <stdlib.h>
#include <string.h>
#include "plan.h"

enum {
    AHEAD = 120,        /* frames of a piece */
    LEAST = 6,          /* a way that is shorter is a dead end */
    TURNS = 4,          /* times a piece is foreseen anew */
    MARKS = 48,         /* places to go back to */
    WAYS_ALL = 1 << 21, /* ways a plan may look at, of all frames */
    WAYS_PIECE = 1 << 16,
    PROBES = 8,
    EFFORT = 100,   /* plans */
    TELL_EVERY = 64 /* frames */
};

struct place {
    struct trial_mark mark;
    uint32_t frame;
};

struct work {
    struct seek *s;
    struct place place[MARKS];
    int places;
    struct forecast forecast;
    uint32_t taste, back;
    uint16_t *now; /* the pads of the present run */
    uint16_t guess[AHEAD];
    uint32_t guessed;
    bool astray; /* a whole way through all that was foreseen was hit: bullets went elsewhere */
};

/* ---- frames ---- */

static bool room_for(struct seek *s, uint32_t frame)
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

static void tell(const struct seek *s, uint32_t done)
{
    if (s->tell)
        s->tell(s->user, done, s->limit);
}

static enum trial_end tick(struct trial *t, uint16_t pads)
{
    const uint16_t both[MAX_PLAYERS] = { pads, 0 };

    return trial_tick(t, both);
}

bool seek_begin(struct seek *s)
{
    struct trial *t = s->t;
    enum trial_end end = board_last_output(t->b)->fault ? TRIAL_FAULT : TRIAL_ON;

    s->verdict = SEEK_NO_SHIP;
    if (!room_for(s, s->limit)) {
        s->verdict = SEEK_NO_MEMORY;
        return false;
    }
    while (end == TRIAL_ON && !trial_steers(t) && s->frames < s->limit) {
        const uint16_t pads = trial_press(t);
        end = tick(t, pads);
        s->pads[s->frames++] = pads;
    }
    s->begin = s->last = s->frames;
    if (end == TRIAL_FAULT)
        s->verdict = SEEK_FAULT;
    return end == TRIAL_ON && trial_steers(t);
}

/* ---- what is foreseen ---- */

static uint16_t held(const struct trial *t, uint16_t steer)
{
    return trial_steers(t) ? (uint16_t)(steer | PAD_FIRE) : trial_press(t);
}

/* Runs so many frames with a ship that nothing hits. */
static enum trial_end foresee(struct work *w, uint32_t frames, const uint16_t *pads, uint32_t n)
{
    struct trial *t = w->s->t;
    enum trial_end end = TRIAL_ON;

    forecast_clear(&w->forecast, board_frame(t->b));
    t->into = &w->forecast;
    danger_set_invincible(t->b, true);
    for (uint32_t f = 0; f < frames && end == TRIAL_ON && !w->forecast.full; f++) {
        end = tick(t, held(t, f < n ? pads[f] : 0));
        if (f % TELL_EVERY == 0)
            tell(w->s, w->s->frames);
    }
    t->into = NULL;
    return end;
}

/* Flies a plan until it is over, or the ship is hit, which is no frame more. */
static enum trial_end fly(struct work *w, const struct plan *p, uint32_t from, uint32_t *lived)
{
    struct trial *t = w->s->t;
    enum trial_end end = TRIAL_ON;

    for (*lived = 0; *lived < p->frames && from + *lived < w->s->limit; ++*lived) {
        const uint16_t pads = held(t, p->pads[*lived]);
        w->now[from + *lived] = pads;
        end = tick(t, pads);
        if (end == TRIAL_ENDED)
            ++*lived;
        if (end != TRIAL_ON)
            break;
    }
    return end;
}

/* The present run has lived so long: is it the longest? One that came to the end is better than any that lived
 * longer. */
static void note(struct work *w, uint32_t frames, enum trial_end end)
{
    struct seek *s = w->s;

    if (frames <= s->frames && end != TRIAL_ENDED)
        return;
    memcpy(s->pads, w->now, frames * sizeof *s->pads);
    s->frames = s->last = frames;
}

static bool over(struct seek *s, enum trial_end end)
{
    if (end == TRIAL_ENDED)
        s->verdict = SEEK_SURVIVED;
    else if (end == TRIAL_FAULT)
        s->verdict = SEEK_FAULT;
    else if (s->frames >= s->limit)
        s->verdict = SEEK_LASTED;
    else
        return false;
    return true;
}

/* ---- all of it ---- */

/* Are the dangers of the first frames the same, whatever is pressed? */
static void probe(struct work *w, const struct trial_mark *start, uint32_t frames)
{
    struct seek *s = w->s;
    struct forecast first = w->forecast;
    uint32_t random = 1;
    uint16_t pads = 0;

    w->forecast = (struct forecast){ 0 };
    for (s->probes = 0; s->probes < PROBES && !s->reacts; s->probes++) {
        trial_restore(s->t, start);
        forecast_clear(&w->forecast, s->begin);
        s->t->into = &w->forecast;
        s->t->astray = false;
        danger_set_invincible(s->t->b, true);
        for (uint32_t f = 0; f < frames && !s->reacts; f++) {
            random = random * 1664525u + 1013904223u;
            if (f % (4 + 4 * s->probes) == 0)
                pads = (uint16_t)((reach_pads((int)((random >> 16) % REACH_WAYS)) & ~PAD_FOCUS) |
                                  (random >> 9 & 1 ? PAD_FOCUS : 0) | (s->probes % 2 ? PAD_FIRE : 0));
            const enum trial_end end = tick(s->t, pads);
            s->reacts = s->t->astray || end == TRIAL_FAULT || (end != TRIAL_ON && f + 1 < frames) ||
                        w->forecast.frames <= f || w->forecast.frame[f].print != first.frame[f].print;
            s->reacts_at = s->begin + f + 1;
        }
    }
    s->t->into = NULL;
    forecast_close(&w->forecast);
    w->forecast = first;
}

/* Tries sets of cells of one size. True: all is decided. */
static bool try_all(struct work *w, const struct trial_mark *start, fx cell)
{
    struct seek *s = w->s;
    struct reach r;
    struct plan p = { 0 };
    uint32_t lived;
    bool decided = false, good;
    const fx x = start->ship.path.x, y = start->ship.path.y;

    good = reach_open(&r, &w->forecast, cell, 0, x, y);
    if (good && reach_ended(&r)) {
        probe(w, start, r.frames);
        decided = !s->reacts;
        s->verdict = SEEK_CANNOT;
        s->last = s->begin + r.frames;
    }
    if (good && !decided) {
        reach_back(&r);
        s->plans++;
        good = plan_make(&p, &r, x, y, WAYS_ALL, 0, 1);
        trial_restore(s->t, start);
        const enum trial_end end = fly(w, &p, s->begin, &lived);
        const bool kept = decided;
        note(w, s->begin + lived, end);
        w->astray = end == TRIAL_HIT && p.frames == w->forecast.frames;
        decided = kept || ((end != TRIAL_ON || s->begin + lived >= s->limit) && end != TRIAL_HIT && over(s, end));
    } else if (good) { /* as far as it goes */
        const uint32_t last = s->last;
        reach_back(&r);
        if (plan_make(&p, &r, x, y, WAYS_ALL / 8, 0, 1)) {
            trial_restore(s->t, start);
            const enum trial_end end = fly(w, &p, s->begin, &lived);
            note(w, s->begin + lived, end);
        }
        s->last = last;
    }
    plan_free(&p);
    reach_close(&r);
    return decided;
}

static bool all_at_once(struct work *w, const struct trial_mark *start)
{
    struct seek *s = w->s;
    const enum trial_end end = foresee(w, s->limit - s->begin, NULL, 0);

    if (end == TRIAL_FAULT && w->forecast.frames == 0) {
        s->verdict = SEEK_FAULT;
        return true;
    }
    /* the largest cells are the cheapest; smaller ones are no use where a way led through and was hit all the same */
    for (fx cell = 2 * FX_ONE; cell >= FX_ONE / 2 && !s->reacts && !w->astray; cell /= 2)
        if (try_all(w, start, cell))
            return true;
    return false;
}

/* ---- in pieces ---- */

static void thin_out(struct work *w)
{
    int n = 1;

    for (int i = 1; i < w->places; i++) {
        if (i % 2 && i + 8 < w->places)
            trial_mark_free(&w->place[i].mark);
        else
            w->place[n++] = w->place[i];
        if (n - 1 != i)
            w->place[i].mark = (struct trial_mark){ 0 };
    }
    w->places = n;
}

static bool put_place(struct work *w)
{
    if (w->places == MARKS)
        thin_out(w);
    struct place *p = &w->place[w->places];
    p->frame = board_frame(w->s->t->b);
    if (!trial_save(w->s->t, &p->mark))
        return false;
    w->places++;
    return true;
}

/* Makes and flies one plan from the last place; *best: the frames of the longest so far, whose pads are in `keep`. */
static enum trial_end turn(struct work *w, uint32_t *best, uint16_t keep[AHEAD])
{
    struct seek *s = w->s;
    const struct place *at = &w->place[w->places - 1];
    const uint32_t left = s->limit - at->frame;
    struct reach r = { 0 };
    struct plan p = { 0 };
    uint32_t lived = 0;
    enum trial_end end = TRIAL_HIT;
    const fx x = at->mark.ship.path.x, y = at->mark.ship.path.y;

    trial_restore(s->t, &at->mark);
    foresee(w, left < AHEAD ? left : AHEAD, w->guess, w->guessed);
    s->plans++;
    if (reach_open(&r, &w->forecast, 2 * FX_ONE, 0, x, y)) {
        reach_back(&r);
        plan_make(&p, &r, x, y, WAYS_PIECE, w->taste, 1);
        trial_restore(s->t, &at->mark);
        end = fly(w, &p, at->frame, &lived);
        note(w, at->frame + lived, end);
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

/* The first part of the way that was kept is flown for good. */
static enum trial_end go(struct work *w, const uint16_t *keep, uint32_t frames)
{
    const struct place *at = &w->place[w->places - 1];
    enum trial_end end = TRIAL_ON;

    trial_restore(w->s->t, &at->mark);
    for (uint32_t f = 0; f < frames && end == TRIAL_ON; f++) {
        w->now[at->frame + f] = keep[f];
        end = tick(w->s->t, keep[f]);
    }
    return end;
}

/* Further each time, but for the first place. */
static void go_back(struct work *w)
{
    w->back = w->back ? w->back * 2 : 1;
    w->taste++;
    w->guessed = 0;
    for (uint32_t i = 0; i < w->back && w->places > 1; i++)
        trial_mark_free(&w->place[--w->places].mark);
    if (w->back >= MARKS)
        w->back = 0;
}

/* While it cannot be steered nothing is planned. */
static enum trial_end wait_until_steered(struct work *w)
{
    struct trial *t = w->s->t;
    enum trial_end end = TRIAL_ON;

    while (end == TRIAL_ON && !trial_steers(t) && board_frame(t->b) < w->s->limit) {
        const uint32_t frame = board_frame(t->b);
        w->now[frame] = trial_press(t);
        end = tick(t, w->now[frame]);
        if (end != TRIAL_HIT && end != TRIAL_FAULT)
            note(w, frame + 1, end);
    }
    return end;
}

static enum trial_end one_piece(struct work *w)
{
    uint16_t keep[AHEAD];
    uint32_t best = 0;
    enum trial_end end = TRIAL_ON;
    const uint32_t left = w->s->limit - w->place[w->places - 1].frame, whole = left < AHEAD ? left : AHEAD;

    for (int k = 0; k < TURNS && best < whole; k++) {
        end = turn(w, &best, keep);
        if (end == TRIAL_ENDED || end == TRIAL_FAULT)
            return end;
    }
    if (best == left) /* it has lasted */
        return TRIAL_ON;
    if (best < LEAST) {
        go_back(w);
        trial_restore(w->s->t, &w->place[w->places - 1].mark);
        return TRIAL_ON;
    }
    const uint32_t flown = best == whole ? best / 2 : best / 3 + 1;
    w->guessed = 0;
    end = go(w, keep, flown);
    return end;
}

static void in_pieces(struct work *w, const struct trial_mark *start)
{
    struct seek *s = w->s;
    enum trial_end end = TRIAL_ON;
    uint32_t furthest = 0;

    memcpy(w->now, s->pads, s->begin * sizeof *w->now);
    trial_restore(s->t, start);
    while (s->plans < s->effort * EFFORT) {
        if (end == TRIAL_ON)
            end = wait_until_steered(w);
        if (end == TRIAL_HIT) { /* while it could not be steered */
            go_back(w);
            trial_restore(s->t, &w->place[w->places - 1].mark);
            end = TRIAL_ON;
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
        tell(s, s->frames);
        end = one_piece(w);
        if (over(s, end))
            return;
    }
    s->verdict = SEEK_NOT_FOUND;
}

void seek_run(struct seek *s)
{
    struct work *w = calloc(1, sizeof *w);
    struct trial_mark start = { 0 };

    s->verdict = SEEK_NO_MEMORY;
    if (w) {
        w->s = s;
        w->now = calloc(s->limit + 1, sizeof *w->now);
    }
    if (w && w->now && seek_begin(s)) {
        memcpy(w->now, s->pads, s->begin * sizeof *w->now);
        if (!trial_save(s->t, &start))
            s->verdict = SEEK_NO_MEMORY;
        else if (!all_at_once(w, &start))
            in_pieces(w, &start);
    }
    for (int i = 0; w && i < MARKS; i++)
        trial_mark_free(&w->place[i].mark);
    if (w) {
        forecast_close(&w->forecast);
        free(w->now);
    }
    free(w);
    trial_mark_free(&start);
}

void seek_close(struct seek *s)
{
    free(s->pads);
    s->pads = NULL;
}

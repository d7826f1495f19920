/*
 * plan.c - see plan.h. The search is depth-first. The sets contain only cells that lead to the end, so the first
 * choice, the move to the most free space, is nearly always right.
 */
#include "plan.h"

#include <stdlib.h>
#include <string.h>

enum { SPACE_DISTANCES = 4 /* distances at which free space is measured */ };

struct step {
    fx x, y;
    uint8_t order[REACH_MOVES]; /* the moves from here, the best first */
    uint8_t next, n, move;      /* next: index in order; n: length of order; move: the move that led here */
};

struct planner {
    const struct reach *r;
    struct plan *plan;
    struct step *step;
    uint8_t *seen; /* a bit per cell and frame */
    uint32_t seed;
    int aims;
};

bool plan_hits(const struct forecast *f, uint32_t frame, const struct danger_path *move, fx extra_radius)
{
    const struct forecast_frame *at = &f->frame[frame];
    struct danger_path wide = *move;
    const fx far = fx_max(fx_abs(move->x - move->prev_x), fx_abs(move->y - move->prev_y));

    wide.radius += extra_radius;
    if (at->safe)
        return false;
    for (uint32_t i = 0; i < at->n; i++) {
        const struct danger *d = &f->list[at->first + i];
        const int64_t reach = (int64_t)d->a + fx_max(fx_abs(d->b), fx_abs(d->c)) + wide.radius + far;
        if (d->shape != DANGER_LASER_SEGMENT && (int64_t)fx_abs(d->x - move->x) > reach + fx_abs(d->mx))
            continue;
        if (d->shape != DANGER_LASER_SEGMENT && (int64_t)fx_abs(d->y - move->y) > reach + fx_abs(d->my))
            continue;
        if (danger_would_hit(d, &wide))
            return true;
    }
    return false;
}

static uint32_t hash(uint32_t v)
{
    v = (v ^ v >> 16) * 0x7feb352du;
    v = (v ^ v >> 15) * 0x846ca68bu;
    return v ^ v >> 16;
}

/* Returns the free space around a position: a weighted count of the positions 1, 2, 4 ... px away, in four directions,
 * that are in the set. */
static int free_space(const struct reach *r, uint32_t t, fx x, fx y)
{
    static const int towards[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
    int room = 0;

    for (int k = 0; k < SPACE_DISTANCES; k++)
        for (int i = 0; i < 4; i++)
            room += (SPACE_DISTANCES - k) *
                    reach_has(r, t, x + towards[i][0] * (FX_ONE << k), y + towards[i][1] * (FX_ONE << k));
    return room;
}

/* Rates a move; higher is better. */
static int64_t rate_move(const struct planner *s, uint32_t t, fx x, fx y, int move, int before)
{
    const struct forecast_frame *frame = &s->r->f->frame[t];
    const struct box *a = &s->r->area;
    const fx low = a->y0 + (fx)(((int64_t)a->y1 - a->y0) * 4 / 5);
    const fx middle = s->aims ? frame->enemy_x : a->x0 + (a->x1 - a->x0) / 2;
    int64_t v = (int64_t)free_space(s->r, t + 1, x, y) * (s->aims > 1 ? 2 : 16) * FX_ONE;

    v -= ((int64_t)fx_abs(x - middle) + fx_abs(y - low)) * 2 / 3;
    v += move == before ? 2 * FX_ONE : move == 0 ? FX_ONE : 0;
    if (s->seed)
        v += (int64_t)(hash(s->seed * 2654435761u ^ t / 16 * 97 ^ (uint32_t)move) % 64) * FX_ONE;
    return v;
}

/* Sorts the moves from a step. */
static void sort_moves(const struct planner *s, uint32_t t, struct step *at)
{
    const struct forecast_frame *frame = &s->r->f->frame[t];
    int64_t value[REACH_MOVES];

    at->next = at->n = 0;
    for (int move = 0; move < (frame->moves ? REACH_MOVES : 1); move++) {
        fx x = at->x, y = at->y;
        if (frame->moves)
            reach_apply_move(&frame->ship, move, &x, &y);
        if (!reach_has(s->r, t + 1, x, y))
            continue;
        const int64_t v = rate_move(s, t, x, y, move, at->move);
        int i = at->n++;
        for (; i > 0 && value[i - 1] < v; i--) {
            value[i] = value[i - 1];
            at->order[i] = at->order[i - 1];
        }
        value[i] = v;
        at->order[i] = (uint8_t)move;
    }
}

static bool visit(struct planner *s, uint32_t t, fx x, fx y)
{
    const struct reach *r = s->r;
    const size_t cell = (size_t)((y - r->area.y0) / r->cell) * (size_t)r->w + (size_t)((x - r->area.x0) / r->cell);
    uint8_t *byte = s->seen + (size_t)t * r->bytes + cell / 8;
    const uint8_t bit = (uint8_t)(1 << cell % 8);
    const bool seen = *byte & bit;

    *byte |= bit;
    return !seen;
}

/* Tries the next move of step t; true: it leads to step t + 1. */
static bool try_move(struct planner *s, uint32_t t)
{
    const struct forecast_frame *frame = &s->r->f->frame[t];
    struct step *at = &s->step[t];
    const int move = at->order[at->next++];
    struct danger_path path = { .prev_x = at->x, .prev_y = at->y, .x = at->x, .y = at->y };

    path.radius = frame->ship.path.radius;
    if (frame->moves)
        reach_apply_move(&frame->ship, move, &path.x, &path.y);
    s->plan->tried++;
    if (plan_hits(s->r->f, t, &path, s->r->extra_radius) || !visit(s, t + 1, path.x, path.y))
        return false;
    s->step[t + 1].x = path.x;
    s->step[t + 1].y = path.y;
    s->step[t + 1].move = (uint8_t)move;
    return true;
}

static void store_path(struct planner *s, uint32_t t)
{
    if (t <= s->plan->frames)
        return;
    s->plan->frames = t;
    for (uint32_t i = 0; i < t; i++)
        s->plan->pads[i] = reach_move_pads(s->step[i + 1].move);
}

static void search_path(struct planner *s, uint64_t max_moves)
{
    const uint32_t end = s->r->f->frames < s->r->frames ? s->r->f->frames : s->r->frames;
    uint32_t t = 0, deepest = 0;

    sort_moves(s, 0, &s->step[0]);
    while (t < end && s->plan->tried < max_moves) {
        if (s->step[t].next < s->step[t].n) {
            if (!try_move(s, t))
                continue;
            t++;
            if (t < end)
                sort_moves(s, t, &s->step[t]);
            continue;
        }
        if (t > deepest) { /* the search backtracks from here */
            deepest = t;
            store_path(s, t);
        }
        if (t-- == 0)
            return;
    }
    store_path(s, t);
}

bool plan_make(struct plan *p, const struct reach *r, fx x, fx y, uint64_t max_moves, uint32_t seed, int aims)
{
    const size_t n = (size_t)r->f->frames + 1;
    struct planner s = { .r = r, .plan = p, .seed = seed, .aims = aims };

    *p = (struct plan){ .pads = calloc(n, sizeof *p->pads) };
    s.step = calloc(n, sizeof *s.step);
    s.seen = calloc(n, r->bytes);
    const bool good = p->pads && s.step && s.seen;
    if (good) {
        s.step[0] = (struct step){ .x = fx_clamp(x, r->area.x0, r->area.x1),
                                   .y = fx_clamp(y, r->area.y0, r->area.y1),
                                   .move = 0 };
        search_path(&s, max_moves);
    }
    free(s.step);
    free(s.seen);
    return good;
}

void plan_free(struct plan *p)
{
    free(p->pads);
    *p = (struct plan){ 0 };
}

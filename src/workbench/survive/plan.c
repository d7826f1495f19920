/*
 * plan.c - see plan.h. The search is depth first. The sets contain only cells that lead on, so the first choice, the
 * one with the most free space around it, is nearly always right.
 */
#include "plan.h"

#include <stdlib.h>
#include <string.h>

enum { NEAR = 4 /* distances at which free space is measured */ };

struct step {
    fx x, y;
    uint8_t order[REACH_WAYS]; /* the moves from here, the best first */
    uint8_t next, n, way;      /* next, n: of order; way: the move that led here */
};

struct planner {
    const struct reach *r;
    struct plan *plan;
    struct step *step;
    uint8_t *seen; /* a bit a cell a frame */
    uint32_t taste;
    int aims;
};

bool plan_hits(const struct forecast *f, uint32_t frame, const struct danger_path *way, fx grown)
{
    const struct forecast_frame *at = &f->frame[frame];
    struct danger_path wide = *way;
    const fx far = fx_max(fx_abs(way->x - way->prev_x), fx_abs(way->y - way->prev_y));

    wide.radius += grown;
    if (at->safe)
        return false;
    for (uint32_t i = 0; i < at->n; i++) {
        const struct danger *d = &f->list[at->first + i];
        const int64_t reach = (int64_t)d->a + fx_max(fx_abs(d->b), fx_abs(d->c)) + wide.radius + far;
        if (d->shape != DANGER_LASER_SEGMENT && (int64_t)fx_abs(d->x - way->x) > reach + fx_abs(d->mx))
            continue;
        if (d->shape != DANGER_LASER_SEGMENT && (int64_t)fx_abs(d->y - way->y) > reach + fx_abs(d->my))
            continue;
        if (danger_would_hit(d, &wide))
            return true;
    }
    return false;
}

static uint32_t mix(uint32_t v)
{
    v = (v ^ v >> 16) * 0x7feb352du;
    v = (v ^ v >> 15) * 0x846ca68bu;
    return v ^ v >> 16;
}

/* Returns the free space around a position: how many positions 1, 2, 4 ... px away in four directions lead on. */
static int room_round(const struct reach *r, uint32_t t, fx x, fx y)
{
    static const int towards[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
    int room = 0;

    for (int k = 0; k < NEAR; k++)
        for (int i = 0; i < 4; i++)
            room += (NEAR - k) * reach_has(r, t, x + towards[i][0] * (FX_ONE << k), y + towards[i][1] * (FX_ONE << k));
    return room;
}

/* Rates a move; higher is better. */
static int64_t worth(const struct planner *s, uint32_t t, fx x, fx y, int way, int before)
{
    const struct forecast_frame *frame = &s->r->f->frame[t];
    const struct box *a = &s->r->area;
    const fx low = a->y0 + (fx)(((int64_t)a->y1 - a->y0) * 4 / 5);
    const fx middle = s->aims ? frame->foe_x : a->x0 + (a->x1 - a->x0) / 2;
    int64_t v = (int64_t)room_round(s->r, t + 1, x, y) * (s->aims > 1 ? 2 : 16) * FX_ONE;

    v -= ((int64_t)fx_abs(x - middle) + fx_abs(y - low)) * 2 / 3;
    v += way == before ? 2 * FX_ONE : way == 0 ? FX_ONE : 0;
    if (s->taste)
        v += (int64_t)(mix(s->taste * 2654435761u ^ t / 16 * 97 ^ (uint32_t)way) % 64) * FX_ONE;
    return v;
}

/* Sorts the moves from a step. */
static void sort_moves(const struct planner *s, uint32_t t, struct step *at)
{
    const struct forecast_frame *frame = &s->r->f->frame[t];
    int64_t value[REACH_WAYS];

    at->next = at->n = 0;
    for (int way = 0; way < (frame->moves ? REACH_WAYS : 1); way++) {
        fx x = at->x, y = at->y;
        if (frame->moves)
            reach_step(&frame->ship, way, &x, &y);
        if (!reach_has(s->r, t + 1, x, y))
            continue;
        const int64_t v = worth(s, t, x, y, way, at->way);
        int i = at->n++;
        for (; i > 0 && value[i - 1] < v; i--) {
            value[i] = value[i - 1];
            at->order[i] = at->order[i - 1];
        }
        value[i] = v;
        at->order[i] = (uint8_t)way;
    }
}

static bool first_time(struct planner *s, uint32_t t, fx x, fx y)
{
    const struct reach *r = s->r;
    const size_t cell = (size_t)((y - r->area.y0) / r->cell) * (size_t)r->w + (size_t)((x - r->area.x0) / r->cell);
    uint8_t *byte = s->seen + (size_t)t * r->bytes + cell / 8;
    const uint8_t bit = (uint8_t)(1 << cell % 8);
    const bool seen = *byte & bit;

    *byte |= bit;
    return !seen;
}

/* Tries the next move of the step at t; true: it leads on. */
static bool try_move(struct planner *s, uint32_t t)
{
    const struct forecast_frame *frame = &s->r->f->frame[t];
    struct step *at = &s->step[t];
    const int way = at->order[at->next++];
    struct danger_path move = { .prev_x = at->x, .prev_y = at->y, .x = at->x, .y = at->y };

    move.radius = frame->ship.path.radius;
    if (frame->moves)
        reach_step(&frame->ship, way, &move.x, &move.y);
    s->plan->tried++;
    if (plan_hits(s->r->f, t, &move, s->r->grown) || !first_time(s, t + 1, move.x, move.y))
        return false;
    s->step[t + 1].x = move.x;
    s->step[t + 1].y = move.y;
    s->step[t + 1].way = (uint8_t)way;
    return true;
}

static void keep(struct planner *s, uint32_t t)
{
    if (t <= s->plan->frames)
        return;
    s->plan->frames = t;
    for (uint32_t i = 0; i < t; i++)
        s->plan->pads[i] = reach_pads(s->step[i + 1].way);
}

static void run(struct planner *s, uint64_t most)
{
    const uint32_t end = s->r->f->frames < s->r->frames ? s->r->f->frames : s->r->frames;
    uint32_t t = 0, deepest = 0;

    sort_moves(s, 0, &s->step[0]);
    while (t < end && s->plan->tried < most) {
        if (s->step[t].next < s->step[t].n) {
            if (!try_move(s, t))
                continue;
            t++;
            if (t < end)
                sort_moves(s, t, &s->step[t]);
            continue;
        }
        if (t > deepest) { /* the search goes back from here */
            deepest = t;
            keep(s, t);
        }
        if (t-- == 0)
            return;
    }
    keep(s, t);
}

bool plan_make(struct plan *p, const struct reach *r, fx x, fx y, uint64_t most, uint32_t taste, int aims)
{
    const size_t n = (size_t)r->f->frames + 1;
    struct planner s = { .r = r, .plan = p, .taste = taste, .aims = aims };

    *p = (struct plan){ .pads = calloc(n, sizeof *p->pads) };
    s.step = calloc(n, sizeof *s.step);
    s.seen = calloc(n, r->bytes);
    const bool good = p->pads && s.step && s.seen;
    if (good) {
        s.step[0] = (struct step){ .x = fx_clamp(x, r->area.x0, r->area.x1),
                                   .y = fx_clamp(y, r->area.y0, r->area.y1),
                                   .way = 0 };
        run(&s, most);
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

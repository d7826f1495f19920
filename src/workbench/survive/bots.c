/*
 * bots.c - see bots.h.
 */
#include "bots.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "reach.h"

enum {
    REACTION = 12,    /* frames of reaction time */
    DECIDE_EVERY = 4, /* frames between two decisions */
    MOVE_FRAMES = 10, /* frames of the rated move */
    LOOK_AHEAD = 40,  /* frames; every second one is checked */
    MAX_SPACE = 20,   /* px; more free space makes no difference */
    MOVES = REACH_MOVES,
    HISTORY = REACTION + 1
};

static const int shares[BOT_KINDS] = { [BOT_STAND] = 4, [BOT_WANDER] = 6, [BOT_DODGE] = 6 }; /* of BOTS */

struct bot {
    enum bot_kind kind;
    int number, of; /* index, and count of its kind */
    uint32_t random;
    fx to_x, to_y; /* target */
    uint32_t until;
    uint16_t pads;
    struct forecast history[HISTORY]; /* ring buffer of the last frames; of BOT_DODGE */
};

static uint32_t random_below(struct bot *b, uint32_t below)
{
    b->random = b->random * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)b->random * below >> 32);
}

static uint16_t towards(const struct danger_ship *ship, fx x, fx y)
{
    const fx dx = x - ship->path.x, dy = y - ship->path.y;

    return (uint16_t)((dx > ship->speed    ? PAD_RIGHT
                       : dx < -ship->speed ? PAD_LEFT
                                           : 0) |
                      (dy > ship->speed    ? PAD_DOWN
                       : dy < -ship->speed ? PAD_UP
                                           : 0));
}

/* Returns the distance of the nearest bullet from (x, y) in `ahead` frames, edge to edge, in px, at most MAX_SPACE. */
static double free_space(const struct forecast *f, double x, double y, double radius, int ahead)
{
    double best = MAX_SPACE;

    for (size_t i = 0; i < f->n; i++) {
        const struct danger *d = &f->list[i];
        const double frames = ahead + REACTION;
        const double dx = fabs((d->x + d->mx * frames) / FX_ONE - x), dy = fabs((d->y + d->my * frames) / FX_ONE - y);
        const double reach = (d->a + (double)(d->shape == DANGER_BOX ? d->b : 0)) / FX_ONE + radius;
        if (dx > MAX_SPACE + reach || dy > MAX_SPACE + reach)
            continue;
        const double away = sqrt(dx * dx + dy * dy) - reach;
        best = away < best ? away : best;
    }
    return best;
}

/* Rates a move: frames until a hit, plus free space, minus the distance from the lower centre of the field. */
static double rate_move(const struct forecast *f, const struct danger_ship *ship, int move)
{
    const double w = (double)ship->area.x1 - ship->area.x0, h = (double)ship->area.y1 - ship->area.y0;
    fx x = ship->path.x, y = ship->path.y;
    double space = MAX_SPACE;
    int at = 0;

    for (; at < LOOK_AHEAD && space >= 0; at++) {
        reach_apply_move(ship, at < MOVE_FRAMES ? move : 0, &x, &y);
        if (at % 2 == 0)
            continue;
        const double here =
            free_space(f, x / (double)FX_ONE, y / (double)FX_ONE, ship->path.radius / (double)FX_ONE, at);
        space = here < space ? here : space;
    }
    return at + (space < 6 ? space : 6) - fabs(x - ship->area.x0 - w / 2) / w * 4 -
           fabs(y - ship->area.y0 - h * 0.8) / h * 4;
}

static uint16_t choose_move(struct bot *b, const struct danger_ship *ship, uint32_t frame)
{
    const struct forecast *old = &b->history[(frame + 1) % HISTORY];
    double best = -1e9;
    int chosen = 0;

    for (int move = 0; move < MOVES; move++) {
        const double v = rate_move(old, ship, move) + random_below(b, 100) * 0.004;
        if (v > best) {
            best = v;
            chosen = move;
        }
    }
    return reach_move_pads(chosen);
}

static uint16_t choose_pads(struct bot *b, const struct danger_ship *ship, uint32_t frame)
{
    const fx w = ship->area.x1 - ship->area.x0, h = ship->area.y1 - ship->area.y0;

    if (frame < b->until)
        return b->kind == BOT_DODGE ? b->pads : towards(ship, b->to_x, b->to_y);
    if (b->kind == BOT_DODGE) {
        b->until = frame + DECIDE_EVERY;
        b->pads = choose_move(b, ship, frame);
        return b->pads;
    }
    b->to_x = ship->area.x0 +
              (b->kind == BOT_STAND ? w / (2 * b->of) * (1 + 2 * b->number) : (fx)random_below(b, (uint32_t)w));
    b->to_y = ship->area.y0 + h / 2 + (b->kind == BOT_STAND ? h / 4 : (fx)random_below(b, (uint32_t)h / 2));
    b->until = b->kind == BOT_STAND ? UINT32_MAX : frame + 20 + random_below(b, 40);
    return towards(ship, b->to_x, b->to_y);
}

static enum simulation_end tick(struct simulation *t, struct bot *b)
{
    const uint32_t frame = board_frame(t->b);
    uint16_t pads[MAX_PLAYERS] = { simulation_menu_pads(t), 0 };

    if (simulation_can_steer(t))
        pads[0] = (uint16_t)(choose_pads(b, &t->ship, frame) | PAD_FIRE);
    t->recording = b->kind == BOT_DODGE ? &b->history[frame % HISTORY] : NULL;
    forecast_clear(&b->history[frame % HISTORY], frame);
    const enum simulation_end end = simulation_tick(t, pads);
    t->recording = NULL;
    return end;
}

static enum simulation_end play_until_hit(struct simulation *t, struct bot *b, uint32_t limit)
{
    enum simulation_end end = SIMULATION_RUNNING;

    while (end == SIMULATION_RUNNING && board_frame(t->b) < limit)
        end = tick(t, b);
    return end;
}

/* Plays with an invincible ship, and counts hits. */
static enum simulation_end play_invincible(struct simulation *t, struct bot *b, const struct simulation_state *start,
                                           uint32_t limit, struct bots *out)
{
    enum simulation_end end = SIMULATION_RUNNING;
    uint32_t lived = 0, hits = 0;
    int mercy = 0;

    danger_set_invincible(t->b, true);
    while (end == SIMULATION_RUNNING && board_frame(t->b) < limit) {
        end = tick(t, b);
        if (mercy > 0)
            mercy--;
        else if (t->moved && t->ship.can_steer && !t->ship.is_safe) {
            out->flown[b->kind]++;
            hits += t->touched;
            mercy = t->touched ? BOTS_MERCY : 0;
        }
        if (hits == 0)
            lived = board_frame(t->b) - start->frame;
    }
    out->hits[b->kind] += hits;
    out->frames += lived;
    out->survived[b->kind] += hits == 0;
    return end;
}

static bool play_bots(struct simulation *t, const struct simulation_state *start, uint32_t limit, int bots,
                      bool invincible, struct bots *out)
{
    struct bot *b = malloc(sizeof *b);

    *out = (struct bots){ 0 };
    for (int kind = 0, before = 0, sum = 0; b && kind < BOT_KINDS && !out->fault; kind++) {
        sum += shares[kind];
        const int to = bots * sum / BOTS, of = to - before;
        for (int i = 0; i < of && !out->fault; i++) {
            *b = (struct bot){ .kind = (enum bot_kind)kind, .number = i, .of = of, .random = 77u * (uint32_t)(i + 1) };
            simulation_restore(t, start);
            out->n[kind]++;
            if (invincible)
                out->fault |= play_invincible(t, b, start, limit, out) == SIMULATION_FAULT;
            else {
                const enum simulation_end end = play_until_hit(t, b, limit);
                out->survived[kind] += end == SIMULATION_ENDED || end == SIMULATION_RUNNING;
                out->frames += board_frame(t->b) - start->frame;
            }
            for (int k = 0; k < HISTORY; k++)
                forecast_close(&b->history[k]);
        }
        before = to;
    }
    free(b);
    return b != NULL;
}

bool bots_play(struct simulation *t, const struct simulation_state *start, uint32_t limit, struct bots *out)
{
    return play_bots(t, start, limit, BOTS, false, out);
}

bool bots_play_invincible(struct simulation *t, const struct simulation_state *start, uint32_t limit, int bots,
                          struct bots *out)
{
    return play_bots(t, start, limit, bots, true, out);
}

/* Returns hits per minute in tenths; 0 without frames. */
static uint32_t hits_per_minute(uint64_t hits, uint64_t flown)
{
    return flown ? (uint32_t)(hits * 60 * 60 * 10 / flown) : 0;
}

uint32_t bots_rate(const struct bots *b)
{
    return hits_per_minute(bots_hits(b), bots_flown(b));
}

uint32_t bots_rate_of(const struct bots *b, enum bot_kind kind)
{
    return hits_per_minute(b->hits[kind], b->flown[kind]);
}

uint32_t bots_hits(const struct bots *b)
{
    return b->hits[BOT_STAND] + b->hits[BOT_WANDER] + b->hits[BOT_DODGE];
}

uint32_t bots_flown(const struct bots *b)
{
    return b->flown[BOT_STAND] + b->flown[BOT_WANDER] + b->flown[BOT_DODGE];
}

int bots_count(const struct bots *b)
{
    return b->n[BOT_STAND] + b->n[BOT_WANDER] + b->n[BOT_DODGE];
}

int bots_survived(const struct bots *b)
{
    return b->survived[BOT_STAND] + b->survived[BOT_WANDER] + b->survived[BOT_DODGE];
}

uint32_t bots_mean(const struct bots *b)
{
    return bots_count(b) ? b->frames / (uint32_t)bots_count(b) : 0;
}

void bots_compare(const struct bots *easier, const struct bots *harder, char *why, size_t size)
{
    const uint32_t rate = bots_rate(easier), then = bots_rate(harder);

    why[0] = 0;
    if (rate * 19 > then * 20)
        snprintf(why, size, "%u.%u hits per minute, compared with %u.%u", (unsigned)(rate / 10), (unsigned)(rate % 10),
                 (unsigned)(then / 10), (unsigned)(then % 10));
}

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
    LATE = 12,  /* frames of reaction time */
    THINKS = 4, /* frames between two decisions */
    FLIES = 10, /* frames of a planned move */
    LOOKS = 40, /* frames of look-ahead, of which every second is checked */
    ROOM = 20,  /* px; more free space is not better */
    WAYS = REACH_WAYS,
    SEEN = LATE + 1
};

static const int how_many[BOT_KINDS] = { [BOT_STAND] = 4, [BOT_WANDER] = 6, [BOT_DODGE] = 6 }; /* of BOTS */

struct bot {
    enum bot_kind kind;
    int number, of; /* of its kind */
    uint32_t random;
    fx to_x, to_y; /* where it goes */
    uint32_t until;
    uint16_t pads;
    struct forecast seen[SEEN]; /* the last frames, in turn; of BOT_DODGE */
};

static uint32_t draw(struct bot *b, uint32_t below)
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

/* Returns the distance of the nearest bullet from (x, y) in `ahead` frames, edge to edge, in px, at most ROOM. */
static double nearness(const struct forecast *f, double x, double y, double radius, int ahead)
{
    double best = ROOM;

    for (size_t i = 0; i < f->n; i++) {
        const struct danger *d = &f->list[i];
        const double frames = ahead + LATE;
        const double dx = fabs((d->x + d->mx * frames) / FX_ONE - x), dy = fabs((d->y + d->my * frames) / FX_ONE - y);
        const double reach = (d->a + (double)(d->shape == DANGER_BOX ? d->b : 0)) / FX_ONE + radius;
        if (dx > ROOM + reach || dy > ROOM + reach)
            continue;
        const double away = sqrt(dx * dx + dy * dy) - reach;
        best = away < best ? away : best;
    }
    return best;
}

/* Rates a move: frames until a hit, plus free space, minus the distance from the lower middle of the field. */
static double worth(const struct forecast *f, const struct danger_ship *ship, int way)
{
    const double w = (double)ship->area.x1 - ship->area.x0, h = (double)ship->area.y1 - ship->area.y0;
    fx x = ship->path.x, y = ship->path.y;
    double room = ROOM;
    int at = 0;

    for (; at < LOOKS && room >= 0; at++) {
        reach_step(ship, at < FLIES ? way : 0, &x, &y);
        if (at % 2 == 0)
            continue;
        const double here = nearness(f, x / (double)FX_ONE, y / (double)FX_ONE, ship->path.radius / (double)FX_ONE, at);
        room = here < room ? here : room;
    }
    return at + (room < 6 ? room : 6) - fabs(x - ship->area.x0 - w / 2) / w * 4 -
           fabs(y - ship->area.y0 - h * 0.8) / h * 4;
}

static uint16_t dodge(struct bot *b, const struct danger_ship *ship, uint32_t frame)
{
    const struct forecast *old = &b->seen[(frame + 1) % SEEN];
    double best = -1e9;
    int chosen = 0;

    for (int way = 0; way < WAYS; way++) {
        const double v = worth(old, ship, way) + draw(b, 100) * 0.004;
        if (v > best) {
            best = v;
            chosen = way;
        }
    }
    return reach_pads(chosen);
}

static uint16_t think(struct bot *b, const struct danger_ship *ship, uint32_t frame)
{
    const fx w = ship->area.x1 - ship->area.x0, h = ship->area.y1 - ship->area.y0;

    if (frame < b->until)
        return b->kind == BOT_DODGE ? b->pads : towards(ship, b->to_x, b->to_y);
    if (b->kind == BOT_DODGE) {
        b->until = frame + THINKS;
        b->pads = dodge(b, ship, frame);
        return b->pads;
    }
    b->to_x = ship->area.x0 + (b->kind == BOT_STAND ? w / (2 * b->of) * (1 + 2 * b->number) : (fx)draw(b, (uint32_t)w));
    b->to_y = ship->area.y0 + h / 2 + (b->kind == BOT_STAND ? h / 4 : (fx)draw(b, (uint32_t)h / 2));
    b->until = b->kind == BOT_STAND ? UINT32_MAX : frame + 20 + draw(b, 40);
    return towards(ship, b->to_x, b->to_y);
}

static enum simulation_end tick(struct simulation *t, struct bot *b)
{
    const uint32_t frame = board_frame(t->b);
    uint16_t pads[MAX_PLAYERS] = { simulation_menu_pads(t), 0 };

    if (simulation_can_steer(t))
        pads[0] = (uint16_t)(think(b, &t->ship, frame) | PAD_FIRE);
    t->into = b->kind == BOT_DODGE ? &b->seen[frame % SEEN] : NULL;
    forecast_clear(&b->seen[frame % SEEN], frame);
    const enum simulation_end end = simulation_tick(t, pads);
    t->into = NULL;
    return end;
}

static enum simulation_end play(struct simulation *t, struct bot *b, uint32_t limit)
{
    enum simulation_end end = SIMULATION_ON;

    while (end == SIMULATION_ON && board_frame(t->b) < limit)
        end = tick(t, b);
    return end;
}

/* Plays with an invincible ship, and counts hits. */
static enum simulation_end play_on(struct simulation *t, struct bot *b, const struct simulation_state *start,
                                   uint32_t limit, struct bots *out)
{
    enum simulation_end end = SIMULATION_ON;
    uint32_t lived = 0, hits = 0;
    int mercy = 0;

    danger_set_invincible(t->b, true);
    while (end == SIMULATION_ON && board_frame(t->b) < limit) {
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
    out->lived[b->kind] += hits == 0;
    return end;
}

static bool all_play(struct simulation *t, const struct simulation_state *start, uint32_t limit, int bots, bool on,
                     struct bots *out)
{
    struct bot *b = malloc(sizeof *b);

    *out = (struct bots){ 0 };
    for (int kind = 0, before = 0, sum = 0; b && kind < BOT_KINDS && !out->fault; kind++) {
        sum += how_many[kind];
        const int to = bots * sum / BOTS, of = to - before;
        for (int i = 0; i < of && !out->fault; i++) {
            *b = (struct bot){ .kind = (enum bot_kind)kind, .number = i, .of = of, .random = 77u * (uint32_t)(i + 1) };
            simulation_restore(t, start);
            out->n[kind]++;
            if (on)
                out->fault |= play_on(t, b, start, limit, out) == SIMULATION_FAULT;
            else {
                const enum simulation_end end = play(t, b, limit);
                out->lived[kind] += end == SIMULATION_ENDED || end == SIMULATION_ON;
                out->frames += board_frame(t->b) - start->frame;
            }
            for (int k = 0; k < SEEN; k++)
                forecast_close(&b->seen[k]);
        }
        before = to;
    }
    free(b);
    return b != NULL;
}

bool bots_play(struct simulation *t, const struct simulation_state *start, uint32_t limit, struct bots *out)
{
    return all_play(t, start, limit, BOTS, false, out);
}

bool bots_play_on(struct simulation *t, const struct simulation_state *start, uint32_t limit, int bots,
                  struct bots *out)
{
    return all_play(t, start, limit, bots, true, out);
}

/* In tenths a minute; 0 where none flew. */
static uint32_t rate_of(uint64_t hits, uint64_t flown)
{
    return flown ? (uint32_t)(hits * 60 * 60 * 10 / flown) : 0;
}

uint32_t bots_rate(const struct bots *b)
{
    return rate_of(bots_hits(b), bots_flown(b));
}

uint32_t bots_rate_of(const struct bots *b, enum bot_kind kind)
{
    return rate_of(b->hits[kind], b->flown[kind]);
}

uint32_t bots_hits(const struct bots *b)
{
    return b->hits[BOT_STAND] + b->hits[BOT_WANDER] + b->hits[BOT_DODGE];
}

uint32_t bots_flown(const struct bots *b)
{
    return b->flown[BOT_STAND] + b->flown[BOT_WANDER] + b->flown[BOT_DODGE];
}

int bots_all(const struct bots *b)
{
    return b->n[BOT_STAND] + b->n[BOT_WANDER] + b->n[BOT_DODGE];
}

int bots_lived(const struct bots *b)
{
    return b->lived[BOT_STAND] + b->lived[BOT_WANDER] + b->lived[BOT_DODGE];
}

uint32_t bots_mean(const struct bots *b)
{
    return bots_all(b) ? b->frames / (uint32_t)bots_all(b) : 0;
}

void bots_compare(const struct bots *easier, const struct bots *harder, char *why, size_t size)
{
    const uint32_t rate = bots_rate(easier), then = bots_rate(harder);

    why[0] = 0;
    if (rate * 19 > then * 20)
        snprintf(why, size, "%u.%u hits per minute, compared with %u.%u", (unsigned)(rate / 10), (unsigned)(rate % 10),
                 (unsigned)(then / 10), (unsigned)(then % 10));
}
